#pragma once

#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/immersed_cell.hpp"
#include "simulate/lattice_units.hpp"
#include "simulate/run_log.hpp"

/// One run of each scene at one resolution; each leaves its values, series and warnings in the log.
namespace bioprint {

/// Where the effective lip lies behind the lattice's, in nodes: half-way bounce-back leaves it undetermined
/// to first order, the more so the stronger the thinning. Two resolutions tell.
struct Run {
    const Scene& scene;
    const NozzleFlow& flow;
    int layers;
    int nodes;
    RunLog& log;
};

void run_exit_flow(const Run& run);

/// A cell in the channel once its shape has settled.
struct ChannelState {
    std::vector<solid::RingPoint> positions;  ///< about the cell's centre, lattice units
    bool steady;
};
ChannelState run_channel(const Run& run);

void run_exit(const Run& run);

/// The cell as the scene and options want it, in lattice units.
ImmersedCellSetup cell_setup(const Run& run, const LatticeUnits& units);
void report(const Run& run, const LatticeUnits& units, int length);

}  // namespace bioprint
