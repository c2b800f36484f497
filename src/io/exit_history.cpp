#include "io/exit_history.hpp"

#include "bioprint/predict/exit_passage.hpp"

namespace bioprint {
namespace {

constexpr int points_a_radius = 40;

}  // namespace

std::vector<AxisCellState> exit_history(const Case& question, const Prediction& prediction) {
    const NozzleFlow flow =
        NozzleFlow::from_wall_rate(question.ink.law, question.radius, prediction.nozzle.shear_rate_max);
    ExitPassageRequest request =
        exit_passage_request(flow, {.radius = question.cell.radius,
                                    .shear_modulus = question.cell.shear_modulus,
                                    .viscosity_ratio = question.cell.viscosity_ratio});
    request.observe_every = question.radius / points_a_radius;
    std::vector<AxisCellState> states;
    exit_passage(flow, request, [&](const AxisCellState& state) { states.push_back(state); });
    return states;
}

}  // namespace bioprint
