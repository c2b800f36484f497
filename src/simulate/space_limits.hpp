#pragma once

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/simulate/simulation.hpp"

/// What is known to fail off the axis of a nozzle, before it is run.
namespace bioprint {

/// A cell off the axis is drawn out farther than the lattice follows from some σ_f/μ on, σ_f the ink's stress at its
/// centre. Drafts, α 0, 0.4 and 0.75, 1.2 to 4.2 R_c off the axis: all keep a shape up to 1.85, elements turn inside out from
/// 2.0 (α 0.75, 3 R_c) to 3.0 (α 0.4, 1.2 R_c) on.
/// @throws UsageError  it is softer, and no time in the nozzle was given
void check_offset_softness(const Scene& scene, const NozzleFlow& flow, const SimulationOptions& options);

/// A stiff cell in a slow flow crosses the exit in ever more steps.
/// @throws UsageError  naming the stiffest cell that fits and bears the same stress
void check_offset_duration(const Scene& scene, const NozzleFlow& flow, double nodes);

}  // namespace bioprint
