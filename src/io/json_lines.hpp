#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "io/byte_source.hpp"

/// JSON text with the limits a program puts on what it is handed, and a batch of it: one object a line.
namespace bioprint {

/// Depth of arrays and objects inside one another that is still read.
inline constexpr int deepest_json = 64;

/// The value in `text`. Strict JSON: no comments, no trailing commas, no NaN, valid UTF-8, no key twice in
/// one object, numbers that a double can hold, at most `deepest_json` levels.
/// @param what  names the text in errors: "presets.json", "line 7"
/// @throws UsageError
nlohmann::json parse_json(std::string_view text, const std::string& what);

/// One line of a batch. (The move of a JSON value does not throw, whatever clang-tidy makes of it.)
struct JsonLine {            // NOLINT(bugprone-exception-escape)
    std::size_t number = 0;  ///< from 1
    nlohmann::json value;    ///< an object; null when there is an error
    std::string error;       ///< empty, or what is wrong, with the line's number
};

/// Reads JSON Lines. Empty lines are skipped, so is a byte order mark. A line that is wrong, or longer than 1
/// MiB, is an error of that line alone. Memory does not grow with the file.
class JsonLinesReader {
  public:
    static constexpr std::size_t largest_line = std::size_t{1} << 20U;

    explicit JsonLinesReader(ByteSource& source) : input_(source) {}
    /// Reads the next line that is not empty; false at the end. Throws DataError only.
    bool next();
    /// The next line is here already, so that `next` need not wait for the source.
    [[nodiscard]] bool has_buffered_line() const;
    [[nodiscard]] const JsonLine& line() const { return line_; }
    [[nodiscard]] JsonLine& line() { return line_; }

  private:
    bool take_line(std::string_view& text, bool& too_long);
    InputBuffer input_;
    JsonLine line_;
    std::size_t used_ = 0;
    std::size_t count_ = 0;
};

}  // namespace bioprint
