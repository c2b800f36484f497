#pragma once

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/simulate/simulation.hpp"

/// What the axisymmetric simulation says of its own errors, and what two resolutions of it say together. The figures are
/// the largest seen on scenes that were run finer or have an exact answer (data/extremes.csv, data/trade.json).
namespace bioprint {

/// Values and errors of the finer run from both, by how each value converges.
/// @param ratio  of the spacings
void extrapolate(SimulationResult& fine, const SimulationResult& coarse, const Scene& scene,
                 const NozzleFlow& flow, double ratio);

/// A run without a coarser one beside it: relative errors fall with the cell's radius in nodes.
void assume_errors(SimulationResult& result, const Scene& scene, const NozzleFlow& flow);

/// The nozzle's own gradient and velocity are known exactly: of those a run is off by what it is off.
void hold_against_nozzle(SimulationResult& result, const NozzleFlow& flow);

/// Where the contrast is large neither of two lattices resolves the ink around the cell, and their difference does not
/// tell how far both are off.
void allow_for_contrast(SimulationResult& result, const Scene& scene, const NozzleFlow& flow);

/// The lattice's lip acts as one a fraction of a node farther on, to first order in the spacing: the peak of
/// the flow tells how far, and every place is given from the effective lip.
void correct_lip(SimulationResult& fine, const SimulationResult& coarse, double ratio, double gradient);

}  // namespace bioprint
