#pragma once

#include "bioprint/simulate/simulation.hpp"

namespace bioprint {

inline constexpr double nodes_of_known_errors = 6.0;  ///< a cell radius

/// What a simulation in space says of its own errors.
/// Errors fall with the square of the spacing, but for a stress in an ink that thins, where only the first order is
/// safe (channel at α 0.75: 821, 782 and 765 Pa at 3, 6 and 8.5 nodes). No value is extrapolated: the cell's mesh and
/// the rounding of the box make single values swing about that trend.
/// @param coarse  the same at half the nodes; null: none
void estimate_space_errors(SimulationResult& fine, const SimulationResult* coarse, const Scene& scene,
                           double nodes);

}  // namespace bioprint
