#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/cell/bullet.hpp"
#include "io/prediction_pictures.hpp"

// Nozzle, strand and cells, every length to one scale.

namespace bioprint {
namespace {

constexpr int outline_points = 96;
constexpr double scene_before = -3.2;  // radii of the nozzle
constexpr double scene_behind = 4.4;

struct Outline {
    std::vector<double> x;
    std::vector<double> y;
};

/// A closed curve (x, y)(angle) around a centre.
template <class Shape>
Outline closed(double x, double y, const Shape& shape) {
    Outline outline;
    for (int i = 0; i <= outline_points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / outline_points;
        const auto [dx, dy] = shape(angle);
        outline.x.push_back(x + dx);
        outline.y.push_back(y + dy);
    }
    return outline;
}

/// An ellipse whose first axis is turned by `angle` from the flow.
Outline ellipse(double x, double y, double first, double second, double turned = 0.0) {
    return closed(x, y, [&](double t) {
        const double a = first * std::cos(t);
        const double b = second * std::sin(t);
        return std::pair(a * std::cos(turned) - b * std::sin(turned),
                         a * std::sin(turned) + b * std::cos(turned));
    });
}

/// The centred cell in the nozzle: sharper in front, flatter behind. First order, so the amplitude is kept below
/// where the outline would fold.
Outline bullet_outline(double x, const PictureData& data) {
    const CellChoice& cell = data.question.cell;
    const BulletState state = bullet({.pressure_gradient = data.prediction.nozzle.pressure_gradient,
                                      .viscosity = 1.0,
                                      .cell_radius = cell.radius,
                                      .shear_modulus = cell.shear_modulus});
    const double amplitude = std::min(state.shape_amplitude, 0.2);
    return closed(x, 0.0, [&](double t) {
        const double c = std::cos(t);
        const double r = cell.radius * (1.0 + amplitude * 0.5 * c * (5.0 * c * c - 3.0));
        return std::pair(r * c, r * std::sin(t));
    });
}

Series drawn(Outline outline, Mark mark, int style, std::string title = {}) {
    return {.title = std::move(title),
            .x = std::move(outline.x),
            .y = std::move(outline.y),
            .style = style,
            .mark = mark};
}

const AxisCellState& peak_of(const std::vector<AxisCellState>& history) {
    return *std::max_element(history.begin(), history.end(),
                             [](const auto& a, const auto& b) { return a.von_mises < b.von_mises; });
}

const AxisCellState& state_at(const std::vector<AxisCellState>& history, double x) {
    return *std::min_element(history.begin(), history.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.position - x) < std::abs(b.position - x);
    });
}

Outline rectangle(double x0, double x1, double y0, double y1) {
    return {.x = {x0, x1, x1, x0, x0}, .y = {y0, y0, y1, y1, y0}};
}

Series segment(double x0, double x1, double y) {
    return {.x = {x0, x1}, .y = {y, y}, .mark = Mark::faint};
}

/// The tank-treading cells off the axis: above it the ink is slower outside, so their front leans to the axis.
void add_off_axis(const PictureData& data, Panel& panel) {
    double place = -2.75 * data.question.radius;
    bool above = true;
    for (const auto& [index, cell] : cells_in_nozzle(data)) {
        if (cell.offset <= 0.0 || !cell.stretch) continue;
        const double side = above ? 1.0 : -1.0;
        const double radius = data.question.cell.radius;
        const Outline outline = ellipse(place, side * cell.offset, (*cell.stretch)[0] * radius,
                                        (*cell.stretch)[1] * radius, -side * cell.angle.value_or(0.0));
        const bool first = place == -2.75 * data.question.radius;
        panel.series.push_back(drawn(outline, Mark::outline, 1, first ? "off the axis, in the nozzle" : ""));
        place += 0.8 * data.question.radius;
        above = !above;
    }
}

Panel scene_panel(const PictureData& data) {
    const double radius = data.question.radius;
    const double cell = data.question.cell.radius;
    const double wall = 1.16 * radius;
    Panel panel{.title = "Nozzle, strand and cells to scale; the flow goes to the right",
                .x = {.title = "place along the axis, from the nozzle's end",
                      .dimension = Dimension::length,
                      .min = scene_before * radius,
                      .max = scene_behind * radius},
                .y = {.title = "distance from the axis",
                      .dimension = Dimension::length,
                      .min = -1.25 * radius,
                      .max = 1.25 * radius},
                .one_scale = true};
    for (const double side : {1.0, -1.0}) {
        panel.series.push_back(
            drawn(rectangle(scene_before * radius, 0.0, side * radius, side * wall), Mark::wall, 0));
        panel.series.push_back(segment(0.0, scene_behind * radius, side * radius));
    }
    panel.series.push_back(segment(scene_before * radius, scene_behind * radius, 0.0));
    panel.series.push_back(
        drawn(bullet_outline(-1.35 * radius, data), Mark::outline, 0, "on the axis, in the nozzle"));
    const AxisCellState& peak = peak_of(data.history);
    panel.series.push_back(
        drawn(ellipse(peak.position, 0.0, peak.axial_stretch * cell, peak.radial_stretch * cell),
              Mark::outline, 2, "at its largest load"));
    const AxisCellState& after = state_at(data.history, 3.4 * radius);
    panel.series.push_back(
        drawn(ellipse(after.position, 0.0, after.axial_stretch * cell, after.radial_stretch * cell),
              Mark::outline, 3, "in the strand"));
    add_off_axis(data, panel);
    return panel;
}

Panel outline_panel(const PictureData& data) {
    const double cell = data.question.cell.radius;
    const AxisCellState& peak = peak_of(data.history);
    const AxisCellState& after = state_at(data.history, 3.4 * data.question.radius);
    const double reach = 1.15 * cell * std::max({peak.radial_stretch, peak.axial_stretch, 1.05});
    const auto axis = [&](const char* title) {
        return Axis{.title = title, .dimension = Dimension::length, .min = -reach, .max = reach};
    };
    return {.title = "The centred cell at one scale",
            .x = axis("along the flow"),
            .y = axis("across"),
            .series = {drawn(bullet_outline(0.0, data), Mark::line, 0, "in the nozzle"),
                       drawn(ellipse(0.0, 0.0, peak.axial_stretch * cell, peak.radial_stretch * cell),
                             Mark::line, 2, "at its largest load"),
                       drawn(ellipse(0.0, 0.0, after.axial_stretch * cell, after.radial_stretch * cell),
                             Mark::line, 3, "in the strand"),
                       drawn(ellipse(0.0, 0.0, cell, cell), Mark::faint, 0, "at rest")},
            .one_scale = true};
}

}  // namespace

Picture cell_picture(const PictureData& data) {
    return {.name = "cell",
            .title = picture_title(data),
            .subtitle = picture_subtitle(data),
            .caption =
                "Nozzle and strand in section with the cells to scale: on the axis in the nozzle, at its "
                "largest load and in the strand; off the axis tank-treading, alternately above and below. "
                "Below it the outlines of the centred cell on top of each other.",
            .rows = {{.panels = {scene_panel(data)}, .height = 400},
                     {.panels = {outline_panel(data)}, .height = 460}}};
}

}  // namespace bioprint
