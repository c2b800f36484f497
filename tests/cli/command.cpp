#include "cli/command.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace bioprint::test {
namespace {

namespace fs = std::filesystem;

class Scratch {
  public:
    Scratch() : path_(fs::temp_directory_path() / ("bioprint-test-" + std::to_string(getpid()))) {
        fs::create_directories(path_);
    }
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

const fs::path& scratch() {
    static const Scratch directory;
    return directory.path();
}

std::string slurp(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace

void write_scratch(const std::string& name, std::string_view content) {
    std::ofstream(scratch() / name, std::ios::binary) << content;
}

std::string read_scratch(const std::string& name) {
    return slurp(scratch() / name);
}

bool scratch_exists(const std::string& name) {
    return fs::exists(scratch() / name);
}

Outcome run(const std::string& arguments, std::string_view input) {
    write_scratch(".stdin", input);
    const std::string command = "cd '" + scratch().string() + "' && '" BIOPRINT_PROGRAM "' " + arguments +
                                " <.stdin >.stdout 2>.stderr";
    const int status = std::system(command.c_str());
    return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            .out = read_scratch(".stdout"),
            .err = read_scratch(".stderr")};
}

}  // namespace bioprint::test
