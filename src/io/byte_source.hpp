#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Where the bytes of a batch come from, and the window through which its readers see them.
namespace bioprint {

class ByteSource {
  public:
    ByteSource() = default;
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;
    /// Up to `size` bytes into `into`; 0 only at the end.
    /// @throws DataError
    virtual std::size_t read(char* into, std::size_t size) = 0;
};

/// A file, or standard input for "-".
/// @throws DataError  it cannot be opened
std::unique_ptr<ByteSource> open_bytes(const std::string& path);

/// Bytes in memory, handed out in pieces of at most `piece`.
class MemoryBytes : public ByteSource {
  public:
    explicit MemoryBytes(std::string_view bytes, std::size_t piece = static_cast<std::size_t>(-1))
        : bytes_(bytes), piece_(piece) {}
    std::size_t read(char* into, std::size_t size) override;

  private:
    std::string_view bytes_;
    std::size_t piece_;
};

/// The bytes of a source that have been read and not yet dropped. Memory stays at the longest stretch kept at
/// once plus two pieces of 64 KiB.
class InputBuffer {
  public:
    explicit InputBuffer(ByteSource& source) : source_(source) {}
    [[nodiscard]] std::string_view rest() const { return {bytes_.data() + start_, end_ - start_}; }
    [[nodiscard]] bool at_end() const { return at_end_; }
    /// Reads on; false when the source is at its end. Views into `rest()` are void afterwards.
    bool more();
    void drop(std::size_t count) { start_ += count; }

  private:
    ByteSource& source_;
    std::vector<char> bytes_;
    std::size_t start_ = 0;
    std::size_t end_ = 0;
    bool at_end_ = false;
};

}  // namespace bioprint
