#pragma once

#include <string>
#include <string_view>

/// A file that appears whole or not at all.
///
/// Bytes go to a file without a name in the target's directory; `commit` syncs it to the disk and puts it in the
/// target's place, so a reader sees the old content or the new, never a part. Without `commit` nothing remains, even
/// of a process that was killed. (A file system that knows no nameless files gets one that ends in .part, which a
/// kill leaves behind.) A symbolic link stays a link and its target is written; permissions of an existing file are kept. Devices,
/// pipes and the process's own streams
/// (/dev/stdout, /dev/fd/N, "-") cannot be replaced and are written as the bytes come.
namespace bioprint {

class WholeFile {
  public:
    /// @throws DataError  the place cannot be written; the message names the cause and a remedy
    explicit WholeFile(const std::string& path);
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;
    ~WholeFile();

    /// @throws DataError  e.g. a full disk; nothing of the target has changed then
    void write(std::string_view bytes);
    /// Hands over what is written so far to the operating system; for output that someone reads along.
    void flush();
    /// Puts the file in its place. At most once, last.
    /// @throws DataError
    void commit();

  private:
    void open_directly(const std::string& path);
    void open_temporary();
    [[nodiscard]] bool open_nameless();
    [[nodiscard]] std::string open_place() const;
    void take_attributes();
    void link_nameless();
    void write_through(std::string_view bytes);
    void discard();
    [[noreturn]] void fail(int error);

    std::string path_;       ///< as the user wrote it
    std::string target_;     ///< behind symbolic links; empty when written directly
    std::string temporary_;  ///< empty when written directly, nameless or done
    bool nameless_ = false;
    std::string pending_;
    int file_ = -1;
    bool owns_file_ = true;
};

}  // namespace bioprint
