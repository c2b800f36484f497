#include "io/byte_source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "bioprint/errors.hpp"

namespace bioprint {

namespace {

constexpr std::size_t piece_size = std::size_t{1} << 16U;

class FileBytes : public ByteSource {
  public:
    explicit FileBytes(std::string path) : path_(std::move(path)) {
        if (path_ == "-") {
            path_ = "standard input";
            file_ = STDIN_FILENO;
            return;
        }
        file_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
        if (file_ < 0) fail(errno);
        struct stat info {};
        if (::fstat(file_, &info) == 0 && S_ISDIR(info.st_mode)) {
            ::close(file_);
            fail(EISDIR);
        }
    }
    ~FileBytes() override {
        if (file_ != STDIN_FILENO) ::close(file_);
    }
    FileBytes(const FileBytes&) = delete;
    FileBytes& operator=(const FileBytes&) = delete;

    std::size_t read(char* into, std::size_t size) override {
        for (;;) {
            const ssize_t count = ::read(file_, into, size);
            if (count >= 0) return static_cast<std::size_t>(count);
            if (errno != EINTR) fail(errno);
        }
    }

  private:
    [[noreturn]] void fail(int error) const {
        throw DataError(path_ + ": cannot be read: " + std::generic_category().message(error));
    }
    std::string path_;
    int file_ = -1;
};

}  // namespace

std::unique_ptr<ByteSource> open_bytes(const std::string& path) {
    return std::make_unique<FileBytes>(path);
}

std::size_t MemoryBytes::read(char* into, std::size_t size) {
    const std::size_t count = std::min({size, piece_, bytes_.size()});
    if (count > 0) std::memcpy(into, bytes_.data(), count);
    bytes_.remove_prefix(count);
    return count;
}

bool InputBuffer::more() {
    if (at_end_) return false;
    if (start_ > 0) {
        std::memmove(bytes_.data(), bytes_.data() + start_, end_ - start_);
        end_ -= start_;
        start_ = 0;
    }
    if (bytes_.size() - end_ < piece_size) bytes_.resize(std::max(2 * piece_size, 2 * bytes_.size()));
    const std::size_t count = source_.read(bytes_.data() + end_, piece_size);
    end_ += count;
    at_end_ = count == 0;
    return !at_end_;
}

}  // namespace bioprint
