#pragma once

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/predict/prediction.hpp"

namespace bioprint {

/// Writes beside every number of an answer how far its model was off where it was measured.
///
/// The nozzle's flow is held against references of fifty digits, exit and cells against simulations: ladder.hpp and,
/// for centred cells at the exit, the prints of print_errors.hpp. Both were made with Cross inks of α up to 0.75 and
/// K u_avg/R up to 100, cells of the ink's viscosity inside and of up to a fifth of the nozzle's radius. For other
/// questions, for a cell within one radius of the wall and for one too soft to keep a shape nothing was measured, and
/// nothing is stated. A smaller cell is the easier question: the theory is that of a small one.
void state_errors(Prediction& prediction, const NozzleFlow& flow);

}  // namespace bioprint
