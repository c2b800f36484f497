#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "bioprint/errors.hpp"
#include "bioprint/io/quantity.hpp"
#include "io/quantity_messages.hpp"
#include "io/text.hpp"
#include "io/units.hpp"

namespace bioprint {

namespace {

constexpr std::size_t largest_list = 1'000'000;
constexpr double end_tolerance = 1e-9;  // of a step: far above rounding, far below what anyone means

struct Element {
    std::string_view text;
    ParsedQuantity parsed;
};

std::vector<Element> split(std::string_view text, char separator, const QuantityRequest& request) {
    std::vector<Element> elements;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(separator, start), text.size());
        const auto part = text.substr(start, end - start);
        if (trimmed(part).empty()) fail_quantity(text, "which has an empty element", request);
        if (elements.size() == largest_list)
            fail_quantity(text, "a list of more than 1000000 numbers", request);
        elements.push_back({.text = part, .parsed = parse_number_and_unit(part, request)});
        start = end + 1;
    }
    return elements;
}

/// Gives each number without a unit the next unit to its right.
void spread_units(std::vector<Element>& elements, std::string_view text, const QuantityRequest& request) {
    const auto has_unit = [](const Element& element) { return element.parsed.unit.has_value(); };
    const bool any = std::any_of(elements.begin(), elements.end(), has_unit);
    const Element* next = nullptr;
    for (auto it = elements.rbegin(); it != elements.rend(); ++it) {
        const bool zero = it->parsed.number.digits.find_first_of("123456789") == std::string_view::npos;
        if (it->parsed.unit) {
            next = &*it;
        } else if (next != nullptr) {
            it->parsed.unit = next->parsed.unit;
        } else if (any && !zero) {
            fail_quantity(text, "where " + in_quotes(it->text) + " has no unit and others do", request);
        }
    }
}

/// `value` rounded to 15 digits, where that changes no more than rounding errors of numbers up to `scale`.
double without_dust(double value, double scale) {
    const double dust = 8 * 2.2e-16 * scale;
    if (std::abs(value) <= dust) return 0.0;
    char digits[32];
    const auto written =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::scientific, 14);
    double rounded = value;
    std::from_chars(digits, written.ptr, rounded);
    return std::abs(rounded - value) <= dust ? rounded : value;
}

struct Range {
    double first;
    double last;
    double step;
};

std::vector<double> expand(const Range& range, std::string_view text, const QuantityRequest& request) {
    if (range.first == range.last) return {range.first};
    if (range.step == 0.0) fail_quantity(text, "a range whose step is 0", request);
    const double steps = range.last / range.step - range.first / range.step;
    if (!(steps > 0.0)) fail_quantity(text, "a range whose step leads away from its end", request);
    if (!(steps < static_cast<double>(largest_list))) {
        fail_quantity(text, "a range of more than 1000000 numbers", request);
    }
    const bool divides = std::abs(steps - std::round(steps)) <= end_tolerance * std::max(1.0, steps);
    const auto count = static_cast<std::size_t>(divides ? std::round(steps) : std::floor(steps));
    const double scale = std::max(std::abs(range.first), std::abs(range.last));
    std::vector<double> values;
    values.reserve(count + 1);
    values.push_back(range.first);
    for (std::size_t i = 1; i <= count; ++i) {
        const auto done = static_cast<double>(i);
        const double left = static_cast<double>(count) - done;
        // Between the two ends by weight where possible: the products of short decimals are mostly exact.
        const double value = divides && scale < 1e300
                                 ? (range.first * left + range.last * done) / static_cast<double>(count)
                                 : range.first + done * range.step;
        values.push_back(without_dust(value, scale));
    }
    if (divides && count > 0) values.back() = range.last;
    return values;
}

/// The elements of a list, or the three of a range with their units made equal in kind.
struct ParsedList {
    std::vector<Element> elements;
    bool is_range;
};

/// "0.05,0.1:0.3:0.1", "1um,2um:4um:1um"; not "0:0,3:0,1", whose commas are decimals.
bool mixes_list_and_range(std::string_view range, bool decimal_comma) {
    if (decimal_comma) return range.find(';') != std::string_view::npos;
    std::size_t commas = 0;
    bool separates = false;
    for (std::size_t i = 0; i < range.size(); ++i) {
        if (range[i] == ':') commas = 0;
        if (range[i] != ',') continue;
        separates = separates || ++commas > 1 || i == 0 || range[i - 1] < '0' || range[i - 1] > '9' ||
                    range.find('.') != std::string_view::npos;
    }
    return separates;
}

ParsedList parse_list(std::string_view text, const QuantityRequest& request) {
    const std::string_view whole = trimmed(text);
    if (whole.empty()) fail_quantity(text, "which is empty", request);
    const bool is_range = whole.find(':') != std::string_view::npos;
    if (is_range && mixes_list_and_range(whole, request.style.decimal_comma)) {
        fail_quantity(text, "which mixes a list and a range; write every value out, or give one of the two",
                      request);
    }
    ParsedList list{.elements = split(whole,
                                      is_range                      ? ':'
                                      : request.style.decimal_comma ? ';'
                                                                    : ',',
                                      request),
                    .is_range = is_range};
    if (is_range && list.elements.size() != 3) {
        fail_quantity(text, "where a range is written first:last:step", request);
    }
    spread_units(list.elements, text, request);
    return list;
}

double value_of(const Element& element, const QuantityRequest& request) {
    const auto& unit = element.parsed.unit;
    return to_si(element.parsed, unit ? unit->factor : ExactFactor{}, element.text, request);
}

Offset offset_of(const Element& element, const QuantityRequest& request) {
    const auto& unit = element.parsed.unit;
    const bool in_radii = unit && unit->powers == Powers{.cell_radius = 1};
    if (unit && !in_radii && unit->powers != powers_of(Dimension::length)) {
        fail_wrong_kind(element.text, unit->powers, request);
    }
    return {.value = value_of(element, request), .in_cell_radii = in_radii};
}

}  // namespace

std::vector<double> parse_quantity_list(std::string_view text, Dimension dimension, std::string_view option,
                                        NumberStyle style) {
    const QuantityRequest request{.dimension = dimension, .option = option, .style = style};
    const ParsedList list = parse_list(text, request);
    std::vector<double> values;
    values.reserve(list.elements.size());
    for (const auto& element : list.elements) {
        const auto& unit = element.parsed.unit;
        if (unit && unit->powers != powers_of(dimension))
            fail_wrong_kind(element.text, unit->powers, request);
        values.push_back(value_of(element, request));
    }
    if (!list.is_range) return values;
    return expand({.first = values[0], .last = values[1], .step = values[2]}, text, request);
}

std::vector<Offset> parse_offsets(std::string_view text, std::string_view option, NumberStyle style) {
    const QuantityRequest request{
        .dimension = Dimension::length, .option = option, .style = style, .offset = true};
    const ParsedList list = parse_list(text, request);
    std::vector<Offset> offsets;
    offsets.reserve(list.elements.size());
    for (const auto& element : list.elements) offsets.push_back(offset_of(element, request));
    if (!list.is_range) return offsets;
    const bool in_radii = offsets[2].in_cell_radii;
    for (const auto& end : {offsets[0], offsets[1]}) {
        if (end.in_cell_radii != in_radii && end.value != 0.0) {
            fail_quantity(text, "a range that mixes cell radii and lengths", request);
        }
    }
    const auto values = expand(
        {.first = offsets[0].value, .last = offsets[1].value, .step = offsets[2].value}, text, request);
    offsets.clear();
    for (const double value : values) offsets.push_back({.value = value, .in_cell_radii = in_radii});
    return offsets;
}

}  // namespace bioprint
