#include "io/kept_rows.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "bioprint/errors.hpp"

namespace bioprint {
namespace {

constexpr const char* unfinished = "answers.unfinished";
constexpr const char* part_name = "rows";
constexpr std::size_t buffer_size = std::size_t{1} << 16U;

/// The checkpoint's numbers, in this order.
enum : std::size_t { read_at, rows_at, refused_at, bytes_at, finished_at, format_at, values_at_, part_size };

const char* ending(Format format, bool values) {
    if (values) return "txt";
    switch (format) {
        case Format::json:
            return "json";
        case Format::jsonl:
            return "jsonl";
        case Format::table:
        case Format::csv:
            break;
    }
    return "csv";
}

}  // namespace

KeptRows::KeptRows(RunDirectory& directory, double interval) : directory_(directory), interval_(interval) {
    if (const auto parts = directory.checkpoint()) {
        const auto found = parts->find(part_name);
        if (found == parts->end() || found->second.size() != part_size) {
            throw DataError(directory.path() + ": the checkpoint is of another kind of run");
        }
        const std::vector<double>& part = found->second;
        start_.read = static_cast<std::size_t>(part[read_at]);
        start_.rows = static_cast<std::size_t>(part[rows_at]);
        start_.refused = static_cast<std::size_t>(part[refused_at]);
        start_.format = static_cast<Format>(static_cast<int>(part[format_at]));
        values = part[values_at_] != 0.0;
        bytes_ = part[bytes_at];
        finished_ = part[finished_at] != 0.0;
    }
    if (finished_) {
        put_in_place();
    } else {
        open();
    }
}

KeptRows::~KeptRows() {
    if (file_ >= 0) ::close(file_);
}

void KeptRows::fail(const std::string& path) const {
    const int error = errno;
    std::string message = path + ": cannot be written: " + std::generic_category().message(error);
    if (error == ENOSPC || error == EDQUOT) {
        message += "; make room, then --resume " + shell_word(directory_.path());
    }
    throw DataError(message);
}

void KeptRows::open() {
    constexpr mode_t everyone = 0666;
    const std::string path = directory_.file(unfinished);
    file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, everyone);
    if (file_ < 0) fail(path);
    struct stat info {};
    if (::fstat(file_, &info) != 0) fail(path);
    if (static_cast<double>(info.st_size) < bytes_) {
        throw DataError(path + ": is shorter than the checkpoint says; remove " +
                        directory_.file("checkpoint.cbor") + " and --resume begins that run anew");
    }
    // What stands behind the checkpoint is computed again.
    if (::ftruncate(file_, static_cast<off_t>(bytes_)) != 0 || ::lseek(file_, 0, SEEK_END) < 0) fail(path);
}

void KeptRows::write(std::string_view bytes) {
    pending_ += bytes;
    if (pending_.size() >= buffer_size) flush();
}

void KeptRows::flush() {
    std::string_view rest = pending_;
    while (!rest.empty()) {
        const ssize_t count = ::write(file_, rest.data(), rest.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(directory_.file(unfinished));
        rest.remove_prefix(static_cast<std::size_t>(count));
    }
    bytes_ += static_cast<double>(pending_.size());
    pending_.clear();
}

void KeptRows::record(const RunResult& so_far) {
    flush();
    // What the checkpoint counts must be on the disk before it.
    if (::fdatasync(file_) != 0) fail(directory_.file(unfinished));
    std::vector<double> part(part_size);
    part[read_at] = static_cast<double>(so_far.read);
    part[rows_at] = static_cast<double>(so_far.rows);
    part[refused_at] = static_cast<double>(so_far.refused);
    part[bytes_at] = bytes_;
    part[finished_at] = finished_ ? 1.0 : 0.0;
    part[format_at] = static_cast<double>(so_far.format);
    part[values_at_] = values ? 1.0 : 0.0;
    directory_.keep({{part_name, part}});
    start_ = so_far;
    kept_ = std::chrono::steady_clock::now();
}

void KeptRows::keep(const RunResult& so_far) {
    if (so_far.interrupted || std::chrono::steady_clock::now() - kept_ >= interval_) record(so_far);
}

void KeptRows::finish(const RunResult& result) {
    finished_ = true;
    record(result);
    put_in_place();
}

std::string KeptRows::answers() const {
    return directory_.file(std::string("answers.") + ending(start_.format, values));
}

void KeptRows::put_in_place() const {
    const std::string from = directory_.file(unfinished);
    // A run killed right here has its name already, or gets it when it is taken up.
    if (::rename(from.c_str(), answers().c_str()) != 0 && errno != ENOENT) fail(answers());
}

}  // namespace bioprint
