#include "bioprint/io/quantity.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

#include "bioprint/errors.hpp"
#include "io/decimal.hpp"
#include "io/quantity_messages.hpp"
#include "io/text.hpp"
#include "io/units.hpp"

namespace bioprint {

namespace {

/// The common case of a file: a number alone, already trimmed, with a decimal point.
bool plain_number(std::string_view text, double& value) {
    if (text.empty()) return false;
    const char first = text.front() == '-' && text.size() > 1 ? text[1] : text.front();
    if ((first < '0' || first > '9') && first != '.') return false;  // from_chars would read inf and nan
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size();
}

}  // namespace

ParsedQuantity parse_number_and_unit(std::string_view text, const QuantityRequest& request) {
    const std::string_view whole = trimmed(text);
    const char mark = request.style.decimal_comma ? ',' : '.';
    ParsedQuantity parsed;
    parsed.number = scan_number(whole, mark);
    if (parsed.number.length == 0) fail_no_number(text, request);
    const std::string_view rest = whole.substr(parsed.number.length);
    const std::string_view unit = rest.substr(leading_space(rest));
    if (unit.empty()) return parsed;
    // "5 1/s": the 1 belongs to the unit.
    const bool one_over = unit.size() < rest.size() && unit.starts_with("1/");
    if (!one_over && (unit[0] == '.' || unit[0] == ',' || (unit[0] >= '0' && unit[0] <= '9'))) {
        fail_malformed_number(text, request);
    }
    parsed.unit = parse_unit(unit);
    if (!parsed.unit) fail_unknown_unit(text, unit, request);
    return parsed;
}

double to_si(const ParsedQuantity& parsed, const ExactFactor& factor, std::string_view text,
             const QuantityRequest& request) {
    const auto value = scaled(parsed.number, request.style.decimal_comma ? ',' : '.', factor);
    if (!value) fail_out_of_range(text, request);
    return *value;
}

double parse_quantity(std::string_view text, Dimension dimension, std::string_view option,
                      NumberStyle style) {
    double value = 0.0;
    if (!style.decimal_comma && plain_number(text, value)) return value == 0.0 ? 0.0 : value;
    const QuantityRequest request{.dimension = dimension, .option = option, .style = style};
    const ParsedQuantity parsed = parse_number_and_unit(text, request);
    if (!parsed.unit) return to_si(parsed, ExactFactor{}, text, request);
    if (parsed.unit->powers != powers_of(dimension)) fail_wrong_kind(text, parsed.unit->powers, request);
    return to_si(parsed, parsed.unit->factor, text, request);
}

std::string_view dimension_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::dimensionless:
            return "a plain number";
        case Dimension::length:
            return "a length";
        case Dimension::volume_flow:
            return "a volume flow";
        case Dimension::velocity:
            return "a velocity";
        case Dimension::pressure:
            return "a pressure";
        case Dimension::pressure_gradient:
            return "a pressure gradient";
        case Dimension::viscosity:
            return "a viscosity";
        case Dimension::time:
            return "a time";
        case Dimension::rate:
            return "a rate";
        case Dimension::consistency:
            return "a consistency";
    }
    return {};
}

std::string_view si_unit(Dimension dimension) {
    switch (dimension) {
        case Dimension::dimensionless:
            return "";
        case Dimension::length:
            return "m";
        case Dimension::volume_flow:
            return "m^3/s";
        case Dimension::velocity:
            return "m/s";
        case Dimension::pressure:
            return "Pa";
        case Dimension::pressure_gradient:
            return "Pa/m";
        case Dimension::viscosity:
            return "Pa s";
        case Dimension::time:
            return "s";
        case Dimension::rate:
            return "1/s";
        case Dimension::consistency:
            return "Pa.s^n";
    }
    return {};
}

}  // namespace bioprint
