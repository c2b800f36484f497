#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bioprint/io/quantity.hpp"
#include "bioprint/predict/comparison.hpp"
#include "io/answer_object.hpp"
#include "io/simulation_question.hpp"
#include "io/table.hpp"

/// What a simulation adds to an answer.
namespace bioprint {

/// What a simulated value is called, and its dimension.
struct SimulatedName {
    std::string_view label;
    Dimension dimension;
};
SimulatedName simulated_name(std::string_view name);

std::string_view scene_name(SceneKind scene);

/// Predicted over simulated, less 1; none where there is no such ratio.
std::optional<double> difference(const ComparedValue& value);
/// None for a run that did not get far enough to have its error estimated.
std::optional<double> stated_error(const ComparedValue& value);

/// Predicted, simulated, difference and numerical error in columns, and what the run remarks.
std::string simulation_table(const Comparison& comparison, const SimulationQuestion& question,
                             TableStyle style);

/// The answer with its simulation.
Json simulated_answer_object(const Prediction& prediction, const Comparison& comparison,
                             const SimulationQuestion& question);

}  // namespace bioprint
