#include <algorithm>
#include <cmath>
#include <iterator>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_exit.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/predict/prediction.hpp"
#include "numerics/brief.hpp"
#include "predict/carried_cells.hpp"
#include "predict/resting_ink.hpp"
#include "predict/stated_errors.hpp"
#include "predict/warnings.hpp"

namespace bioprint {
namespace {

void require_sound(const Case& question) {
    const std::vector<std::string> problems = problems_of(question);
    if (problems.empty()) return;
    std::string message = problems.front();
    for (std::size_t i = 1; i < problems.size(); ++i) message += "\n" + problems[i];
    throw UsageError(message);
}

/// A pressure that does not move the ink, in the words of the question.
void require_yielding(const Case& question) {
    const double yield = yield_stress(question.ink.law);
    if (question.drive != Drive::pressure || yield == 0.0 || question.drive_value == 0.0) return;
    const double threshold = 2.0 * yield * question.length.value() / question.radius;
    if (question.drive_value > threshold) return;
    throw NoSteadyFlow("no flow: a pressure of " + brief(question.drive_value) +
                       " Pa over this nozzle stays within the ink's yield stress of " + brief(yield) +
                       " Pa; it flows above " + brief(threshold) + " Pa");
}

NozzleFlow flow_of(const Case& question) {
    require_yielding(question);
    const Ink& law = question.ink.law;
    switch (question.drive) {
        case Drive::flow_rate:
            return NozzleFlow::from_flow_rate(law, question.radius, question.drive_value);
        case Drive::velocity:
            return NozzleFlow::from_velocity(law, question.radius, question.drive_value);
        case Drive::pressure_gradient:
            return NozzleFlow::from_pressure_gradient(law, question.radius, question.drive_value);
        case Drive::pressure:
            break;
    }
    return NozzleFlow::from_pressure_gradient(law, question.radius,
                                              question.drive_value / question.length.value());
}

/// As lengths; without any asked for, the paper's four, as far as they fit.
std::vector<CellPosition> resolve_positions(const Case& question) {
    const double largest = question.radius - question.cell.radius;
    std::vector<CellPosition> positions;
    if (question.positions.empty()) {
        for (const double radii : {0.0, 1.5, 3.0, 4.5}) {
            if (radii * question.cell.radius <= largest) positions.push_back({radii * question.cell.radius});
        }
        return positions;
    }
    for (const CellPosition& p : question.positions) {
        positions.push_back({std::min(p.in_cell_radii ? p.value * question.cell.radius : p.value, largest)});
    }
    return positions;
}

NozzleAnswer nozzle_answer(const NozzleFlow& flow, const Case& question) {
    NozzleAnswer answer{.flow_rate = flow.flow_rate(),
                        .pressure_gradient = flow.pressure_gradient(),
                        .velocity_average = flow.velocity_average(),
                        .velocity_max = flow.velocity_max(),
                        .shear_rate_max = flow.shear_rate_max(),
                        .shear_rate_average = flow.shear_rate_average(),
                        .stress_max = flow.stress_max(),
                        .stress_average = flow.stress_average(),
                        .viscosity_wall = viscosity(flow.ink(), flow.shear_rate_max()),
                        .pressure_drop = std::nullopt,
                        .residence_time = std::nullopt,
                        .plug_radius = std::nullopt};
    if (yield_stress(flow.ink()) > 0.0) answer.plug_radius = flow.plug_radius();
    if (question.drive == Drive::flow_rate) answer.flow_rate = question.drive_value;
    if (question.length) {
        answer.pressure_drop = question.drive == Drive::pressure
                                   ? question.drive_value
                                   : flow.pressure_gradient() * *question.length;
        if (flow.velocity_average() > 0.0) answer.residence_time = *question.length / flow.velocity_average();
    }
    return answer;
}

void fill(CellAnswer& answer, const EllipsoidState& state) {
    answer.stretch = state.stretch;
    answer.angle = state.angle;
    answer.frequency = state.frequency;
    answer.stress =
        CellStress{.von_mises = state.von_mises, .elastic = state.elastic, .viscous = state.viscous};
}

CellAnswer cell_in_nozzle(const NozzleFlow& flow, const CellChoice& cell, double offset) {
    if (offset == 0.0) {
        CellAnswer answer = blank_cell(Place::nozzle, Model::bullet, 0.0, 0.0, cell);
        // A plug that holds the whole cell carries it without a load.
        const BulletState state =
            bullet({.pressure_gradient = inside_plug(flow, cell.radius) ? 0.0 : flow.pressure_gradient(),
                    .viscosity = 1.0,  // of the slip alone
                    .cell_radius = cell.radius,
                    .shear_modulus = cell.shear_modulus});
        // To the order of the theory the cell keeps its length and width, and its mean stress components
        // vanish: the load is in the von Mises stress, which has no sign to cancel.
        answer.stretch = {1.0, 1.0, 1.0};
        answer.stress = CellStress{.von_mises = state.von_mises, .elastic = {0.0, 0.0, 0.0}, .viscous = 0.0};
        return answer;
    }
    const double fluid_stress = flow.stress(offset);
    CellAnswer answer = blank_cell(Place::nozzle, Model::roscoe_shear, offset, fluid_stress, cell);
    const double rate = flow.shear_rate(offset);
    const bool in_plug = rate == 0.0 && fluid_stress > 0.0 && yield_stress(flow.ink()) > 0.0;
    try {
        fill(answer, roscoe_shear({.fluid_stress = in_plug ? 0.0 : fluid_stress,
                                   .shear_rate = rate,
                                   .shear_modulus = cell.shear_modulus,
                                   .viscosity_ratio = cell.viscosity_ratio}));
        if (in_plug) answer.angle = answer.frequency = std::nullopt;
    } catch (const NotConverged&) {
        // A stress ratio past what numbers hold: the entry stays empty, `beyond_range` says so.
    }
    return answer;
}

CellAnswer cell_in_exit(const NozzleFlow& flow, const ExitAnswer& exit, const CellChoice& cell) {
    CellAnswer answer =
        blank_cell(Place::exit, Model::roscoe_elongation, 0.0, exit.elongational_stress, cell);
    const std::optional<EllipsoidState> state =
        roscoe_elongation({.fluid_stress = exit.elongational_stress,
                           .shear_modulus = cell.shear_modulus,
                           .direction = ElongationDirection::compression});
    if (state) fill(answer, *state);
    answer.relaxation_time = strand_relaxation(flow.ink(), cell.shear_modulus, cell.viscosity_ratio);
    return answer;
}

void add_population(const NozzleFlow& flow, unsigned jobs, Prediction& prediction) {
    const Case& question = prediction.question;
    if (flow.velocity_average() == 0.0) {
        prediction.warnings.push_back({"no_population", "nothing flows, so no cell is printed"});
        return;
    }
    try {
        prediction.population = population(flow, {.cell_radius = question.cell.radius,
                                                  .shear_modulus = question.cell.shear_modulus,
                                                  .viscosity_ratio = question.cell.viscosity_ratio,
                                                  .length = question.length,
                                                  .thresholds = question.thresholds,
                                                  .jobs = jobs});
    } catch (const Error& e) {
        prediction.warnings.push_back(
            {"no_population", std::string("the cells could not all be followed: ") + e.what()});
    }
}

RadialProfile profile_of(const NozzleFlow& flow, int points) {
    RadialProfile profile;
    for (int i = 0; i < points; ++i) {
        const double r = i == points - 1 ? flow.radius() : flow.radius() * i / (points - 1);
        const double rate = flow.shear_rate(r);
        profile.r.push_back(r);
        profile.velocity.push_back(flow.velocity(r));
        profile.shear_rate.push_back(rate);
        profile.viscosity.push_back(viscosity(flow.ink(), rate));
        profile.stress.push_back(flow.stress(r));
    }
    return profile;
}

[[noreturn]] void refuse_range() {
    throw NoSteadyFlow(
        "no steady flow: the inputs are so far apart that the answer is beyond any number; check the "
        "units of radius, load, ink and cell");
}

/// The inputs are finite, but their product need not be: 1e300 Pa over 1e-300 m is no pressure gradient.
void require_finite(const NozzleAnswer& nozzle, const ExitAnswer& exit) {
    for (const double value : {nozzle.flow_rate, nozzle.pressure_gradient, nozzle.velocity_max,
                               nozzle.shear_rate_max, nozzle.stress_max, nozzle.pressure_drop.value_or(0.0),
                               nozzle.residence_time.value_or(0.0), exit.elongational_stress}) {
        if (!std::isfinite(value)) refuse_range();
    }
}

void require_finite(const CellAnswer& cell) {
    const CellStress stress = cell.stress.value_or(CellStress{});
    for (const double value :
         {cell.stress_ratio, cell.frequency.value_or(0.0), cell.relaxation_time.value_or(0.0),
          stress.von_mises, stress.viscous, stress.elastic[0], stress.elastic[1], stress.elastic[2]}) {
        if (!std::isfinite(value)) refuse_range();
    }
}

}  // namespace

Prediction predict(const Case& question, unsigned jobs) {
    require_sound(question);
    const NozzleFlow flow = flow_of(question);
    const NozzleExit exit = nozzle_exit(flow);

    Prediction prediction{
        .question = question,
        .nozzle = nozzle_answer(flow, question),
        .exit = {.elongation_rate = exit.elongation_rate, .elongational_stress = exit.elongational_stress},
        .cells = {},
        .passages = {},
        .profile = std::nullopt,
        .population = std::nullopt,
        .warnings = {}};
    require_finite(prediction.nozzle, prediction.exit);
    prediction.question.positions = resolve_positions(question);
    std::optional<CarriedCells> carried;
    if (question.transient) carried.emplace(flow, prediction);
    for (const CellPosition& position : prediction.question.positions) {
        prediction.cells.push_back(cell_in_nozzle(flow, question.cell, position.value));
        if (position.value == 0.0) {
            prediction.cells.push_back(cell_in_exit(flow, prediction.exit, question.cell));
        }
        if (carried) carried->add(flow, position.value, prediction);
    }
    if (!std::isfinite(flow.pressure_gradient() * question.cell.radius / question.cell.shear_modulus))
        refuse_range();
    for (const CellAnswer& cell : prediction.cells) require_finite(cell);
    if (question.population) add_population(flow, jobs, prediction);
    if (question.profile_points > 0) prediction.profile = profile_of(flow, question.profile_points);
    judge_steady_models(prediction, flow);
    state_errors(prediction, flow);
    std::vector<Warning> warnings = warnings_of(prediction, flow);
    prediction.warnings.insert(prediction.warnings.begin(), std::make_move_iterator(warnings.begin()),
                               std::make_move_iterator(warnings.end()));
    return prediction;
}

}  // namespace bioprint
