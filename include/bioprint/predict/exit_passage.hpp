#pragma once

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/flow/nozzle_flow.hpp"

/// A cell on the axis through the end of the nozzle, in time: what the stationary theory (nozzle_exit.hpp
/// with roscoe.hpp) overestimates by a third to a factor of two and, past a few mm/s, cannot answer.
namespace bioprint {

struct ExitPassageRequest {
    AxisCell cell;
    AxisEffects effects = {};
    double observe_every =
        0.0;  ///< distance between calls of the observer [m]; 0: one a step of the integrator
};

struct ExitPassage {
    AxisPassage passage;  ///< positions count from the lip [m]
    bool extrapolated;    ///< the ink lies outside the tabulated exit flows; its thinning by the cell is then
                          ///< left out
};

/// A cell on the axis keeps a bullet's shape up to about this G R_c/μ; softer ones are stretched without end in the
/// nozzle (simulations find no steady shape at 2.6).
inline constexpr double softest_bullet = 1.3;

/// What to ask of exit_passage for a cell: all effects of its size where it keeps a shape in the nozzle, none where it
/// does not.
ExitPassageRequest exit_passage_request(const NozzleFlow& flow, const AxisCell& cell);

/// @throws UsageError, NotConverged  as carry_along_axis
ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request);
ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request,
                         FunctionRef<void(const AxisCellState&)> observe);

}  // namespace bioprint
