#pragma once

#include <span>
#include <string>
#include <string_view>

/// Helpers for messages that quote what a user wrote.
namespace bioprint {

/// `text` in single quotes, safe to print and to put into JSON: control characters and bytes that are not
/// UTF-8 are written as \xNN, anything past 60 bytes is cut and marked with "...".
std::string in_quotes(std::string_view text);

/// `text` without its ASCII spaces, tabs and Unicode no-break, narrow and thin spaces at both ends.
std::string_view trimmed(std::string_view text);

/// How many bytes of white space (of the kinds `trimmed` knows) `text` starts with.
std::size_t leading_space(std::string_view text);

/// The candidate with the fewest edits from `word`, letters compared without case and a differing case
/// counted as less than one edit; empty when none is near (more than a third of the word, and more than one
/// letter, wrong).
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// The length of the UTF-8 sequence at the start of `text`: 1 to 4, or 0 when it is not valid UTF-8.
std::size_t utf8_length(std::string_view text);

/// An ASCII digit, whatever the locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// ASCII letters in lower case, every other byte as it is.
std::string lower_case(std::string_view text);

}  // namespace bioprint
