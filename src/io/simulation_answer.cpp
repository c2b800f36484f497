#include "io/simulation_answer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/answer_checks.hpp"
#include "io/answer_object.hpp"
#include "io/answer_path.hpp"
#include "io/ladder_answer.hpp"
#include "io/row_answer.hpp"
#include "io/simulated_answer.hpp"
#include "io/table.hpp"

namespace bioprint {
namespace {

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

std::string_view drive_name(ChannelDrive drive) {
    return drive == ChannelDrive::flow_rate ? "flow_rate" : "pressure_gradient";
}

std::string_view fidelity_name(const SimulationQuestion& question) {
    if (question.resolution) return "custom";
    switch (question.fidelity) {
        case Fidelity::draft:
            return "draft";
        case Fidelity::standard:
            return "standard";
        case Fidelity::fine:
            return "fine";
    }
    return "";
}

Json finite(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::optional<double> difference(const ComparedValue& value) {
    if (!value.predicted || value.simulated == 0.0) return std::nullopt;
    return *value.predicted / value.simulated - 1.0;
}

/// None for a run that did not get far enough to have its error estimated.
std::optional<double> stated_error(const ComparedValue& value) {
    return value.error > 0.0 ? std::optional(value.error) : std::nullopt;
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

/// Returns a line for each check that does not hold.
std::vector<std::string> write(const Prediction& prediction, const Comparison& comparison,
                               const SimulationQuestion& question, const Settings& settings,
                               const RunOptions& options, const Sink& sink) {
    Json answer = simulated_answer_object(prediction, comparison, question);
    if (options.ladder) answer["choice"] = ladder_object(*options.ladder);
    const ExtraResults results = add_extras(answer, settings, options.extras, options.jobs, true);
    if (options.seen) options.seen(answer);
    if (!options.paths.empty()) {
        for (const std::string& path : options.paths) {
            sink(value_text(value_meant(answer, path)) + "\n");
        }
    } else if (options.format == Format::table) {
        sink(answer_table(prediction, options.style) + simulation_table(comparison, question, options.style) +
             extras_sections(answer, options.extras, results, options.style) +
             (options.ladder ? ladder_section(*options.ladder, options.style) : ""));
    } else {
        sink(json_text(answer, options.format == Format::json ? 2 : -1) + "\n");
    }
    CheckTally tally(options.extras.checks);
    tally.add(results.checks);
    return tally.lines();
}

/// Why a run that came to its end is not to be believed; empty when it is.
std::string breakdown(const SimulationResult& run) {
    const std::string remedy = "; lower the velocity, use a stiffer cell, or a higher --fidelity";
    for (const SimulatedValue& value : run.values) {
        const bool stress = value.name.starts_with("von_mises") || value.name.starts_with("stretch");
        if (!std::isfinite(value.value) || (stress && value.value < 0.0)) {
            return "the simulation broke down (" + value.name + ")" + remedy;
        }
    }
    for (const SimulationWarning& warning : run.warnings) {
        if (warning.code == "distorted-elements") return warning.message + remedy;
    }
    return {};
}

}  // namespace

namespace {

/// The numerical error of a scene's judged number, relative.
double own_error(const SimulationResult& run) {
    const SimulatedValue& value = run.at(std::string(judged_value(run.scene)));
    return std::abs(value.error / value.value);
}

SimulationOptions options_of(const SimulationQuestion& question, SimulationOptions options = {}) {
    options.resolution = resolution_of(question);
    options.channel_time = question.channel_time.value_or(0.0);
    return options;
}

SimulationQuestion finer_than(SimulationQuestion question) {
    const double resolution = 2.0 * resolution_of(question);
    if (question.resolution) {
        question.resolution = resolution;
    } else {
        question.fidelity = question.fidelity == Fidelity::draft ? Fidelity::standard : Fidelity::fine;
        if (resolution > resolution_of(Rung::fine)) question.resolution = resolution;
    }
    return question;
}

}  // namespace

std::string why_not_finer(const Prediction& prediction, const SimulationQuestion& question) {
    constexpr double finest_on_axis = 12.0;
    constexpr double finest_in_space = 6.0;
    const SimulationQuestion finer = finer_than(question);
    try {
        const SceneChoice scene = choose_scene(finer, prediction).scene;
        const bool in_space = scene.kind == SceneKind::shear || scene.offset > 0.0;
        if (resolution_of(finer) > (in_space ? finest_in_space : finest_on_axis))
            return "--resolution goes further";
        const LadderAnswer ladder = climb(prediction, {}, &finer);
        const auto rung = static_cast<std::size_t>(rung_of(resolution_of(finer)));
        const std::optional<double> time = finer.resolution ? std::optional(work_of(prediction, finer).most)
                                                            : ladder.choice.ladder.at(rung).time;
        check_simulation(prediction, finer);
        if (finer.budget && time > *finer.budget)
            return "a finer one takes up to " + lab_text(time.value_or(0.0), Dimension::time, 2) +
                   ", more than the budget";
    } catch (const UsageError& e) {
        return std::string("a finer one is refused: ") + e.what();
    }
    return {};
}

namespace {

/// Doubles the resolution until the run's own error is within the tolerance, or a finer one is out of reach.
Comparison refined(const Prediction& prediction, const SceneChoice& scene, SimulationQuestion& question,
                   const SimulationOptions& simulation, RefinedRun& how) {
    how = {.error = 0.0, .refined = false, .stop = {}};
    while (true) {
        Comparison comparison = compare_with_simulation(prediction, scene, options_of(question, simulation));
        how.error = own_error(comparison.run);
        if (how.error <= question.tolerance.value_or(1.0)) return comparison;
        how.stop = why_not_finer(prediction, question);
        if (!how.stop.empty()) return comparison;
        question = finer_than(question);
        how.refined = true;
    }
}

bool is_scene(std::string_view name) {
    return name == "shear" || name == "channel" || name == "exit-flow" || name == "exit" || name == "auto";
}

SceneKind kind_of(std::string_view name) {
    if (name == "shear") return SceneKind::shear;
    if (name == "exit-flow") return SceneKind::exit_flow;
    return name == "channel" ? SceneKind::channel : SceneKind::exit;
}

std::string in_micrometres(double offset) {
    return format_lab(offset, Dimension::length).number + " " + format_lab(offset, Dimension::length).unit;
}

/// Of the positions that `fits`, the one on the axis, else the first.
template <class Fits>
std::optional<double> pick_position(const std::vector<CellPosition>& positions, const Fits& fits) {
    std::optional<double> first;
    for (const CellPosition& p : positions) {
        if (!fits(p.value)) continue;
        if (p.value == 0.0) return 0.0;
        if (!first) first = p.value;
    }
    return first;
}

}  // namespace

SimulatedName simulated_name(std::string_view name) {
    const ValueName& value = label_of(name);
    return {.label = value.label, .dimension = value.dimension};
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

ChosenScene choose_scene(const SimulationQuestion& question, const Prediction& prediction) {
    if (!is_scene(question.scene)) {
        throw UsageError(
            "--simulate: got '" + question.scene + "'; it takes shear, channel, exit-flow, exit or auto",
            "--simulate");
    }
    ChosenScene chosen{.scene = {.kind = kind_of(question.scene)}, .remark = {}};
    const SceneKind kind = chosen.scene.kind;
    if (question.fluid_stress && kind != SceneKind::shear) {
        throw UsageError("--fluid-stress: belongs to --simulate=shear; elsewhere the flow sets it",
                         "--fluid-stress");
    }
    if (question.channel_time && kind != SceneKind::channel && kind != SceneKind::exit) {
        throw UsageError("--channel-time: belongs to the scenes channel and exit", "--channel-time");
    }
    if (kind == SceneKind::exit_flow) return chosen;
    if (kind == SceneKind::shear && question.fluid_stress) {
        chosen.scene.fluid_stress = question.fluid_stress;
        return chosen;
    }
    const auto& positions = prediction.question.positions;
    const std::optional<double> position =
        pick_position(positions, [&](double r) { return kind != SceneKind::shear || r > 0.0; });
    if (!position) {
        throw UsageError(
            "--simulate: the shear scene takes the ink's stress at a position off the axis and this question "
            "has "
            "none; add one to --offset, or give --fluid-stress",
            "--simulate");
    }
    chosen.scene.offset = *position;
    if (positions.size() > 1) {
        chosen.remark =
            "simulated: the cell " +
            (*position == 0.0 ? std::string("on the axis") : in_micrometres(*position) + " off the axis") +
            "; --offset chooses another";
    }
    return chosen;
}

double resolution_of(const SimulationQuestion& question) {
    if (question.resolution) return *question.resolution;
    switch (question.fidelity) {
        case Fidelity::draft:
            return 3.0;
        case Fidelity::standard:
            return 6.0;
        case Fidelity::fine:
            return 12.0;
    }
    return 6.0;
}

Rung rung_of(double resolution) {
    if (resolution <= 3.0) return Rung::draft;
    return resolution <= 6.0 ? Rung::standard : Rung::fine;
}

void check_simulation(const Prediction& prediction, const SimulationQuestion& question) {
    const ChosenScene chosen = choose_scene(question, prediction);
    if (chosen.scene.kind != SceneKind::exit_flow && prediction.question.cell.viscosity_ratio != 1.0) {
        throw UsageError(
            "--viscosity-ratio: the simulated cell is filled with the ink; leave it at 1 with --simulate",
            "--viscosity-ratio");
    }
    check_scene(scene_for(prediction, chosen.scene), options_of(question));
}

SimulationWork work_of(const Prediction& prediction, const SimulationQuestion& question) {
    check_simulation(prediction, question);
    return expected_work(scene_for(prediction, choose_scene(question, prediction).scene),
                         options_of(question));
}

namespace {

Comparison remarked(Comparison comparison, const ChosenScene& chosen) {
    if (!chosen.remark.empty()) {
        comparison.run.warnings.push_back({.code = "simulated-position", .message = chosen.remark});
    }
    return comparison;
}

}  // namespace

Json simulated_row(const Settings& settings, const SimulationQuestion& question,
                   const SimulationOptions& simulation) {
    const Prediction prediction = predict(settings.make_case());
    const ChosenScene chosen = choose_scene(question, prediction);
    check_simulation(prediction, question);
    const Comparison comparison =
        remarked(compare_with_simulation(prediction, chosen.scene, options_of(question, simulation)), chosen);
    const std::string failure = breakdown(comparison.run);
    if (!failure.empty()) throw NotConverged(failure);
    return simulated_answer_object(prediction, comparison, question);
}

std::vector<std::string> answer_with_simulation(
    const Settings& settings, SimulationQuestion question, RunOptions options, SimulationOptions simulation,
    const Sink& sink, SimulationFiles* files,
    const std::function<void(const Prediction&, const Comparison&)>& seen) {
    if (options.format == Format::csv) {
        throw UsageError("--format: a simulation is answered as table, json or jsonl", "--format");
    }
    const Prediction prediction = predict(settings.make_case());
    const ChosenScene chosen = choose_scene(question, prediction);
    check_simulation(prediction, question);
    if (files != nullptr) files->attach(simulation, question.snapshots);
    std::vector<std::string> failed;
    RefinedRun how{};
    try {
        Comparison comparison = remarked(
            question.tolerance
                ? refined(prediction, chosen.scene, question, simulation, how)
                : compare_with_simulation(prediction, chosen.scene, options_of(question, simulation)),
            chosen);
        if (options.ladder && question.tolerance)
            options.ladder = after_run(*options.ladder, rung_of(resolution_of(question)), how);
        if (const auto missed = options.ladder ? shortfall(*options.ladder) : std::nullopt)
            comparison.run.warnings.push_back({.code = missed->code, .message = missed->message});
        const std::string failure = breakdown(comparison.run);
        if (!failure.empty()) throw SimulationIncomplete(failure, comparison.run);
        if (files != nullptr) {
            files->write_series(comparison.run.series);
            files->write_answer(json_text(simulated_answer_object(prediction, comparison, question), 2) +
                                "\n");
        }
        failed = write(prediction, comparison, question, settings, options, sink);
        if (seen) seen(prediction, comparison);
    } catch (const SimulationIncomplete& e) {
        if (files != nullptr) files->write_series(e.result().series);
        write(prediction, remarked(compare(prediction, e.result()), chosen), question, settings, options,
              sink);
        throw;
    }
    // It is an answer, but not the one asked for.
    if (const auto missed = options.ladder ? shortfall(*options.ladder) : std::nullopt)
        throw SimulationIncomplete(missed->message, {});
    return failed;
}

}  // namespace bioprint
