#pragma once

#include <string>
#include <string_view>

/// Text files as instruments and spreadsheets leave them, in UTF-8.
///
/// Known are UTF-8 and UTF-16 (either byte order) with or without a byte order mark, and Windows-1252 for what is
/// valid in none of them. The line ends are left as they are.
namespace bioprint {

struct DecodedText {
    std::string text;           ///< UTF-8, without a byte order mark
    std::string_view encoding;  ///< "UTF-8", "UTF-16LE", "UTF-16BE" or "Windows-1252"
};

/// @throws UsageError  the bytes are those of a workbook, a PDF, … or of no text; the message says what to save instead
DecodedText decode_text(std::string bytes, const std::string& name);

/// A whole file, or standard input for "-".
/// @throws DataError   it cannot be read
/// @throws UsageError  as `decode_text`, or it is larger than 1 GiB
DecodedText read_text_file(const std::string& path);

}  // namespace bioprint
