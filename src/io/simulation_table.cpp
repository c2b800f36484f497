#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bioprint/io/number_format.hpp"
#include "io/simulated_answer.hpp"

// A simulation beside what was predicted, as a person reads it.

namespace bioprint {
namespace {

struct ValueName {
    std::string_view name;
    std::string_view label;
    Dimension dimension;
};

const ValueName& label_of(std::string_view name) {
    using enum Dimension;
    static constexpr std::array<ValueName, 23> names = {{
        {"pressure_gradient", "pressure gradient", Dimension::pressure_gradient},
        {"velocity_max", "largest velocity", velocity},
        {"radial_velocity_max", "largest radial velocity", velocity},
        {"elongational_stress_peak", "elongational stress, peak", pressure},
        {"elongational_stress_average", "elongational stress, average", pressure},
        {"excess_pressure", "excess pressure of the exit", pressure},
        {"von_mises", "von Mises stress", pressure},
        {"stretch.0", "stretch along the axis", dimensionless},
        {"stretch.1", "stretch across", dimensionless},
        {"stretch.2", "stretch across", dimensionless},
        {"cell_velocity", "cell velocity", velocity},
        {"deformation", "deformation", dimensionless},
        {"von_mises_channel", "von Mises in the nozzle", pressure},
        {"von_mises_peak", "von Mises, peak", pressure},
        {"stretch_axial_min", "least stretch along the axis", dimensionless},
        {"stretch_radial_max", "largest stretch across", dimensionless},
        {"peak_position", "peak behind the lip", length},
        {"relaxation_time", "relaxation time", time},
        {"angle", "inclination to the flow", dimensionless},
        {"frequency", "tank-treading frequency", rate},
        {"viscous", "viscous stress inside", pressure},
        {"radial_position", "distance from the axis", length},
        {"migration_velocity", "migration from the axis", velocity},
    }};
    static constexpr ValueName unknown{"", "value", dimensionless};
    const auto found =
        std::find_if(names.begin(), names.end(), [&](const ValueName& n) { return n.name == name; });
    return found == names.end() ? unknown : *found;
}

std::string shown(double value, const ValueName& name) {
    if (name.name == "angle") {
        return format_lab(value * 180.0 / std::numbers::pi, Dimension::dimensionless).number + " °";
    }
    return lab_text(value, name.dimension);
}

/// Off the axis the three stretches are those of the ellipsoid's own axes.
std::string label_in(const SimulationResult& run, const ValueName& name) {
    const bool in_space = run.scene == SceneKind::shear || run.offset > 0.0;
    if (in_space && name.name == "stretch.0") return "stretch, longest axis";
    if (in_space && name.name == "stretch.1") return "stretch, shortest axis";
    if (in_space && name.name == "stretch.2") return "stretch, sideways";
    return std::string(name.label);
}

/// "exit", "channel, cell 24 µm off the axis, flow rate kept", "shear at 300 Pa".
std::string scene_title(const SimulationResult& run) {
    std::string title(scene_name(run.scene));
    if (run.scene == SceneKind::shear)
        return title + " at " + lab_text(run.fluid_stress, Dimension::pressure);
    if (run.offset > 0.0) title += ", cell " + lab_text(run.offset, Dimension::length) + " off the axis";
    if (run.scene == SceneKind::channel) {
        title += run.drive == ChannelDrive::flow_rate ? ", flow rate kept" : ", pressure gradient kept";
    }
    return title;
}

}  // namespace

SimulatedName simulated_name(std::string_view name) {
    const ValueName& value = label_of(name);
    return {.label = value.label, .dimension = value.dimension};
}

std::string simulation_table(const Comparison& comparison, const SimulationQuestion& question,
                             TableStyle style) {
    std::vector<std::vector<std::string>> rows = {
        {"", "predicted", "simulated", "difference", "numerical error"}};
    const SimulationResult& run = comparison.run;
    const bool in_space = run.scene == SceneKind::shear || run.offset > 0.0;
    for (const ComparedValue& value : comparison.values) {
        const ValueName& name = label_of(value.name);
        if (value.name == "stretch.2" && !in_space) continue;  // as stretch.1
        const std::optional<double> off = difference(value);
        const std::optional<double> error = value.simulated == 0.0 ? std::nullopt : stated_error(value);
        rows.push_back(
            {label_in(run, name), value.predicted ? shown(*value.predicted, name) : "–",
             shown(value.simulated, name),
             off ? format_lab(100.0 * *off, Dimension::dimensionless, 2).number + " %" : "–",
             error ? format_lab(100.0 * std::abs(*error / value.simulated), Dimension::dimensionless, 2)
                             .number +
                         " %"
                   : "–"});
    }
    std::string text =
        "\n" + table_heading("Simulation: " + scene_title(run), style) + table_grid(rows, 1) + "  " +
        format_lab(run.lattice.nodes_per_cell_radius, Dimension::dimensionless, 3).number +
        " nodes a cell radius (" + std::string(fidelity_name(question)) + "), " + std::to_string(run.steps) +
        " steps in " + lab_text(run.wall_time, Dimension::time) + "\n";
    if (!style.quiet) {
        for (const SimulationWarning& warning : run.warnings) text += "  - " + warning.message + "\n";
    }
    return text;
}

}  // namespace bioprint
