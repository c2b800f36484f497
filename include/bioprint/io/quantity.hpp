#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Numbers with units, as people write them: `50um`, `0.1 mm`, `141uL/h`, `10 Pa.s`, `30 psi`.
///
/// A number alone is SI. A unit is a product of known units with whole powers: `uL/h`, `mm^3/s`, `MPa/m`, `Pa
/// s`, `Pa·s`, `kg/m/s`, `s-1`, and `Pa.s^n` for a consistency, whose n is the flow index given beside it. The micro sign may be u or either µ of Unicode; superscripts, U+2212 as minus
/// and no-break spaces are read. Upper and lower case differ (mPa is not MPa), except for the litre.
///
/// Degenerate cases, all refused with the option, what was given and what is taken: no number, nan, inf,
/// hexadecimal, a value that a double cannot hold, a unit that is unknown or of another kind, anything after
/// the unit.
///
/// Accuracy: every conversion factor is kept as an exact fraction and applied to the decimal digits, so the
/// result is the double nearest to the exact value: 50um is 5e-05. tests/unit/io/quantity.cpp The locale
/// never matters.
namespace bioprint {

enum class Dimension {
    dimensionless,
    length,             // m
    volume_flow,        // m³/s
    velocity,           // m/s
    pressure,           // Pa; stresses and moduli too
    pressure_gradient,  // Pa/m
    viscosity,          // Pa s
    time,               // s
    rate,               // 1/s
    consistency,        // Pa s^n, n the flow index of the ink
};

/// How numbers are written in a text. With `decimal_comma`, 1,5 is read and 1.5 is refused, lists are
/// separated by semicolons; without it, the reverse.
struct NumberStyle {
    bool decimal_comma = false;
};

/// The value of `text` in SI units; -0 becomes 0. The sign is not judged here.
/// @param option  named in the error, e.g. "--radius" or a column
/// @throws UsageError
double parse_quantity(std::string_view text, Dimension dimension, std::string_view option,
                      NumberStyle style = {});

/// A list `0,0.3,0.75` or a range `first:last:step`, in SI units.
///
/// A number without a unit takes the next unit to its right: `10,20,50um` are three lengths in µm, so is
/// `10:50:20um`. Behind the last unit of a list, a number without one is refused unless it is 0.
/// A range contains both ends when the step divides it (to 1e-9 of a step); otherwise it stops short of the
/// last. Its elements are rounded to 15 digits, so 0:0.75:0.15 contains 0.45 and not 0.44999999999999996. At
/// most 1 000 000 elements.
/// @throws UsageError  also for a step of zero or of the wrong sign
std::vector<double> parse_quantity_list(std::string_view text, Dimension dimension, std::string_view option,
                                        NumberStyle style = {});

/// A distance from the axis, in metres or in radii of the cell.
struct Offset {
    double value;
    bool in_cell_radii;
};

/// A list or range of offsets: `0,1.5Rc,3Rc,20um`. The rules of `parse_quantity_list`; a range may not mix Rc
/// and lengths.
/// @throws UsageError
std::vector<Offset> parse_offsets(std::string_view text, std::string_view option = "--offset",
                                  NumberStyle style = {});

/// "a length", "a volume flow", …
std::string_view dimension_name(Dimension dimension);

/// The SI unit as the answer writes it: "m", "m^3/s", "Pa/m", "Pa s", …; empty when there is none.
std::string_view si_unit(Dimension dimension);

}  // namespace bioprint
