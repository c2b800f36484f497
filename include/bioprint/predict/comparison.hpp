#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bioprint/predict/prediction.hpp"
#include "bioprint/simulate/simulation.hpp"

/// A prediction held against a simulation of the same question.
namespace bioprint {

struct ComparedValue {
    std::string name;                 ///< "von_mises_peak", "stretch.0", …
    std::optional<double> predicted;  ///< by the theory; none where it says nothing
    double simulated;
    double error;  ///< estimated numerical error of the simulated value, in its unit
};

struct Comparison {
    std::vector<ComparedValue> values;
    SimulationResult run;
};

/// Simulates the scene for the case a prediction answered. A value that two theories predict is the better
/// one's.
/// @throws UsageError, NoSteadyFlow, SimulationIncomplete  as simulate()
Comparison compare_with_simulation(const Prediction& prediction, SceneKind scene,
                                   const SimulationOptions& options);

/// What a run that did not come to its end has to show.
Comparison compare(const Prediction& prediction, SimulationResult run);

}  // namespace bioprint
