#include "io/prediction_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/exit_history.hpp"
#include "io/ink_text.hpp"
#include "io/uncertainty.hpp"

namespace bioprint {
namespace {

constexpr int profile_points = 121;
constexpr const char* spread_words = ", 5 to 95 %";

Series curve(std::string title, const std::vector<double>& x, const std::vector<double>& y, int style) {
    return {.title = std::move(title), .x = x, .y = y, .style = style};
}

/// Cells where the answer has them, undeformed, in two rows so that neighbours do not hide each other.
std::vector<Circle> cells_to_scale(const PictureData& data) {
    std::vector<Circle> circles;
    for (const auto& [index, cell] : cells_in_nozzle(data)) {
        const double height = circles.size() % 2 == 0 ? 0.2 : 0.44;
        circles.push_back({.x = cell.offset, .height = height, .radius = data.question.cell.radius});
    }
    return circles;
}

Panel velocity_panel(const PictureData& data) {
    const RadialProfile& profile = *data.prediction.profile;
    return {.title = "Velocity, and the cells to scale",
            .x = {.title = "distance from the axis",
                  .dimension = Dimension::length,
                  .min = 0.0,
                  .max = data.question.radius},
            .y = {.title = "velocity", .dimension = Dimension::velocity},
            .series = {curve("", profile.r, profile.velocity, 0)},
            .circles = cells_to_scale(data)};
}

/// What the cells of every streamline bear at most, and the stress that 95 % of all cells stay below.
void add_population(Panel& panel, const Population& all, double radius) {
    const double most = all.peak_stress.percentile_95;
    panel.title = "Stress in the nozzle, and of all cells on their way";
    panel.series.push_back(curve("cells, largest in the nozzle", all.radius, all.nozzle_peak, 1));
    panel.series.push_back(curve("cells, largest at the exit", all.radius, all.exit_peak, 3));
    panel.series.push_back(
        {.title = "95 % of all cells", .x = {0.0, radius}, .y = {most, most}, .mark = Mark::faint});
}

Panel stress_panel(const PictureData& data) {
    const RadialProfile& profile = *data.prediction.profile;
    Series cells{.title = "cell (von Mises)", .style = 2, .mark = Mark::points};
    for (const auto& [index, cell] : cells_in_nozzle(data)) {
        if (!cell.stress) continue;
        add_point(cells, data, "cells." + std::to_string(index) + ".stress.von_mises", cell.offset,
                  cell.stress->von_mises);
    }
    if (!cells.low.empty()) cells.title += spread_words;
    Panel panel{.title = "Stress in the nozzle",
                .x = {.title = "distance from the axis",
                      .dimension = Dimension::length,
                      .min = 0.0,
                      .max = data.question.radius},
                .y = {.title = "stress", .dimension = Dimension::pressure},
                .series = {curve("ink (shear stress)", profile.r, profile.stress, 0), std::move(cells)}};
    if (data.prediction.population) add_population(panel, *data.prediction.population, data.question.radius);
    return panel;
}

/// The part of the axis a picture of the exit shows, in radii from the lip.
constexpr double shown_before = -2.0;
constexpr double shown_behind = 5.0;

std::vector<AxisCellState> shown_history(const PictureData& data) {
    std::vector<AxisCellState> shown;
    for (const AxisCellState& state : data.history) {
        const double x = state.position / data.question.radius;
        if (x >= shown_before && x <= shown_behind) shown.push_back(state);
    }
    return shown;
}

template <class Member>
std::vector<double> column(const std::vector<AxisCellState>& states, Member member) {
    std::vector<double> values;
    values.reserve(states.size());
    for (const AxisCellState& state : states) values.push_back(state.*member);
    return values;
}

const AxisCellState& peak_of(const std::vector<AxisCellState>& history) {
    return *std::max_element(history.begin(), history.end(),
                             [](const auto& a, const auto& b) { return a.von_mises < b.von_mises; });
}

/// The centred cell at its largest stress, with the spread of a number of its; nothing without a spread.
void add_peak_bar(Panel& panel, const PictureData& data, const std::string& number, double y, int style) {
    const std::vector<CellAnswer>& cells = data.prediction.cells;
    const auto carried = std::find_if(cells.begin(), cells.end(), [](const CellAnswer& cell) {
        return cell.place == Place::exit && cell.model == Model::ellipsoid && cell.offset == 0.0;
    });
    if (carried == cells.end()) return;
    Series bar{.title = std::string("largest") + spread_words, .style = style, .mark = Mark::points};
    add_point(bar, data, "cells." + std::to_string(carried - cells.begin()) + "." + number,
              peak_of(data.history).position, y);
    if (!bar.low.empty()) panel.series.push_back(std::move(bar));
}

const CellAnswer* steady_exit(const Prediction& prediction) {
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.place == Place::exit && cell.model == Model::roscoe_elongation) return &cell;
    }
    return nullptr;
}

Axis exit_axis(const PictureData& data) {
    return {.title = "place on the axis, from the nozzle's end",
            .dimension = Dimension::length,
            .min = shown_before * data.question.radius,
            .max = shown_behind * data.question.radius};
}

Panel exit_stress_panel(const PictureData& data) {
    const std::vector<AxisCellState> shown = shown_history(data);
    const std::vector<double> x = column(shown, &AxisCellState::position);
    const double radius = data.question.radius;
    Panel panel{.title = "Stress through the exit",
                .x = exit_axis(data),
                .y = {.title = "stress", .dimension = Dimension::pressure},
                .series = {curve("cell, carried in time", x, column(shown, &AxisCellState::von_mises), 0),
                           curve("ink on the axis", x, column(shown, &AxisCellState::fluid_stress), 1)},
                .verticals = {0.0}};
    // The steady estimate spreads the elongation over two radii around the end of the nozzle.
    const std::vector<double> span = {-radius, radius};
    if (const CellAnswer* const steady = steady_exit(data.prediction); steady != nullptr && steady->stress) {
        panel.series.push_back(
            curve("cell, steady estimate", span, {steady->stress->von_mises, steady->stress->von_mises}, 2));
    }
    const double ink = data.prediction.exit.elongational_stress;
    panel.series.push_back(curve("ink, steady estimate", span, {ink, ink}, 3));
    add_peak_bar(panel, data, "stress.von_mises", peak_of(data.history).von_mises, 0);
    return panel;
}

Panel exit_stretch_panel(const PictureData& data) {
    const std::vector<AxisCellState> shown = shown_history(data);
    const std::vector<double> x = column(shown, &AxisCellState::position);
    const std::vector<double> axial = column(shown, &AxisCellState::axial_stretch);
    const double least = *std::min_element(axial.begin(), axial.end());
    Panel panel{.title = "Stretch of the cell",
                .x = exit_axis(data),
                .y = {.title = "length over length at rest", .min = std::floor(least * 5.0) / 5.0},
                .series = {curve("along the axis (α1)", x, axial, 0),
                           curve("across (α2, α3)", x, column(shown, &AxisCellState::radial_stretch), 1)},
                .verticals = {0.0}};
    add_peak_bar(panel, data, "stretch.0", peak_of(data.history).axial_stretch, 0);
    return panel;
}

/// A viscosity without a bound at the axis is drawn over so many decades above that at the wall.
constexpr double decades_of_viscosity = 4.0;
constexpr double spread_wants_logarithm = 50.0;

Panel viscosity_panel(const PictureData& data) {
    const RadialProfile& profile = *data.prediction.profile;
    std::vector<double> shown = profile.viscosity;
    const double wall = data.prediction.nozzle.viscosity_wall;
    double largest = 0.0;
    for (double& value : shown) {
        // A plug has no viscosity, and near one it grows without bound.
        if (value > wall * std::pow(10.0, decades_of_viscosity))
            value = std::numeric_limits<double>::quiet_NaN();
        if (std::isfinite(value)) largest = std::max(largest, value);
    }
    return {.title = "Viscosity",
            .x = {.title = "distance from the axis",
                  .dimension = Dimension::length,
                  .min = 0.0,
                  .max = data.question.radius},
            .y = {.title = "viscosity",
                  .dimension = Dimension::viscosity,
                  .logarithmic = wall > 0.0 && largest / wall >= spread_wants_logarithm},
            .series = {curve("", profile.r, shown, 0)}};
}

}  // namespace

std::vector<PlacedCell> cells_in_nozzle(const PictureData& data) {
    const std::vector<CellAnswer>& all = data.prediction.cells;
    std::vector<PlacedCell> cells;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].place != Place::nozzle) continue;
        const bool carried = std::any_of(all.begin(), all.end(), [&](const CellAnswer& other) {
            return other.place == Place::nozzle && other.model == Model::ellipsoid &&
                   other.offset == all[i].offset;
        });
        if (all[i].model == Model::ellipsoid || !carried) cells.push_back({.index = i, .cell = all[i]});
    }
    return cells;
}

void add_point(Series& series, const PictureData& data, const std::string& path, double x, double y) {
    series.x.push_back(x);
    series.y.push_back(y);
    const bool spread_asked = data.answer.is_object() && data.answer.contains("uncertainty");
    if (!spread_asked) return;
    const Json* const spread = spread_of(data.answer, path);
    const auto end = [&](const char* name) {
        return spread == nullptr ? std::numeric_limits<double>::quiet_NaN() : spread->at(name).get<double>();
    };
    series.low.push_back(end("percentile_5"));
    series.high.push_back(end("percentile_95"));
}

PictureData picture_data(Case question, Json answer) {
    question.profile_points = profile_points;
    Prediction prediction = predict(question);
    if (prediction.nozzle.velocity_average <= 0.0) {
        throw UsageError("--plot: nothing flows; give a flow rate, velocity or pressure", "--plot");
    }
    std::vector<AxisCellState> history = exit_history(question, prediction);
    return {.question = std::move(question),
            .prediction = std::move(prediction),
            .history = std::move(history),
            .answer = std::move(answer)};
}

std::string picture_title(const PictureData& data) {
    const Case& question = data.question;
    const std::string radius = "R " + lab_text(question.radius, Dimension::length, 3);
    const std::string nozzle = question.needle ? question.needle->name + " (" + radius + ")" : radius;
    return nozzle + ", " + lab_text(data.prediction.nozzle.flow_rate, Dimension::volume_flow, 3);
}

std::string picture_subtitle(const PictureData& data) {
    const CellChoice& cell = data.question.cell;
    return "ink " + data.question.ink.name + ": " + ink_text(data.question.ink.law) + "; cell " + cell.name +
           ": R " + lab_text(cell.radius, Dimension::length, 3) + ", " +
           lab_text(cell.shear_modulus, Dimension::pressure, 3);
}

Picture profile_picture(const PictureData& data) {
    const RadialProfile& profile = *data.prediction.profile;
    const auto small = [&](const char* title, const char* name, Dimension dimension,
                           const std::vector<double>& values) {
        return Panel{.title = title,
                     .x = {.title = "distance from the axis",
                           .dimension = Dimension::length,
                           .min = 0.0,
                           .max = data.question.radius},
                     .y = {.title = name, .dimension = dimension},
                     .series = {curve("", profile.r, values, 0)}};
    };
    return {.name = "profile",
            .title = picture_title(data),
            .subtitle = picture_subtitle(data),
            .caption =
                "Velocity, stress, shear rate and viscosity of the ink from the axis to the wall of the "
                "nozzle; the circles are the cells, undeformed and to scale with the axis below them.",
            .rows = {{.panels = {velocity_panel(data), stress_panel(data)}},
                     {.panels = {small("Shear rate", "shear rate", Dimension::rate, profile.shear_rate),
                                 viscosity_panel(data)}}}};
}

Picture exit_picture(const PictureData& data) {
    return {.name = "exit",
            .title = picture_title(data),
            .subtitle = picture_subtitle(data),
            .caption =
                "The centred cell on its way through the end of the nozzle (thin line): its stress and "
                "stretch, carried in time, the stress of the ink on the axis, and the steady estimates "
                "over the two radii on which they rest.",
            .rows = {{.panels = {exit_stress_panel(data), exit_stretch_panel(data)}, .height = 420}}};
}

Picture overview_picture(const PictureData& data, unsigned jobs) {
    Picture cells = cell_picture(data);
    Picture nomogram = nomogram_picture(data, jobs);
    return {.name = "overview",
            .title = picture_title(data),
            .subtitle = picture_subtitle(data),
            .caption =
                "Top: nozzle, strand and cells to scale. Middle: stress in the nozzle over the radius, and "
                "through the exit along the axis. Bottom: the same ink and cell in other needles.",
            .rows = {std::move(cells.rows.front()),
                     {.panels = {stress_panel(data), exit_stress_panel(data)}, .height = 380},
                     std::move(nomogram.rows.front())}};
}

}  // namespace bioprint
