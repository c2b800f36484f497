#pragma once

#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/predict/prediction.hpp"

/// Where a prediction leaves the range in which it was checked.
namespace bioprint {

/// Says of each steady entry whether what it assumes holds.
void judge_steady_models(Prediction& prediction, const NozzleFlow& flow);

std::vector<Warning> warnings_of(const Prediction& prediction, const NozzleFlow& flow);

}  // namespace bioprint
