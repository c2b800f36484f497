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

/// The two resolutions at which a scene on the axis runs.
struct AxisLattices {
    int layers;  ///< of the cell's mesh
    int nodes;   ///< a nozzle radius
    int coarse_layers;
    int coarse_nodes;
    bool compare;  ///< the coarser run is made
};
/// @throws UsageError  the lattice would be too large
AxisLattices axis_lattices(const Scene& scene, const SimulationOptions& options);

void run_exit_flow(const Run& run);

/// A cell in the channel once its shape has settled.
struct ChannelState {
    std::vector<solid::RingPoint> positions;  ///< about the cell's centre, lattice units
    bool steady;
};
ChannelState run_channel(const Run& run);

/// Of a run in the channel, known before it.
struct ChannelSteps {
    long sample;  ///< between two looks at the cell
    long most;    ///< until it ends in any case
    long rest;    ///< without change that count as steady: more than a turning point takes
};
ChannelSteps channel_steps(const Scene& scene, const NozzleFlow& flow, const LatticeUnits& units,
                           const SimulationOptions& options);
/// Columns of its periodic stretch of nozzle.
int channel_length(int nodes);

void run_exit(const Run& run);

/// The cell as the scene and options want it, in lattice units.
ImmersedCellSetup cell_setup(const Run& run, const LatticeUnits& units);
void report(const Run& run, const LatticeUnits& units, int length);

}  // namespace bioprint
