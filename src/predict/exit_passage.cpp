#include "bioprint/predict/exit_passage.hpp"

#include <algorithm>

#include "predict/exit_axis.hpp"

namespace bioprint {
namespace {

// In nozzle radii: the exit is felt from 4 before it in the most thinning ink, and the stress has peaked long
// before 8.
constexpr double before = 4.0;
constexpr double after = 7.5;
/// G R_c/μ from which the shape of the nozzle fades: the softest cell passes as the ink itself does.
constexpr double bullet_fades = 2.6;

}  // namespace

ExitPassageRequest exit_passage_request(const NozzleFlow& flow, const AxisCell& cell) {
    ExitPassageRequest request{.cell = cell};
    const double load = flow.pressure_gradient() * cell.radius / cell.shear_modulus;
    if (load > softest_bullet) {
        request.effects.quadratic_share = softest_bullet / load * std::min(1.0, bullet_fades / load);
    }
    return request;
}

ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request,
                         FunctionRef<void(const AxisCellState&)> observe) {
    const ExitAxis axis(flow);
    const AxisWay way{
        .from = -before * flow.radius(), .to = after * flow.radius(), .observe_every = request.observe_every};
    AxisEffects effects = request.effects;
    // Deeper in the power law than the exit flows are known, the response of the ink to the cell is not
    // either.
    if (axis.extrapolated()) effects.disturbed_viscosity = false;
    return {.passage = carry_along_axis(axis, flow.ink(), request.cell, way, effects, observe),
            .extrapolated = axis.extrapolated()};
}

ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request) {
    return exit_passage(flow, request, [](const AxisCellState&) {});
}

}  // namespace bioprint
