#include "bioprint/predict/exit_passage.hpp"

#include "predict/exit_axis.hpp"

namespace bioprint {
namespace {

// In nozzle radii: the exit is felt from 4 before it in the most thinning ink, and the stress has peaked long
// before 8.
constexpr double before = 4.0;
constexpr double after = 7.5;

}  // namespace

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
