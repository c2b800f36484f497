#include "io/ladder_answer.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "bioprint/errors.hpp"
#include "io/simulation_answer.hpp"

namespace bioprint {
namespace {

double load_of(QuestionKind kind, const SceneChoice& scene, const Prediction& prediction) {
    const double modulus = prediction.question.cell.shear_modulus;
    switch (kind) {
        case QuestionKind::exit_flow:
            return 0.0;
        case QuestionKind::channel:
            return prediction.nozzle.pressure_gradient * prediction.question.cell.radius / modulus;
        case QuestionKind::exit:
            return prediction.exit.elongational_stress / modulus;
        case QuestionKind::channel_off_axis:
        case QuestionKind::exit_off_axis:
        case QuestionKind::shear:
            break;
    }
    const double offset = kind == QuestionKind::exit_off_axis
                              ? softness_offset(scene.offset, prediction.question.cell.radius)
                              : scene.offset;
    const double local = 0.5 * prediction.nozzle.pressure_gradient * offset;
    return scene.fluid_stress.value_or(local) / modulus;
}

QuestionKind kind_of(const SceneChoice& scene) {
    switch (scene.kind) {
        case SceneKind::exit_flow:
            return QuestionKind::exit_flow;
        case SceneKind::shear:
            return QuestionKind::shear;
        case SceneKind::channel:
            return scene.offset > 0.0 ? QuestionKind::channel_off_axis : QuestionKind::channel;
        case SceneKind::exit:
            break;
    }
    return scene.offset > 0.0 ? QuestionKind::exit_off_axis : QuestionKind::exit;
}

/// The questions of data/trade.json: α 0 to 0.75 and K u/R to 50, R_c/R 0.16, no cell near the wall, λ 1.
bool was_measured(QuestionKind kind, const SceneChoice& scene, const Case& question, double velocity) {
    constexpr double most_thinning = 0.75;
    constexpr double fastest = 50.0;
    constexpr double largest_cell = 0.2;
    constexpr double slack = 1.0 + 1e-6;
    const auto* const cross = std::get_if<CrossInk>(&question.ink.law);
    if (cross == nullptr) return false;
    if (kind != QuestionKind::exit_flow && question.cell.viscosity_ratio != 1.0) return false;
    if (kind == QuestionKind::shear) return true;  // the load alone counts
    if (cross->alpha > most_thinning * slack) return false;
    if (cross->alpha > 0.0 && cross->time_constant * velocity > fastest * slack * question.radius)
        return false;
    if (kind == QuestionKind::exit_flow) return true;
    return question.cell.radius <= largest_cell * slack * question.radius &&
           scene.offset + 2.0 * question.cell.radius <= question.radius * slack;
}

/// Where the longest time measured holds too: a cell beside the nozzle and a stiffness as in those questions.
bool was_timed(const RungRequest& request, const Case& question, double velocity) {
    constexpr double smallest_cell = 0.15;  // of the nozzle's radius
    constexpr double stiffest = 2.5e-3;     // load over shear modulus
    constexpr double slowest = 2.5;  // K u_avg/R of a thinning ink, whose flow takes the more steps to settle
    if (!request.measured) return false;
    if (request.kind == QuestionKind::exit_flow) {
        const auto* const cross = std::get_if<CrossInk>(&question.ink.law);
        return cross != nullptr &&
               (cross->alpha == 0.0 || cross->time_constant * velocity >= slowest * question.radius);
    }
    const bool size =
        request.kind == QuestionKind::shear || question.cell.radius >= smallest_cell * question.radius;
    return size && request.load >= stiffest;
}

/// What stands beside the answers of the two models themselves.
void heed_answers(const Prediction& prediction, const SceneChoice& scene, RungRequest& request) {
    const bool exit = request.kind == QuestionKind::exit || request.kind == QuestionKind::exit_off_axis;
    if (!exit && request.kind != QuestionKind::channel && request.kind != QuestionKind::channel_off_axis)
        return;
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.place != (exit ? Place::exit : Place::nozzle) || cell.offset != scene.offset || !cell.stress)
            continue;
        const Rung rung = cell.model == Model::ellipsoid ? Rung::ellipsoid : Rung::steady;
        RungOutlook& outlook = request.outlook.at(static_cast<std::size_t>(rung));
        outlook.unknown = !cell.error;
        outlook.least_error = cell.error.value_or(0.0);
    }
}

constexpr std::array<Rung, 3> simulations{Rung::draft, Rung::standard, Rung::fine};

}  // namespace

LadderAnswer climb(const Prediction& prediction, const LadderQuestion& question,
                   const SimulationQuestion* simulation) {
    SimulationQuestion asked = simulation == nullptr ? SimulationQuestion{} : *simulation;
    asked.resolution.reset();
    const ChosenScene chosen = choose_scene(asked, prediction);
    const QuestionKind kind = kind_of(chosen.scene);
    LadderAnswer answer{.request = {.kind = kind,
                                    .load = load_of(kind, chosen.scene, prediction),
                                    .tolerance = question.tolerance,
                                    .budget = question.budget,
                                    .simulated = simulation != nullptr,
                                    .measured = was_measured(kind, chosen.scene, prediction.question,
                                                             prediction.nozzle.velocity_average)},
                        .choice = {}};
    answer.timed = was_timed(answer.request, prediction.question, prediction.nozzle.velocity_average);
    heed_answers(prediction, chosen.scene, answer.request);
    for (const Rung rung : simulations) {
        RungOutlook& outlook = answer.request.outlook.at(static_cast<std::size_t>(rung));
        try {
            asked.resolution = resolution_of(rung);
            outlook.time = work_of(prediction, asked).most;
            const RungRecord* const record = measured(kind, rung, answer.request.load);
            if (record != nullptr && answer.timed) outlook.time = std::min(*outlook.time, record->longest);
        } catch (const UsageError& e) {
            outlook.refused = e.what();
        }
    }
    answer.choice = choose_rung(answer.request);
    return answer;
}

LadderAnswer after_run(LadderAnswer answer, Rung rung, RefinedRun run) {
    answer.choice.rung = rung;
    const auto chosen = std::find_if(answer.choice.ladder.begin(), answer.choice.ladder.end(),
                                     [&](const auto& v) { return v.rung == rung; });
    answer.choice.met = run.within && chosen->affordable;
    answer.run = std::move(run);
    return answer;
}

std::string_view judged_value(SceneKind scene) {
    if (scene == SceneKind::exit_flow) return "elongational_stress_average";
    return scene == SceneKind::exit ? "von_mises_peak" : "von_mises";
}

}  // namespace bioprint
