#pragma once

#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/predict/prediction.hpp"

/// Where a prediction leaves the range in which it was checked.
namespace bioprint {

std::vector<Warning> warnings_of(const Prediction& prediction, const NozzleFlow& flow);

}  // namespace bioprint
