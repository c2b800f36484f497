#pragma once

#include "bioprint/simulate/simulation.hpp"

/// The scenes that need three dimensions, behind the one face of simulation.hpp.
namespace bioprint {

/// A shear flow, or a cell off the axis.
bool needs_space(const Scene& scene);

/// Runs such a scene at the resolution asked for and, where it can carry a cell, at half of it.
/// @throws UsageError, SimulationIncomplete  as simulate()
SimulationResult simulate_in_space(const Scene& scene, const SimulationOptions& options);

}  // namespace bioprint
