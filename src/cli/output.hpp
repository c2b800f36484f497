#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

/// Standard output, or a file that is written whole or not at all.
namespace bioprint {

class WholeFile;

class Output {
  public:
    /// @throws DataError  the file cannot be created
    explicit Output(const std::optional<std::string>& file);
    ~Output();
    Output(const Output&) = delete;
    Output& operator=(const Output&) = delete;

    /// @throws DataError  what was written did not arrive
    void write(std::string_view text);
    void flush();
    /// Makes a file appear; without it, it never does.
    void commit();
    [[nodiscard]] bool to_file() const { return file_ != nullptr; }

  private:
    std::unique_ptr<WholeFile> file_;
};

}  // namespace bioprint
