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
/// nozzle. Simulated at α 0 and 1 kPa: 2.5 kPa after 60 ms at 1.4, 4.3 kPa after 40 ms at 1.9, 7.3 kPa after 30 ms at
/// 2.6, while the passage, which starts from the shape at 1.3, gives 1.8, 1.9 and 2.0 kPa.
inline constexpr double softest_bullet = 1.3;

/// What to ask of exit_passage for a cell: all effects of its size; where it keeps no shape in the nozzle, the shape it
/// has at the largest load at which it does, fading from 2.6 on.
///
/// Accuracy against simulations of α 0 to 0.75, 0.5 to 50 kPa, 5 to 100 mm/s, R_c/R 0.1 to 0.2: peak stress and both
/// strains within 5 % and the simulation's own error for G R_c/μ up to 0.64; of a nearly rigid cell
/// (G R_c/μ below 0.03) in a thinning ink the stress within 9 %, the small strains within 11 %; within 15 % for G R_c/μ up
/// to 1.3 (tests/validate/exit_passage.cpp).
ExitPassageRequest exit_passage_request(const NozzleFlow& flow, const AxisCell& cell);

/// @throws UsageError, NotConverged  as carry_along_axis
ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request);
ExitPassage exit_passage(const NozzleFlow& flow, const ExitPassageRequest& request,
                         FunctionRef<void(const AxisCellState&)> observe);

}  // namespace bioprint
