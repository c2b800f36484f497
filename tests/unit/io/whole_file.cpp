#include "io/whole_file.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "bioprint/errors.hpp"

using namespace bioprint;
namespace fs = std::filesystem;

namespace {

/// A directory of its own, removed at the end.
class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "bioprint-XXXXXX").string();
        REQUIRE(::mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] fs::path operator/(const char* name) const { return path_ / name; }
    [[nodiscard]] auto count() const {
        return std::distance(fs::directory_iterator(path_), fs::directory_iterator());
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

std::string content(const fs::path& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

void put(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string refusal(const fs::path& path) {
    try {
        WholeFile file(path.string());
        file.write("x");
        file.commit();
    } catch (const DataError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("whole file: nothing changes before the commit and everything with it") {
    const Scratch scratch;
    put(scratch / "a", "old");
    const std::string large(300000, 'x');
    {
        WholeFile file((scratch / "a").string());
        file.write("new");
        file.write(large);
        file.flush();
        CHECK(content(scratch / "a") == "old");
        file.commit();
    }
    CHECK(content(scratch / "a") == "new" + large);
    CHECK(scratch.count() == 1);
}

TEST_CASE("whole file: without a commit nothing remains") {
    const Scratch scratch;
    put(scratch / "a", "old");
    {
        WholeFile replaced((scratch / "a").string());
        WholeFile created((scratch / "b").string());
        replaced.write("new");
        created.write("new");
    }
    CHECK(content(scratch / "a") == "old");
    CHECK(scratch.count() == 1);
}

TEST_CASE("whole file: a symbolic link stays one and its target is written") {
    const Scratch scratch;
    fs::create_directory(scratch / "real");
    put(scratch / "real/a", "old");
    fs::create_symlink("real/a", scratch / "link");
    fs::create_symlink("link", scratch / "second");
    fs::create_symlink("real/b", scratch / "dangling");
    CHECK(refusal(scratch / "second") == "accepted");
    CHECK(refusal(scratch / "dangling") == "accepted");
    CHECK(fs::is_symlink(scratch / "link"));
    CHECK(fs::is_symlink(scratch / "second"));
    CHECK(content(scratch / "real/a") == "x");
    CHECK(content(scratch / "real/b") == "x");
    fs::create_symlink("loop", scratch / "loop");
    CHECK(refusal(scratch / "loop").find("symbolic links") != std::string::npos);
}

TEST_CASE("whole file: permissions of an existing file are kept and a new one follows the umask") {
    const Scratch scratch;
    put(scratch / "a", "old");
    fs::permissions(scratch / "a", fs::perms{0640});
    CHECK(refusal(scratch / "a") == "accepted");
    CHECK(fs::status(scratch / "a").permissions() == fs::perms{0640});
    const auto mask = ::umask(0027);
    CHECK(refusal(scratch / "b") == "accepted");
    ::umask(mask);
    CHECK(fs::status(scratch / "b").permissions() == fs::perms{0640});
}

TEST_CASE("whole file: a place that cannot be written is named with the cause and a remedy") {
    const Scratch scratch;
    CHECK(refusal(scratch.path()).find("Is a directory; name a file in it") != std::string::npos);
    CHECK(refusal(scratch / "missing/a").find("No such file or directory; create the directory first") !=
          std::string::npos);
    put(scratch / "file", "");
    CHECK(refusal(scratch / "file/a").find("no directory") != std::string::npos);
    CHECK(refusal(scratch / "dir/") != "accepted");
    CHECK(refusal("") != "accepted");
    CHECK(refusal(scratch / std::string(300, 'n').c_str()).find("shorter name") != std::string::npos);
    CHECK(scratch.count() == 1);
    if (::geteuid() != 0) {  // root may write anywhere
        fs::permissions(scratch / "file", fs::perms{0400});
        CHECK(refusal(scratch / "file").find("choose a place you may write to") != std::string::npos);
    }
}

TEST_CASE("whole file: a full device is an error with a remedy") {
    CHECK(refusal("/dev/full").find("No space left on device; make room") != std::string::npos);
}

TEST_CASE("whole file: devices and pipes are written directly") {
    CHECK(refusal("/dev/null") == "accepted");
    CHECK(fs::is_character_file("/dev/null"));
    const Scratch scratch;
    REQUIRE(::mkfifo((scratch / "pipe").c_str(), 0600) == 0);
    std::fstream reader(scratch / "pipe", std::ios::in | std::ios::out);
    CHECK(refusal(scratch / "pipe") == "accepted");
    CHECK(reader.get() == 'x');
    CHECK(fs::is_fifo(scratch / "pipe"));
}
