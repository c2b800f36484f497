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

/// Which scene of a case to simulate.
struct SceneChoice {
    SceneKind kind;
    double offset = 0.0;  ///< of the cell from the axis [m]
    std::optional<double> fluid_stress =
        {};  ///< of the shear scene [Pa]; none: that of the ink at the offset
};

/// The scene of the case a prediction answered. The channel keeps what drives the flow: the pressure gradient when a
/// pressure or its gradient was given, the flow rate otherwise.
Scene scene_for(const Prediction& prediction, const SceneChoice& choice);

/// A value that two theories predict is the better one's. Off the axis that is Roscoe's ellipsoid at the ink's
/// stress where the cell is (shear, channel) and the ellipsoid on its streamline (exit); a channel's series gets a
/// column with the theory's stress along the way.
Comparison compare(const Prediction& prediction, SimulationResult run);

/// Simulates the scene and compares.
/// @throws UsageError, NoSteadyFlow, SimulationIncomplete  as simulate()
Comparison compare_with_simulation(const Prediction& prediction, const SceneChoice& choice,
                                   const SimulationOptions& options);

}  // namespace bioprint
