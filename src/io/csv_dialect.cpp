#include "io/csv_dialect.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "io/text.hpp"

namespace bioprint {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Calls `visit` for each byte of `text` outside quotes; stops when it returns false. The place it stopped
/// at.
template <typename Visit>
std::size_t outside_quotes(std::string_view text, Visit visit) {
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"') {
            quoted = !quoted;
        } else if (!quoted && !visit(text[i])) {
            return i;
        }
    }
    return text.size();
}

std::string_view first_line(std::string_view text) {
    return text.substr(0, outside_quotes(text, [](char c) { return c != '\n' && c != '\r'; }));
}

std::string_view after_line(std::string_view text) {
    text.remove_prefix(first_line(text).size());
    const std::size_t next = text.find_first_not_of("\r\n");
    return next == std::string_view::npos ? std::string_view{} : text.substr(next);
}

std::string detect_line_end(std::string_view text, bool at_end) {
    const std::size_t end = first_line(text).size();
    if (end == text.size() || text[end] == '\n') return "\n";
    if (end + 1 < text.size()) return text[end + 1] == '\n' ? "\r\n" : "\r";
    return at_end ? "\r" : "\r\n";
}

char detect_separator(std::string_view text) {
    const auto header = first_line(text);
    const auto row = first_line(after_line(text));
    const auto count = [](std::string_view line, char separator) {
        long found = 0;
        outside_quotes(line, [&](char c) {
            found += c == separator ? 1 : 0;
            return true;
        });
        return found;
    };
    char best = ',';
    long best_score = 0;
    for (const char candidate : {';', '\t', ','}) {
        const long in_header = count(header, candidate);
        if (in_header == 0) continue;
        constexpr long agreement = 1'000'000;  // a first row of as many fields outweighs any count
        const long score = in_header + (count(row, candidate) == in_header ? agreement : 0);
        if (score > best_score) {
            best_score = score;
            best = candidate;
        }
    }
    return best;
}

/// The mark of a field that starts with a number with decimals; 0 when it does not.
char decimal_mark(std::string_view field) {
    std::size_t i = field.find_first_not_of(" \"+-");
    if (i == std::string_view::npos || !is_digit(field[i])) return '\0';
    while (i < field.size() && is_digit(field[i])) ++i;
    if (i + 1 >= field.size() || (field[i] != ',' && field[i] != '.') || !is_digit(field[i + 1])) return '\0';
    const char mark = field[i++];
    while (i < field.size() && is_digit(field[i])) ++i;
    const bool more = i < field.size() && (field[i] == ',' || field[i] == '.');  // a list or thousands
    return more ? '\0' : mark;
}

bool detect_decimal_comma(std::string_view text, char separator) {
    if (separator == ',') return false;
    long commas = 0;
    long points = 0;
    const std::array<char, 3> ends = {separator, '\n', '\r'};
    while (!text.empty()) {
        const std::size_t end =
            std::min(text.find_first_of(std::string_view(ends.data(), ends.size())), text.size());
        const char mark = decimal_mark(text.substr(0, end));
        commas += mark == ',' ? 1 : 0;
        points += mark == '.' ? 1 : 0;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return commas > points;
}

}  // namespace

CsvHead detect_csv(std::string_view head, bool at_end) {
    CsvHead result;
    auto& dialect = result.dialect;
    dialect.byte_order_mark = head.starts_with(byte_order_mark);
    if (dialect.byte_order_mark) result.preamble = byte_order_mark.size();
    std::string_view text = head.substr(result.preamble);
    dialect.line_end = detect_line_end(text, at_end);
    const auto line = first_line(text);
    if (line.size() == 5 && lower_case(line.substr(0, 4)) == "sep=") {
        dialect.separator = line[4];
        const std::size_t end = std::min(text.size(), line.size() + dialect.line_end.size());
        result.preamble += end;
        text.remove_prefix(end);
    } else {
        dialect.separator = detect_separator(text);
    }
    dialect.decimal_comma = detect_decimal_comma(after_line(text), dialect.separator);
    return result;
}

std::string_view refusal_of_csv(std::string_view head) {
    if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) {
        return "is UTF-16 text; save it as CSV UTF-8";
    }
    if (head.starts_with("PK\x03\x04")) return "is a workbook or an archive; save the sheet as CSV UTF-8";
    constexpr std::size_t looked_at = 64;
    if (head.substr(0, looked_at).find('\0') != std::string_view::npos) {
        return "holds NUL bytes, so it is UTF-16 or no text; save it as CSV UTF-8";
    }
    return {};
}

}  // namespace bioprint
