#pragma once

#include "bioprint/simulate/simulation.hpp"

/// The scenes that need three dimensions, behind the one face of simulation.hpp.
namespace bioprint {

/// A shear flow, or a cell off the axis.
bool needs_space(const Scene& scene);

/// Nodes a cell radius of the two runs of such a scene.
struct SpaceLattices {
    double nodes;
    double coarse_nodes;
    bool compare;  ///< the coarser run is made
};
SpaceLattices space_lattices(const Scene& scene, const SimulationOptions& options);
/// How long a shear scene may take, in γ̇ t, at this σ_f/μ.
double longest_shear(double load);

/// @throws UsageError  it cannot be followed at this resolution; says what would be
void check_space(const Scene& scene, const SimulationOptions& options);

/// Runs such a scene at the resolution asked for and, where it can carry a cell, at half of it.
/// @throws UsageError, SimulationIncomplete  as simulate()
SimulationResult simulate_in_space(const Scene& scene, const SimulationOptions& options);

}  // namespace bioprint
