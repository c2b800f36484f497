#include "io/simulation_question.hpp"

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/ladder_answer.hpp"

namespace bioprint {
namespace {

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

SimulationOptions options_of(const SimulationQuestion& question, SimulationOptions options) {
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

}  // namespace bioprint
