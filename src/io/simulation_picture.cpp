#include "io/simulation_picture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "bioprint/predict/streamline_passage.hpp"

namespace bioprint {
namespace {

std::vector<double> column_of(const SimulationSeries& series, std::string_view name) {
    std::vector<double> values;
    for (std::size_t c = 0; c < series.columns.size(); ++c) {
        if (series.columns[c] != name) continue;
        for (const std::vector<double>& row : series.rows) values.push_back(row.at(c));
    }
    return values;
}

template <class Member>
Series predicted(const PictureData& data, std::string title, Member member, int style) {
    Series series{.title = std::move(title), .style = style};
    for (const AxisCellState& state : data.history) {
        series.x.push_back(state.position);
        series.y.push_back(state.*member);
    }
    return series;
}

/// The predicted way of a cell off the axis: stress and the two stretches in the plane of its streamline.
struct OffsetWay {
    std::vector<double> x;
    std::vector<double> von_mises;
    std::vector<double> largest;
    std::vector<double> least;
};

OffsetWay way_of(const PictureData& data, double offset) {
    constexpr int points_a_radius = 40;
    const Case& question = data.question;
    const NozzleFlow flow =
        NozzleFlow::from_wall_rate(question.ink.law, question.radius, data.prediction.nozzle.shear_rate_max);
    OffsetWay way;
    streamline_passage(flow,
                       {.start_radius = offset,
                        .shear_modulus = question.cell.shear_modulus,
                        .viscosity_ratio = question.cell.viscosity_ratio,
                        .cell_radius = question.cell.radius,
                        .observe_every = question.radius / points_a_radius},
                       [&](const StreamlineState& state) {
                           way.x.push_back(state.position);
                           way.von_mises.push_back(state.von_mises);
                           way.largest.push_back(std::max(state.stretch[0], state.stretch[1]));
                           way.least.push_back(std::min(state.stretch[0], state.stretch[1]));
                       });
    return way;
}

Series simulated(const Comparison& comparison, std::string_view x, std::string_view y, std::string title,
                 int style) {
    Series series{.title = std::move(title), .style = style};
    std::vector<double> values = column_of(comparison.run.series, y);
    if (values.empty()) return series;  // the scene has no such column
    series.x = column_of(comparison.run.series, x);
    series.y = std::move(values);
    return series;
}

/// A simulated value with its numerical error, where one stands for a curve's peak.
Series bar(const Comparison& comparison, std::string_view name, double x, int style) {
    Series series{.title = "with numerical error", .style = style, .mark = Mark::points};
    for (const ComparedValue& value : comparison.values) {
        if (value.name != name) continue;
        series.x.push_back(x);
        series.y.push_back(value.simulated);
        series.low.push_back(value.simulated - value.error);
        series.high.push_back(value.simulated + value.error);
    }
    return series;
}

double simulated_value(const Comparison& comparison, std::string_view name, double otherwise) {
    for (const ComparedValue& value : comparison.values) {
        if (value.name == name) return value.simulated;
    }
    return otherwise;
}

std::optional<double> predicted_value(const Comparison& comparison, std::string_view name) {
    for (const ComparedValue& value : comparison.values) {
        if (value.name == name) return value.predicted;
    }
    return std::nullopt;
}

Axis place_axis(const PictureData& data) {
    return {.title = "place on the axis, from the nozzle's end",
            .dimension = Dimension::length,
            .min = -2.0 * data.question.radius,
            .max = 5.0 * data.question.radius};
}

/// Where an axis of stretches begins: at a tenth below all of them.
double axis_below(const Panel& panel) {
    double least = 1.0;
    for (const Series& series : panel.series) {
        for (const double y : series.y) least = std::min(least, y);
    }
    return std::max(0.0, std::floor(10.0 * least - 0.5) / 10.0);
}

std::vector<Panel> exit_panels(const PictureData& data, const Comparison& comparison) {
    const double peak_at = simulated_value(comparison, "peak_position", 0.0);
    Panel stress{.title = "Stress of the cell through the exit",
                 .x = place_axis(data),
                 .y = {.title = "von Mises stress", .dimension = Dimension::pressure},
                 .series = {predicted(data, "predicted", &AxisCellState::von_mises, 0),
                            simulated(comparison, "x [m]", "von_mises [Pa]", "simulated", 2),
                            bar(comparison, "von_mises_peak", peak_at, 2)},
                 .verticals = {0.0}};
    Panel stretch{.title = "Stretch of the cell",
                  .x = place_axis(data),
                  .y = {.title = "length over length at rest", .min = 0.0},
                  .series = {predicted(data, "predicted, along (α1)", &AxisCellState::axial_stretch, 0),
                             simulated(comparison, "x [m]", "stretch_axial", "simulated, along", 2),
                             predicted(data, "predicted, across (α2)", &AxisCellState::radial_stretch, 1),
                             simulated(comparison, "x [m]", "stretch_radial", "simulated, across", 4)},
                  .verticals = {0.0}};
    stretch.y.min = axis_below(stretch);
    return {std::move(stress), std::move(stretch)};
}

std::vector<Panel> offset_exit_panels(const PictureData& data, const Comparison& comparison) {
    const OffsetWay way = way_of(data, comparison.run.offset);
    return {{.title = "Stress of the cell through the exit",
             .x = place_axis(data),
             .y = {.title = "von Mises stress", .dimension = Dimension::pressure},
             .series = {{.title = "predicted", .x = way.x, .y = way.von_mises, .style = 0},
                        simulated(comparison, "x [m]", "von_mises [Pa]", "simulated", 2)},
             .verticals = {0.0}},
            {.title = "Stretch of the cell",
             .x = place_axis(data),
             .y = {.title = "length over length at rest", .min = 0.0},
             .series = {{.title = "predicted, longest", .x = way.x, .y = way.largest, .style = 0},
                        simulated(comparison, "x [m]", "stretch_1", "simulated, longest", 2),
                        {.title = "predicted, shortest", .x = way.x, .y = way.least, .style = 1},
                        simulated(comparison, "x [m]", "stretch_2", "simulated, second", 4)},
             .verticals = {0.0}}};
}

/// A cell in a steady flow, over time; on the axis it has one length along the flow and one across.
std::vector<Panel> steady_panels(const Comparison& comparison) {
    const std::vector<double> time = column_of(comparison.run.series, "time [s]");
    const auto level = [&](std::string_view name, std::string title) {
        Series series{.title = std::move(title), .style = 0};
        const std::optional<double> value = predicted_value(comparison, name);
        if (value && !time.empty()) {
            series.x = {0.0, time.back()};
            series.y = {*value, *value};
        }
        return series;
    };
    const double end = time.empty() ? 0.0 : time.back();
    const Axis axis{.title = "time in the flow", .dimension = Dimension::time, .min = 0.0};
    Panel stretch{.title = "Stretch of the cell",
                  .x = axis,
                  .y = {.title = "length over length at rest"},
                  .series = {level("stretch.0", "predicted, settled"), level("stretch.1", ""),
                             simulated(comparison, "time [s]", "stretch_axial", "simulated, along", 2),
                             simulated(comparison, "time [s]", "stretch_radial", "simulated, across", 4),
                             simulated(comparison, "time [s]", "stretch_1", "simulated, longest", 2),
                             simulated(comparison, "time [s]", "stretch_2", "simulated, second", 4)}};
    stretch.y.min = axis_below(stretch);
    return {{.title = "Stress of the cell",
             .x = axis,
             .y = {.title = "von Mises stress", .dimension = Dimension::pressure},
             .series = {level("von_mises", "predicted, settled"),
                        simulated(comparison, "time [s]", "von_mises [Pa]", "simulated", 2),
                        bar(comparison, "von_mises", end, 2)}},
            std::move(stretch)};
}

std::vector<Panel> flow_panels(const PictureData& data, const Comparison& comparison) {
    const double radius = data.question.radius;
    const double steady = data.prediction.exit.elongational_stress;
    return {
        {.title = "Elongational stress of the ink on the axis",
         .x = place_axis(data),
         .y = {.title = "stress", .dimension = Dimension::pressure},
         .series = {predicted(data, "predicted", &AxisCellState::fluid_stress, 0),
                    simulated(comparison, "x [m]", "elongational_stress [Pa]", "simulated", 2),
                    {.title = "steady estimate", .x = {-radius, radius}, .y = {steady, steady}, .style = 1}},
         .verticals = {0.0}},
        {.title = "Velocity of the ink on the axis",
         .x = place_axis(data),
         .y = {.title = "velocity", .dimension = Dimension::velocity},
         .series = {simulated(comparison, "x [m]", "velocity [m/s]", "simulated", 2),
                    {.title = "average in the nozzle",
                     .x = {-2.0 * radius, 5.0 * radius},
                     .y = {data.prediction.nozzle.velocity_average, data.prediction.nozzle.velocity_average},
                     .mark = Mark::faint}},
         .verticals = {0.0}}};
}

std::vector<Panel> panels_of(const PictureData& data, const Comparison& comparison) {
    switch (comparison.run.scene) {
        case SceneKind::exit:
            return comparison.run.offset > 0.0 ? offset_exit_panels(data, comparison)
                                               : exit_panels(data, comparison);
        case SceneKind::channel:
        case SceneKind::shear:
            return steady_panels(comparison);
        case SceneKind::exit_flow:
            return flow_panels(data, comparison);
    }
    return {};
}

}  // namespace

Picture simulation_picture(const PictureData& data, const Comparison& comparison) {
    return {.name = "simulation",
            .title = picture_title(data),
            .subtitle = picture_subtitle(data),
            .caption =
                "The course of the simulation at the resolution asked for, and what the theory predicts; the "
                "point is the answer's value, with its estimated numerical error.",
            .rows = {{.panels = panels_of(data, comparison), .height = 440}}};
}

}  // namespace bioprint
