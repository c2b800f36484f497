#include "io/run_directory.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "io/answer_object.hpp"
#include "io/byte_source.hpp"
#include "io/whole_file.hpp"

namespace bioprint {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view run_format = "bioprint-run/1";
constexpr const char* question_file = "question.json";
constexpr const char* checkpoint_file = "checkpoint.cbor";
constexpr const char* lock_file = "lock";
constexpr const char* ink_copy = "ink.json";

std::string reason(int error) {
    return std::generic_category().message(error);
}

struct FileSum {
    unsigned long long size = 0;
    unsigned long long sum = checksum_start;
};

/// Size and checksum of a file; its bytes go to `copy` as well.
FileSum sum_of(const std::string& path, WholeFile* copy = nullptr) {
    const auto source = open_bytes(path);
    std::vector<char> piece(std::size_t{1} << 20U);
    FileSum result;
    while (const std::size_t count = source->read(piece.data(), piece.size())) {
        const std::string_view bytes(piece.data(), count);
        result.size += count;
        result.sum = checksum(bytes, result.sum);
        if (copy != nullptr) copy->write(bytes);
    }
    return result;
}

bool is_ink_file(const TypedOption& option) {
    return option.name == "--ink" &&
           (option.text.find('/') != std::string::npos || option.text.ends_with(".json"));
}

/// What must be there unchanged when the run goes on.
Json remember_files(const RunDirectory& directory, const TypedQuestion& question) {
    Json files = Json::array();
    for (const TypedOption& option : question) {
        if (is_ink_file(option)) {
            WholeFile copy(directory.file(ink_copy));
            sum_of(option.text, &copy);
            copy.commit();
            files.push_back({{"option", option.name}, {"copy", ink_copy}});
        } else if (option.name == "--batch") {
            const FileSum sum = sum_of(option.text);
            files.push_back({{"option", option.name},
                             {"path", fs::absolute(option.text).string()},
                             {"size", sum.size},
                             {"checksum", sum.sum}});
        }
    }
    return files;
}

Json read_question(const std::string& directory) {
    const std::string path = directory + "/" + question_file;
    if (!fs::exists(path)) {
        throw UsageError("--resume: " + directory + " holds no run; begin one with --out", "--resume");
    }
    const auto source = open_bytes(path);
    std::string text;
    std::vector<char> piece(std::size_t{1} << 16U);
    while (const std::size_t count = source->read(piece.data(), piece.size()))
        text.append(piece.data(), count);
    Json question = Json::parse(text, nullptr, false);
    if (!question.is_object() || question.value("format", "") != run_format) {
        throw DataError(path + ": is not the question of a run; begin another run with --out");
    }
    return question;
}

template <class Work>
auto reading(const std::string& directory, const Work& work) {
    const Json question = read_question(directory);
    try {
        return work(question);
    } catch (const Json::exception&) {
        throw DataError(directory + "/" + question_file + ": is damaged; begin another run with --out");
    }
}

}  // namespace

std::string shell_word(std::string_view path) {
    const bool plain = !path.empty() && std::all_of(path.begin(), path.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("/._-+:@%").find(c) != std::string_view::npos;
    });
    if (plain) return std::string(path);
    std::string word = "'";
    for (const char c : path) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

TypedQuestion question_in(const std::string& directory) {
    return reading(directory, [](const Json& question) {
        TypedQuestion typed;
        for (const Json& option : question.at("options"))
            typed.push_back({option.at(0).get<std::string>(), option.at(1).get<std::string>()});
        return typed;
    });
}

TypedQuestion lasting_question_in(const std::string& directory) {
    TypedQuestion typed = question_in(directory);
    reading(directory, [&](const Json& question) {
        for (const Json& file : question.at("files")) {
            const std::string name = file.at("option").get<std::string>();
            const auto option = std::find_if(typed.begin(), typed.end(),
                                             [&](const TypedOption& o) { return o.name == name; });
            if (option == typed.end()) continue;
            if (file.contains("copy")) {
                option->text = fs::absolute(directory + "/" + file["copy"].get<std::string>()).string();
                continue;
            }
            option->text = file.at("path").get<std::string>();
            const FileSum now = sum_of(option->text);
            if (now.size != file.at("size") || now.sum != file.at("checksum")) {
                throw DataError(option->text + ": has changed since the run in " + directory +
                                " began; restore it, or begin another run with --out");
            }
        }
        return 0;
    });
    return typed;
}

RunDirectory::RunDirectory(std::string path, bool made) : path_(std::move(path)), made_(made) {}

RunDirectory::RunDirectory(RunDirectory&& other) noexcept
    : path_(std::move(other.path_)),
      made_(other.made_),
      new_(other.new_),
      lock_(std::exchange(other.lock_, -1)) {}

RunDirectory::~RunDirectory() {
    if (lock_ >= 0) ::close(lock_);
}

void RunDirectory::lock() {
    constexpr mode_t everyone = 0666;
    lock_ = ::open(file(lock_file).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, everyone);
    if (lock_ < 0) {
        const int error = errno;
        throw DataError(path_ + ": cannot be written: " + reason(error) +
                        (error == EACCES || error == EROFS ? "; choose a place you may write to" : ""));
    }
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        throw DataError(path_ + ": another run is at work there; wait for it, or name another directory");
    }
}

RunDirectory RunDirectory::begin(const std::string& path, const TypedQuestion& question) {
    std::error_code error;
    const bool made = fs::create_directory(path, error);
    if (error && !fs::is_directory(path)) {
        const bool parent = error == std::errc::no_such_file_or_directory;
        throw DataError(path + ": cannot be made: " + error.message() +
                        (parent ? "; create the directory above it first" : ""));
    }
    RunDirectory directory(path, made);
    directory.lock();
    if (fs::exists(directory.file(question_file))) {
        throw UsageError("--out: " + path + " holds a run already; --resume " + shell_word(path) +
                             " goes on with it, or name another directory",
                         "--out");
    }
    for (const auto& entry : fs::directory_iterator(path)) {
        const fs::path name = entry.path().filename();
        if (name != lock_file && name != ink_copy && name.extension() != ".part") {
            throw UsageError("--out: " + path + " holds other files; name a new or an empty directory",
                             "--out");
        }
    }
    Json options = Json::array();
    for (const TypedOption& option : question) options.push_back({option.name, option.text});
    try {
        const Json text = {{"format", run_format},
                           {"program", {{"name", program_name}, {"version", program_version()}}},
                           {"options", options},
                           {"files", remember_files(directory, question)}};
        WholeFile file(directory.file(question_file));
        file.write(text.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
        file.commit();
    } catch (...) {
        directory.abandon();
        throw;
    }
    return directory;
}

RunDirectory RunDirectory::take_up(const std::string& path) {
    question_in(path);
    RunDirectory directory(path, false);
    directory.new_ = false;
    directory.lock();
    // What a process that was killed had not yet put in its place.
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(path)) {
        if (entry.path().extension() == ".part") fs::remove(entry.path(), ignored);
    }
    return directory;
}

std::optional<CheckpointParts> RunDirectory::checkpoint() const {
    if (!fs::exists(file(checkpoint_file))) return std::nullopt;
    return read_checkpoint(file(checkpoint_file));
}

void RunDirectory::keep(const CheckpointParts& parts, const CheckpointParts& more) {
    write_checkpoint(file(checkpoint_file), parts, more);
    new_ = false;
}

void RunDirectory::abandon() {
    if (!new_) return;
    std::error_code ignored;
    for (const char* name : {question_file, ink_copy, lock_file, "answers.unfinished"})
        fs::remove(file(name), ignored);
    if (made_) fs::remove(path_, ignored);
}

}  // namespace bioprint
