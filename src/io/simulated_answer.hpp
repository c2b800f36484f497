#pragma once

#include <string_view>

#include "bioprint/io/quantity.hpp"
#include "bioprint/predict/comparison.hpp"
#include "io/answer_object.hpp"
#include "io/simulation_answer.hpp"

/// What a simulation adds to an answer.
namespace bioprint {

/// What a simulated value is called, and its dimension.
struct SimulatedName {
    std::string_view label;
    Dimension dimension;
};
SimulatedName simulated_name(std::string_view name);

/// The answer with its simulation.
Json simulated_answer_object(const Prediction& prediction, const Comparison& comparison,
                             const SimulationQuestion& question);

}  // namespace bioprint
