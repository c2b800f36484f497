#include <algorithm>
#include <cmath>

#include "io/simulated_answer.hpp"

// A simulation as a member of the answer.

namespace bioprint {
namespace {

std::string_view drive_name(ChannelDrive drive) {
    return drive == ChannelDrive::flow_rate ? "flow_rate" : "pressure_gradient";
}

Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// A map of values; "stretch.0" to "stretch.2" become one list.
template <class Pick>
Json values_object(const std::vector<ComparedValue>& values, const Pick& pick) {
    Json object = Json::object();
    for (const ComparedValue& value : values) {
        const std::optional<double> picked = pick(value);
        const Json number = picked ? finite(*picked) : Json(nullptr);
        if (value.name.starts_with("stretch.")) {
            object["stretch"].push_back(number);
        } else {
            object[value.name] = number;
        }
    }
    return object;
}

Json lattice_object(const LatticeReport& lattice) {
    return {{"nodes_per_radius", lattice.nodes_per_radius},
            {"length", lattice.length},
            {"nodes_per_cell_radius", finite(lattice.nodes_per_cell_radius)},
            {"spacing", finite(lattice.spacing)},
            {"time_step", finite(lattice.time_step)},
            {"velocity", finite(lattice.velocity)},
            {"viscosity", finite(lattice.viscosity)},
            {"wall_reynolds", finite(lattice.wall_reynolds)},
            {"shear_modulus", finite(lattice.shear_modulus)},
            {"binding", lattice.binding},
            {"vector_width", lattice.vector_width}};
}

Json series_object(const SimulationSeries& series) {
    Json object = Json::object();
    for (std::size_t column = 0; column < series.columns.size(); ++column) {
        Json numbers = Json::array();
        for (const std::vector<double>& row : series.rows) numbers.push_back(finite(row.at(column)));
        object[series.columns[column]] = std::move(numbers);
    }
    return object;
}

Json simulation_object(const Comparison& comparison, const SimulationQuestion& question) {
    const SimulationResult& run = comparison.run;
    Json object;
    object["scene"] = scene_name(run.scene);
    object["fidelity"] = fidelity_name(question);
    if (run.scene != SceneKind::exit_flow) object["offset"] = finite(run.offset);
    if (run.scene == SceneKind::channel) object["drive"] = drive_name(run.drive);
    if (run.fluid_stress > 0.0) object["fluid_stress"] = finite(run.fluid_stress);
    object["lattice"] = lattice_object(run.lattice);
    object["steps"] = run.steps;
    object["wall_time"] = finite(run.wall_time);
    object["updates_per_second"] = finite(run.updates_per_second);
    object["predicted"] = values_object(comparison.values, [](const auto& v) { return v.predicted; });
    object["simulated"] =
        values_object(comparison.values, [](const auto& v) { return std::optional(v.simulated); });
    object["difference"] = values_object(comparison.values, [](const auto& v) { return difference(v); });
    object["error"] = values_object(comparison.values, [](const auto& v) { return stated_error(v); });
    object["series"] = series_object(run.series);
    return object;
}

}  // namespace

std::string_view scene_name(SceneKind scene) {
    switch (scene) {
        case SceneKind::exit_flow:
            return "exit-flow";
        case SceneKind::channel:
            return "channel";
        case SceneKind::exit:
            return "exit";
        case SceneKind::shear:
            return "shear";
    }
    return "";
}

std::optional<double> difference(const ComparedValue& value) {
    if (!value.predicted || value.simulated == 0.0) return std::nullopt;
    return *value.predicted / value.simulated - 1.0;
}

/// None for a run that did not get far enough to have its error estimated.
std::optional<double> stated_error(const ComparedValue& value) {
    return value.error > 0.0 ? std::optional(value.error) : std::nullopt;
}

Json simulated_answer_object(const Prediction& prediction, const Comparison& comparison,
                             const SimulationQuestion& question) {
    Json answer = answer_object(prediction);
    answer["simulation"] = simulation_object(comparison, question);
    for (const SimulationWarning& warning : comparison.run.warnings) {
        std::string code = warning.code;
        std::replace(code.begin(), code.end(), '-', '_');
        answer["warnings"].push_back({{"code", code}, {"message", warning.message}});
    }
    return answer;
}

}  // namespace bioprint
