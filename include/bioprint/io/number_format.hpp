#pragma once

#include <string>
#include <string_view>

#include "bioprint/io/quantity.hpp"

/// Numbers for machines (shortest form that reads back to the same double) and for people (lab units, few
/// digits). The locale never matters.
namespace bioprint {

/// The shortest decimal that reads back to `value`: 5e-05, 0.75, 141. `value` must be finite; -0 is written
/// as 0.
std::string format_shortest(double value);

/// Appends what `format_shortest` returns, without a string of its own.
void append_shortest(std::string& out, double value);

/// A unit of the lab: what one of it is in SI, and its name.
struct LabUnit {
    double in_si;
    std::string_view name;
};

/// The unit in which `magnitude` (SI) reads best: the number before it lies between 1 and 1000 where a unit
/// of the dimension allows. For a column, choose by its largest entry. Zero gets the dimension's usual unit.
const LabUnit& choose_lab_unit(double magnitude, Dimension dimension, int digits = 4);

/// `value` (SI) in `unit` with at most `digits` significant digits and no trailing zeros: 0.25, 17.4, 436.2.
/// From 1e7 up and below 1e-4, with an exponent: 1.2e-07. Never "-0"; not finite is "n/a".
std::string format_in(double value, const LabUnit& unit, int digits = 4);

struct LabNumber {
    std::string number;
    std::string unit;
};

/// Number and unit for a person: 5e-5 m is {"50", "µm"}, 1.74e7 Pa/m is {"17.4", "MPa/m"}.
LabNumber format_lab(double value, Dimension dimension, int digits = 4);

/// The same in one piece: "17.4 MPa/m"; a number alone where the dimension has no unit.
std::string lab_text(double value, Dimension dimension, int digits = 4);

/// A number without a unit.
std::string bare_text(double value, int digits = 4);

/// A share in per cent: 0.123 is "12 %".
std::string percent_text(double share, int digits = 2);

}  // namespace bioprint
