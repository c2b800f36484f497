#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bioprint/io/quantity.hpp"

/// A picture in words: panels with axes and series, in SI units. What draws it chooses lab units and looks
/// (gnuplot_script.hpp).
namespace bioprint {

/// The house's lines: dark to light in this order, so that they differ in grey as on paper; each has a dash
/// and a point of its own, and neighbours differ for every kind of colour blindness. After Okabe and Ito.
struct LineStyle {
    std::string_view color;  ///< "#004f8c"
    std::string_view dash;   ///< gnuplot's dash type
    int point;               ///< gnuplot's point type
};
std::span<const LineStyle> house_styles();

enum class Mark {
    line,
    line_points,
    points,
    outline,  ///< a closed curve, lightly filled
    faint,    ///< a thin grey line: what one compares with
    wall,     ///< a closed curve, filled grey
    crosses,  ///< grey: points left out
    band,     ///< light, from low to high
};

struct Series {
    std::string title = {};  ///< in the key; empty: not there
    std::vector<double> x = {};
    std::vector<double> y = {};     ///< not finite: a gap
    std::vector<double> low = {};   ///< where a bar at y begins, or a band; empty: none
    std::vector<double> high = {};  ///< and ends
    int style = 0;                  ///< of house_styles()
    Mark mark = Mark::line;
};

struct Axis {
    std::string title;
    std::optional<Dimension> dimension = std::nullopt;  ///< with one, the unit is chosen and named
    bool logarithmic = false;
    std::optional<double> min = std::nullopt;
    std::optional<double> max = std::nullopt;
    std::vector<std::pair<double, std::string>> names = {};  ///< in place of numbers
};

enum class Anchor { left, centre, right };

struct PictureLabel {
    double x;
    double y;
    std::string text;
    Anchor anchor = Anchor::left;
};

struct Circle {
    double x;
    double height;  ///< of its centre, as a part of the panel's, 0 to 1
    double radius;  ///< in units of x, so that it is to the scale of the axis
};

struct Panel {
    std::string title;
    Axis x;
    Axis y;
    std::vector<Series> series = {};
    std::vector<PictureLabel> labels = {};
    std::vector<Circle> circles = {};
    std::vector<double> verticals = {};  ///< thin lines across the panel at these x
    bool one_scale = false;              ///< a length in x is as long in y
};

struct PictureRow {
    std::vector<Panel> panels;
    int height = 360;  ///< [px]
};

struct Picture {
    std::string name;      ///< of its kind, "exit"
    std::string title;     ///< what was asked
    std::string subtitle;  ///< and more of it, smaller; may be empty
    std::string caption;   ///< what is seen, in a sentence or two
    std::vector<PictureRow> rows;
    bool one_x = false;  ///< the axes of the rows, a panel each, stand below each other
};

inline constexpr int picture_width = 900;  ///< [px]

}  // namespace bioprint
