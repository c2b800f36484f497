#include "bioprint/predict/comparison.hpp"

#include <map>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/predict/exit_passage.hpp"

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
                   .viscosity = viscosity(cross_law(question.ink.law), 0.0),
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
        relaxation_time(viscosity(cross_law(question.ink.law), 0.0), question.cell.shear_modulus, 1.0);
    return values;
}

Values predicted(const Prediction& prediction, SceneKind scene) {
    switch (scene) {
        case SceneKind::exit_flow:
            return predicted_exit_flow(prediction);
        case SceneKind::channel:
            return predicted_channel(prediction);
        case SceneKind::exit:
            break;
    }
    return predicted_exit(prediction);
}

}  // namespace

Comparison compare(const Prediction& prediction, SimulationResult run) {
    const Values theory = predicted(prediction, run.scene);
    Comparison comparison{.values = {}, .run = std::move(run)};
    for (const SimulatedValue& value : comparison.run.values) {
        const auto found = theory.find(value.name);
        comparison.values.push_back(
            {.name = value.name,
             .predicted = found == theory.end() ? std::nullopt : std::optional(found->second),
             .simulated = value.value,
             .error = value.error});
    }
    return comparison;
}

Comparison compare_with_simulation(const Prediction& prediction, SceneKind scene,
                                   const SimulationOptions& options) {
    const Case& question = prediction.question;
    return compare(
        prediction,
        simulate({.kind = scene,
                  .ink = cross_law(question.ink.law),
                  .nozzle_radius = question.radius,
                  .velocity_average = prediction.nozzle.velocity_average,
                  .cell = {.radius = question.cell.radius, .shear_modulus = question.cell.shear_modulus}},
                 options));
}

}  // namespace bioprint
