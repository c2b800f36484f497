#include "io/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "bioprint/errors.hpp"

namespace bioprint {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16U;
constexpr int largest_chain_of_links = 40;
constexpr int name_attempts = 1000;
constexpr mode_t everyone = 0666;  // less the umask, as for any new file

namespace fs = std::filesystem;

std::string_view remedy(int error) {
    switch (error) {
        case ENOSPC:
        case EDQUOT:
            return "make room or write elsewhere";
        case EACCES:
        case EPERM:
            return "choose a place you may write to";
        case EROFS:
            return "the file system is read-only; choose another place";
        case ENOENT:
            return "create the directory first";
        case ENOTDIR:
            return "a part of the path is no directory";
        case EISDIR:
            return "name a file in it";
        case ENAMETOOLONG:
            return "choose a shorter name";
        case ELOOP:
            return "the symbolic links lead nowhere";
        case EFBIG:
            return "the file would be larger than allowed here";
        default:
            return "";
    }
}

/// The process's own streams, which must not be replaced even when they are files.
bool is_own_stream(const std::string& path) {
    return path == "-" || path == "/dev/stdout" || path == "/dev/stderr" || path.starts_with("/dev/fd/") ||
           path.starts_with("/proc/");
}

/// The place a chain of symbolic links ends at, whether it exists or not; empty for a loop.
fs::path behind_links(fs::path path) {
    for (int i = 0; i < largest_chain_of_links; ++i) {
        std::error_code error;
        const fs::path next = fs::read_symlink(path, error);
        if (error) return path;
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return {};
}

}  // namespace

WholeFile::WholeFile(const std::string& path) : path_(path) {
    pending_.reserve(buffer_size);
    if (path_.empty()) fail(ENOENT);
    if (is_own_stream(path_)) {
        open_directly(path_);
        return;
    }
    const fs::path target = behind_links(path_);
    if (target.empty()) fail(ELOOP);
    struct stat info {};
    if (::stat(target.c_str(), &info) == 0) {
        if (S_ISDIR(info.st_mode)) fail(EISDIR);
        if (!S_ISREG(info.st_mode)) {
            open_directly(target);
            return;
        }
        if (::access(target.c_str(), W_OK) != 0) fail(errno);
    } else if (errno != ENOENT) {
        fail(errno);
    } else if (path_.back() == '/') {
        fail(EISDIR);
    }
    target_ = target;
    open_temporary();
}

void WholeFile::open_directly(const std::string& path) {
    if (path == "-" || path == "/dev/stdout") {
        file_ = STDOUT_FILENO;
        owns_file_ = false;
        return;
    }
    file_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) fail(errno);
}

std::string WholeFile::open_place() const {
    return "/proc/self/fd/" + std::to_string(file_);
}

bool WholeFile::open_nameless() {
    const fs::path directory = fs::path(target_).parent_path();
    file_ = ::open(directory.empty() ? "." : directory.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, everyone);
    if (file_ < 0) return false;  // the file system does not know it, or fails in the same way below
    // A name is given to it through /proc, which a sandbox may lack.
    if (::access(open_place().c_str(), F_OK) == 0) return true;
    ::close(file_);
    file_ = -1;
    return false;
}

void WholeFile::open_temporary() {
    nameless_ = open_nameless();
    if (nameless_) return take_attributes();
    const std::string base = target_ + "." + std::to_string(::getpid()) + ".";
    for (int i = 0; i < name_attempts && file_ < 0; ++i) {
        temporary_ = base + std::to_string(i) + ".part";
        file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everyone);
        if (file_ < 0 && errno != EEXIST) break;
    }
    if (file_ < 0) {
        const int error = errno;
        temporary_.clear();
        fail(error);
    }
    take_attributes();
}

void WholeFile::take_attributes() {
    constexpr mode_t permission_bits = 07777;
    struct stat info {};
    if (::stat(target_.c_str(), &info) != 0) return;
    // The owner first: changing it clears special bits. Only root may; anyone else's file becomes the
    // writer's.
    if (::fchown(file_, info.st_uid, info.st_gid) != 0) errno = 0;
    if (::fchmod(file_, info.st_mode & permission_bits) != 0) fail(errno);
}

WholeFile::~WholeFile() {
    discard();
}

void WholeFile::discard() {
    if (file_ >= 0 && owns_file_) ::close(file_);
    file_ = -1;
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
    temporary_.clear();
}

void WholeFile::fail(int error) {
    discard();
    std::string message = (path_.empty()  ? std::string("''")
                           : path_ == "-" ? "standard output"
                                          : path_) +
                          ": cannot be written: " + std::generic_category().message(error);
    const auto advice = remedy(error);
    if (!advice.empty()) message.append("; ").append(advice);
    throw DataError(message);
}

void WholeFile::write(std::string_view bytes) {
    if (pending_.size() + bytes.size() > buffer_size) flush();
    if (bytes.size() >= buffer_size) {
        write_through(bytes);
    } else {
        pending_ += bytes;
    }
}

void WholeFile::flush() {
    write_through(pending_);
    pending_.clear();
}

void WholeFile::write_through(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

/// Names the file after its target or, where there is one to replace, next to it.
void WholeFile::link_nameless() {
    const auto link = [&](const std::string& name) {
        return ::linkat(AT_FDCWD, open_place().c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    nameless_ = false;
    if (link(target_)) return;
    const std::string base =
        (fs::path(target_).parent_path() / ("." + std::to_string(::getpid()) + ".")).string();
    for (int i = 0; errno == EEXIST && i < name_attempts; ++i) {
        const std::string name = base + std::to_string(i) + ".part";
        if (link(name)) {
            temporary_ = name;
            return;
        }
    }
    fail(errno);
}

void WholeFile::commit(Sync sync) {
    flush();
    if (temporary_.empty() && !nameless_) {
        if (owns_file_ && ::close(file_) != 0) {
            file_ = -1;
            fail(errno);
        }
        file_ = -1;
        return;
    }
    if (sync == Sync::disk && ::fsync(file_) != 0) fail(errno);
    if (nameless_) link_nameless();
    const int closed = ::close(file_);
    file_ = -1;
    if (closed != 0) fail(errno);
    if (!temporary_.empty() && ::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
    temporary_.clear();
    if (sync == Sync::none) return;
    // The name is in place; a directory that cannot be synced is no failure of the file.
    const fs::path directory = fs::path(target_).parent_path();
    const int folder =
        ::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder >= 0) {
        ::fsync(folder);
        ::close(folder);
    }
}

}  // namespace bioprint
