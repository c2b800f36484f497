#pragma once

#include <string>
#include <vector>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/predict/prediction.hpp"
#include "io/settings.hpp"

/// The centred cell's way through the exit, place by place.
namespace bioprint {

/// A state every fortieth of the nozzle's radius, from inside the nozzle into the strand.
/// @param prediction  the answer to `question`, in which something flows
std::vector<AxisCellState> exit_history(const Case& question, const Prediction& prediction);

/// The same as CSV: x, time, stretches, stress of cell and ink, exposure.
/// @throws UsageError  nothing flows, and what make_case() and predict() throw
std::string history_csv(const Settings& settings);

}  // namespace bioprint
