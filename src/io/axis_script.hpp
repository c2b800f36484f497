#pragma once

#include <string>
#include <string_view>

#include "io/picture.hpp"

/// The axes of a panel as gnuplot commands: their unit, range, and the numbers at them.
namespace bioprint {

/// The range of what a panel draws, in SI units.
struct Extent {
    double low = 0.0;
    double high = 0.0;
    bool empty = true;
    bool has_points = false;  ///< then nothing may lie on the border
    void add(double value);
    [[nodiscard]] double magnitude() const;
};
Extent extent_of(const Panel& panel, bool of_x);

/// How numbers of an axis are written: divided by a lab unit that stands in the title.
struct Scale {
    double unit = 1.0;
    std::string title;
    double operator()(double value) const { return value / unit; }
};
Scale scale_of(const Axis& axis, const Extent& extent);

/// @param name  "x" or "y"
std::string axis_commands(std::string_view name, const Axis& axis, const Scale& scale, const Extent& extent);

/// The ends of a logarithmic axis around these values: 1, 2 or 5 times a power of ten, with some room.
struct LogRange {
    double low;
    double high;
};
LogRange log_range(double low, double high);

/// A gnuplot string that means `text` and nothing else: in single quotes nothing but the quote itself is
/// special. Control characters and bytes that are no UTF-8 would break an SVG and are left out.
std::string gnuplot_text(std::string_view text);

/// A number as gnuplot reads it.
std::string gnuplot_number(double value);

}  // namespace bioprint
