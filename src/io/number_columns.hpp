#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Columns of numbers in a text of unknown make: what separates them, and how decimals are written.
namespace bioprint {

struct ColumnStyle {
    char separator = '\t';  ///< tab, semicolon, comma, or a blank for any white space
    bool decimal_comma = false;
};

/// The style under which most of the first lines are rows of numbers.
ColumnStyle detect_column_style(const std::vector<std::string_view>& lines);

/// "a tab", "a semicolon", … for messages.
std::string_view separator_name(char separator);

/// The fields of a line, without the blanks and one pair of quotes around each.
void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// A plain number, nothing else: 0.5, 1E+02, 0,5 and 1.234,5 with decimal commas, 1,234.5 without; U+2212 as minus.
std::optional<double> parse_field(std::string_view field, bool decimal_comma);

/// What instruments and spreadsheets write where there is no value: -, ---, n/a, NaN, #N/A, …
bool is_missing(std::string_view field);

}  // namespace bioprint
