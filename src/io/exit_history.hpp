#pragma once

#include <vector>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/predict/prediction.hpp"

/// The centred cell on its way through the exit, for pictures.
namespace bioprint {

/// A state every fortieth of the nozzle's radius, from inside the nozzle into the strand.
/// @param prediction  the answer to `question`, in which something flows
std::vector<AxisCellState> exit_history(const Case& question, const Prediction& prediction);

}  // namespace bioprint
