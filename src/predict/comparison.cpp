#include "bioprint/predict/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/predict/exit_passage.hpp"
#include "bioprint/predict/streamline_passage.hpp"

namespace bioprint {
namespace {

using Values = std::map<std::string, double>;

Values predicted_exit_flow(const Prediction& prediction) {
    return {{"pressure_gradient", prediction.nozzle.pressure_gradient},
            {"velocity_max", prediction.nozzle.velocity_max},
            {"elongational_stress_average", prediction.exit.elongational_stress}};
}

BulletState bullet_of(const Prediction& prediction) {
    const Case& question = prediction.question;
    return bullet({.pressure_gradient = prediction.nozzle.pressure_gradient,
                   .viscosity = viscosity(question.ink.law, 0.0),
                   .cell_radius = question.cell.radius,
                   .shear_modulus = question.cell.shear_modulus});
}

Values predicted_channel(const Prediction& prediction) {
    const BulletState state = bullet_of(prediction);
    return {{"von_mises", state.von_mises},
            {"stretch.0", 1.0},
            {"stretch.1", 1.0},
            {"stretch.2", 1.0},
            {"cell_velocity", prediction.nozzle.velocity_max + state.slip}};
}

Values predicted_exit(const Prediction& prediction) {
    const Case& question = prediction.question;
    Values values{{"von_mises_channel", bullet_of(prediction).von_mises}};
    const NozzleFlow flow =
        NozzleFlow::from_wall_rate(question.ink.law, question.radius, prediction.nozzle.shear_rate_max);
    try {
        const AxisPassage passage =
            exit_passage(flow, exit_passage_request(flow, {.radius = question.cell.radius,
                                                           .shear_modulus = question.cell.shear_modulus,
                                                           .viscosity_ratio = 1.0}))
                .passage;
        values["von_mises_peak"] = passage.peak.von_mises;
        values["stretch_axial_min"] = passage.axial_stretch_min;
        values["stretch_radial_max"] = passage.radial_stretch_max;
        values["peak_position"] = passage.peak.position;
    } catch (const Error&) {
        // The prediction itself says that the cell could not be followed.
    }
    values["relaxation_time"] =
        relaxation_time(viscosity(question.ink.law, 0.0), question.cell.shear_modulus, 1.0);
    return values;
}

NozzleFlow flow_of(const Prediction& prediction) {
    return NozzleFlow::from_wall_rate(prediction.question.ink.law, prediction.question.radius,
                                      prediction.nozzle.shear_rate_max);
}

EllipsoidState tank_treading(const Prediction& prediction, double fluid_stress, double shear_rate) {
    return roscoe_shear({.fluid_stress = fluid_stress,
                         .shear_rate = shear_rate,
                         .shear_modulus = prediction.question.cell.shear_modulus});
}

Values predicted_tank_treading(const Prediction& prediction, const SimulationResult& run) {
    const EllipsoidState cell = tank_treading(prediction, run.fluid_stress, run.shear_rate);
    return {{"von_mises", cell.von_mises},  {"stretch.0", cell.stretch[0]},
            {"stretch.1", cell.stretch[1]}, {"stretch.2", cell.stretch[2]},
            {"angle", cell.angle.value()},  {"frequency", cell.frequency.value()},
            {"viscous", cell.viscous}};
}

/// Faxén's law: a force-free sphere moves as the undisturbed ink does on average over its surface.
double sphere_velocity(const NozzleFlow& flow, double offset, double cell_radius) {
    constexpr int rings = 32;
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double along = -1.0 + (2.0 * i + 1.0) / rings;  // of the radius; equal shares of the surface
        const double across = cell_radius * std::sqrt(1.0 - along * along);
        for (int k = 0; k < rings; ++k) {
            const double turn = 2.0 * std::numbers::pi * (k + 0.5) / rings;
            const double r = std::hypot(offset + across * std::cos(turn), across * std::sin(turn));
            sum += flow.velocity(std::min(r, flow.radius()));
        }
    }
    return sum / (rings * rings);
}

Values predicted_off_axis_channel(const Prediction& prediction, const SimulationResult& run) {
    Values values = predicted_tank_treading(prediction, run);
    double offset = run.offset;
    for (const SimulatedValue& value : run.values) {
        if (value.name == "radial_position") offset = value.value;
    }
    values["cell_velocity"] = sphere_velocity(flow_of(prediction), offset, prediction.question.cell.radius);
    return values;
}

/// Where the simulated passage and the streamline's begin to count, in radii from the lip.
constexpr double exit_begins = -1.5;

double axial_width(const StreamlineState& s) {
    return std::hypot(s.stretch[0] * std::cos(s.angle), s.stretch[1] * std::sin(s.angle));
}

double radial_width(const StreamlineState& s) {
    return std::hypot(s.stretch[0] * std::sin(s.angle), s.stretch[1] * std::cos(s.angle));
}

Values predicted_off_axis_exit(const Prediction& prediction, const SimulationResult& run) {
    const Case& question = prediction.question;
    Values values{{"relaxation_time",
                   relaxation_time(viscosity(question.ink.law, 0.0), question.cell.shear_modulus, 1.0)}};
    try {
        double shortest = 1.0;
        double widest = 1.0;
        const StreamlinePassage passage =
            streamline_passage(flow_of(prediction),
                               {.start_radius = run.offset,
                                .shear_modulus = question.cell.shear_modulus,
                                .cell_radius = question.cell.radius,
                                .observe_every = 0.02 * question.radius},
                               [&](const StreamlineState& s) {
                                   if (s.position < exit_begins * question.radius) return;
                                   shortest = std::min(shortest, axial_width(s));
                                   widest = std::max(widest, radial_width(s));
                               });
        values["stretch_axial_min"] = shortest;
        values["stretch_radial_max"] = widest;
        values["von_mises_channel"] = passage.nozzle_steady;
        values["von_mises_peak"] = passage.exit_peak;
        values["peak_position"] = passage.exit_position;
    } catch (const Error&) {
        // The prediction itself says that the cell could not be followed.
    }
    return values;
}

Values predicted(const Prediction& prediction, const SimulationResult& run) {
    switch (run.scene) {
        case SceneKind::exit_flow:
            return predicted_exit_flow(prediction);
        case SceneKind::channel:
            return run.offset > 0.0 ? predicted_off_axis_channel(prediction, run)
                                    : predicted_channel(prediction);
        case SceneKind::shear:
            return predicted_tank_treading(prediction, run);
        case SceneKind::exit:
            break;
    }
    return run.offset > 0.0 ? predicted_off_axis_exit(prediction, run) : predicted_exit(prediction);
}

/// Roscoe's stress for the ink's stress at every sample of a channel.
void add_theory(const Prediction& prediction, SimulationSeries& series) {
    const auto column = std::find(series.columns.begin(), series.columns.end(), "fluid_stress [Pa]");
    if (column == series.columns.end()) return;
    const auto at = static_cast<std::size_t>(column - series.columns.begin());
    series.columns.emplace_back("von_mises_predicted [Pa]");
    for (std::vector<double>& row : series.rows) {
        row.push_back(tank_treading(prediction, row[at], 1.0).von_mises);
    }
}

}  // namespace

Scene scene_for(const Prediction& prediction, const SceneChoice& choice) {
    const Case& question = prediction.question;
    const bool by_pressure = question.drive == Drive::pressure_gradient || question.drive == Drive::pressure;
    const double local = 0.5 * prediction.nozzle.pressure_gradient * choice.offset;
    return {.kind = choice.kind,
            .ink = question.ink.law,
            .nozzle_radius = question.radius,
            .velocity_average = prediction.nozzle.velocity_average,
            .cell = {.radius = question.cell.radius, .shear_modulus = question.cell.shear_modulus},
            .drive = by_pressure ? ChannelDrive::pressure_gradient : ChannelDrive::flow_rate,
            .offset = choice.offset,
            .fluid_stress = choice.fluid_stress.value_or(local)};
}

Comparison compare(const Prediction& prediction, SimulationResult run) {
    Comparison comparison{.values = {}, .run = std::move(run)};
    const Values theory = predicted(prediction, comparison.run);
    for (const SimulatedValue& value : comparison.run.values) {
        const auto found = theory.find(value.name);
        comparison.values.push_back(
            {.name = value.name,
             .predicted = found == theory.end() ? std::nullopt : std::optional(found->second),
             .simulated = value.value,
             .error = value.error});
    }
    add_theory(prediction, comparison.run.series);
    return comparison;
}

Comparison compare_with_simulation(const Prediction& prediction, const SceneChoice& choice,
                                   const SimulationOptions& options) {
    return compare(prediction, simulate(scene_for(prediction, choice), options));
}

}  // namespace bioprint
