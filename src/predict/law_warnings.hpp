#pragma once

#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/predict/prediction.hpp"

/// What an ink's law leaves open: the cell in a plug, the viscosity at rest, the exit flow of laws other than Cross.
namespace bioprint {

void add_law_warnings(const Prediction& prediction, const NozzleFlow& flow, std::vector<Warning>& warnings);

}  // namespace bioprint
