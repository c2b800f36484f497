#include "io/quantity_messages.hpp"

#include <algorithm>
#include <string>

#include "bioprint/errors.hpp"
#include "io/text.hpp"

namespace bioprint {

namespace {

std::string example(Dimension dimension) {
    switch (dimension) {
        case Dimension::dimensionless:
            return "0.75";
        case Dimension::length:
            return "50um";
        case Dimension::volume_flow:
            return "141uL/h";
        case Dimension::velocity:
            return "5mm/s";
        case Dimension::pressure:
            return "1kPa";
        case Dimension::pressure_gradient:
            return "17MPa/m";
        case Dimension::viscosity:
            return "10Pa.s";
        case Dimension::time:
            return "50ms";
        case Dimension::rate:
            return "100/s";
        case Dimension::consistency:
            return "10Pa.s^n";
    }
    return {};
}

std::string what_it_takes(const QuantityRequest& request) {
    if (request.offset) return "it takes a length such as 5um or cell radii such as 1.5Rc";
    return "it takes " + std::string(dimension_name(request.dimension)) + " such as " +
           example(request.dimension);
}

bool contains_letters(std::string_view text, std::string_view word) {
    return lower_case(text).find(word) != std::string::npos;
}

/// A comma where a point is expected, or the reverse.
bool other_mark(std::string_view text, const QuantityRequest& request) {
    const char other = request.style.decimal_comma ? '.' : ',';
    const auto at = text.find(other);
    return at != std::string_view::npos && at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
}

}  // namespace

void fail_quantity(std::string_view text, std::string_view problem, const QuantityRequest& request) {
    std::string message;
    if (!request.option.empty()) message += std::string(request.option) + ": ";
    message += "got " + in_quotes(text) + ", " + std::string(problem) + "; " + what_it_takes(request);
    throw UsageError(message, std::string(request.option));
}

void fail_no_number(std::string_view text, const QuantityRequest& request) {
    if (trimmed(text).empty()) fail_quantity(text, "which is empty", request);
    if (contains_letters(text, "nan") || contains_letters(text, "inf")) {
        fail_quantity(text, "not a finite number", request);
    }
    fail_quantity(text, "not a number", request);
}

void fail_malformed_number(std::string_view text, const QuantityRequest& request) {
    if (other_mark(text, request)) {
        fail_quantity(
            text,
            request.style.decimal_comma
                ? "which has a decimal point where decimal commas are used"
                : "which has a comma; decimals are written with a point and thousands without a mark",
            request);
    }
    fail_quantity(text, "not a number", request);
}

void fail_unknown_unit(std::string_view text, std::string_view unit, const QuantityRequest& request) {
    auto known = usual_units(request.dimension);
    std::string problem = "whose unit " + in_quotes(unit) + " is not known";
    static constexpr std::string_view radii[] = {"Rc", "um", "mm", "m", "nm"};
    if (request.offset) known = radii;
    const auto near = nearest(unit, known);
    if (!near.empty()) {
        problem += " (did you mean '" + std::string(near) + "'?)";
    } else if (request.dimension != Dimension::dimensionless) {
        problem += " (known are";
        for (const auto name : known.first(std::min<std::size_t>(known.size(), 6))) {
            problem += ' ';
            problem += name;
        }
        problem += ", ...)";
    }
    fail_quantity(text, problem, request);
}

void fail_wrong_kind(std::string_view text, const Powers& powers, const QuantityRequest& request) {
    fail_quantity(text, kind_name(powers), request);
}

void fail_out_of_range(std::string_view text, const QuantityRequest& request) {
    fail_quantity(text, "which no double-precision number can hold (5e-324 to 1.8e308)", request);
}

}  // namespace bioprint
