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

/// @throws UsageError, NotConverged  as carry_along_axis
ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request);
ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request,
                         FunctionRef<void(const AxisCellState&)> observe);

}  // namespace bioprint
