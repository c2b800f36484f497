#include "io/number_columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "io/text.hpp"

namespace bioprint {
namespace {

/// Removes the marks between thousands where the number has them; false where they are misplaced.
bool without_thousands(std::string& number, char mark, char decimal) {
    const std::size_t whole_end =
        std::min(number.find_first_of(std::string{decimal, 'e', 'E'}), number.size());
    const std::size_t first = number.find(mark);
    if (first == std::string::npos) return true;
    const std::size_t sign = !number.empty() && (number[0] == '-' || number[0] == '+') ? 1 : 0;
    // 0,123 has no thousands; nor has anything after the decimal mark.
    if (first == sign || first - sign > 3 || number[sign] == '0' || first > whole_end) return false;
    std::string joined = number.substr(0, first);
    for (std::size_t at = first; at < whole_end; at += 4) {
        if (number[at] != mark || at + 4 > whole_end) return false;
        const std::string group = number.substr(at + 1, 3);
        if (!std::all_of(group.begin(), group.end(), is_digit)) return false;
        joined += group;
    }
    joined += number.substr(whole_end);
    if (joined.find(mark) != std::string::npos) return false;
    number = joined;
    return true;
}

std::optional<double> from_text(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    // from_chars reads "inf" and "nan" too
    const std::size_t first = text.starts_with('-') ? 1 : 0;
    if (first >= text.size() || !(is_digit(text[first]) || text[first] == '.')) return {};
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return {};
    // What a double cannot hold is no measurement.
    if (error != std::errc{} || !std::isfinite(value)) return {};
    return value;
}

struct Candidate {
    ColumnStyle style;
    double score;
};

double score_of(const std::vector<std::string_view>& lines, ColumnStyle style) {
    constexpr std::size_t enough_rows = 300;
    std::vector<std::string_view> fields;
    double score = 0.0;
    std::size_t rows = 0;
    for (const std::string_view line : lines) {
        split_fields(line, style.separator, fields);
        double numbers = 0.0;
        double others = 0.0;
        for (const std::string_view field : fields) {
            if (field.empty()) continue;
            if (parse_field(field, style.decimal_comma)) {
                // A mark between thousands is a guess less likely than a decimal one.
                const bool other_mark = field.find(style.decimal_comma ? '.' : ',') != std::string_view::npos;
                numbers += other_mark ? 0.9 : 1.0;
            } else if (!is_missing(field)) {
                others += 1.0;
            }
        }
        if (numbers < 1.8) continue;
        const double share = numbers / (numbers + others);
        score += share * share;
        if (++rows == enough_rows) break;
    }
    return score;
}

}  // namespace

void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    if (separator == ' ') {
        std::string_view rest = trimmed(line);
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
            fields.push_back(rest.substr(0, end));
            rest = trimmed(rest.substr(end));
        }
        return;
    }
    std::size_t at = 0;
    for (;;) {
        std::size_t end = at;
        // A field in quotes may hold the separator.
        const std::size_t first = line.find_first_not_of(' ', at);
        if (first != std::string_view::npos && line[first] == '"') {
            const std::size_t close = line.find('"', first + 1);
            if (close != std::string_view::npos) end = close;
        }
        end = std::min(line.find(separator, end), line.size());
        std::string_view field = trimmed(line.substr(at, end - at));
        if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
            field = trimmed(field.substr(1, field.size() - 2));
        }
        fields.push_back(field);
        if (end == line.size()) return;
        at = end + 1;
    }
}

std::optional<double> parse_field(std::string_view field, bool decimal_comma) {
    constexpr std::string_view minus = "\u2212";
    constexpr std::size_t longest = 64;
    if (field.empty() || field.size() > longest) return {};
    const char decimal = decimal_comma ? ',' : '.';
    const char thousands = decimal_comma ? '.' : ',';
    if (!decimal_comma && field.find(thousands) == std::string_view::npos && !field.starts_with(minus)) {
        return from_text(field);
    }
    std::string number(field);
    if (field.starts_with(minus)) number = "-" + std::string(field.substr(minus.size()));
    if (!without_thousands(number, thousands, decimal)) return {};
    if (decimal_comma) {
        const std::size_t comma = number.find(',');
        if (comma != std::string::npos) number[comma] = '.';
    }
    return from_text(number);
}

bool is_missing(std::string_view field) {
    static constexpr std::array<std::string_view, 16> words = {
        "-",    "--",   "---", "n/a",     "na",   "nan",  "inf", "-inf",
        "+inf", "#n/a", "#nv", "#div/0!", "null", "none", "?",   "*"};
    constexpr std::size_t longest = 8;
    if (field.empty() || field.size() > longest) return false;
    const std::string word = lower_case(field);
    return std::find(words.begin(), words.end(), word) != words.end();
}

ColumnStyle detect_column_style(const std::vector<std::string_view>& lines) {
    static constexpr std::array<ColumnStyle, 7> styles = {
        {{'\t', false}, {'\t', true}, {';', false}, {';', true}, {',', false}, {' ', false}, {' ', true}}};
    ColumnStyle best = styles.front();
    double highest = 0.0;
    for (const ColumnStyle style : styles) {
        const double score = score_of(lines, style);
        if (score <= highest) continue;
        highest = score;
        best = style;
    }
    return best;
}

std::string_view separator_name(char separator) {
    switch (separator) {
        case '\t':
            return "tab";
        case ';':
            return "semicolon";
        case ',':
            return "comma";
        default:
            return "blank";
    }
}

}  // namespace bioprint
