#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "simulate/offset_channel_scene.hpp"

/// A cell beside the axis on its way through the nozzle's exit into the strand.
///
/// Half of nozzle and strand (mirror plane through the axis and the cell's centre), inflow with the ink's own
/// profile, a free-slip strand of the nozzle's radius. The cell first settles in a long nozzle, held at its
/// offset; then the flow through the exit is brought to rest without it, and it is put in `approach` radii
/// before the lip. `travel` radii behind the lip the strand is a plug: there the cell goes on in a strand of its
/// own, at rest when followed at its speed, until its stress is a few per cent of the peak.
namespace bioprint {

struct OffsetExitSetup {
    CrossInk ink;
    double radius;                  ///< of the nozzle [m]
    double velocity_average;        ///< [m/s]
    double cell_radius;             ///< [m]
    double shear_modulus;           ///< of the cell [Pa]
    double offset;                  ///< of the cell's centre where it starts in the long nozzle [m]
    double settle = 0.05;           ///< time in the long nozzle, at most [s]
    double settle_tolerance = 0.0;  ///< as in the channel scene
    double approach = 1.5;          ///< [radii]
    double travel = 2.5;            ///< [radii]
    double window = 1.0;            ///< of flow that is stepped before and behind the cell [radii]
    bool relax = true;              ///< go on in the strand
    double nodes = 6.0;             ///< cell radius, in lattice nodes
    double mesh_spacing = 2.0;
    bool single = true;  ///< fluid in single precision
    int samples = 200;
    int threads = 1;
    SceneWatch watch = {};
};

struct OffsetExitSample {
    double time;                    ///< since the start before the lip [s]
    double position;                ///< of the centre behind the lip [m]
    double offset;                  ///< [m]
    double von_mises;               ///< mean over the cell [Pa]
    std::array<double, 3> stretch;  ///< the last is across the mirror plane
    double axial;                   ///< width along the nozzle over that at rest
    double radial;                  ///< width away from the axis over that at rest
    double angle;                   ///< of the longest axis to the nozzle's [rad]
    double viscous;                 ///< [Pa]
    double volume;                  ///< over the rest volume
};

struct OffsetExitResult {
    std::vector<OffsetExitSample> series;
    OffsetChannelResult channel;  ///< the long nozzle
    double channel_von_mises;     ///< at its end [Pa]
    double peak_von_mises;        ///< from the start before the lip on [Pa]
    double peak_position;         ///< behind the lip [m]
    double axial_min;             ///< least width along the nozzle over that at rest
    double radial_max;
    std::optional<double>
        relaxation_time;  ///< [s]; none when the stress did not fall to a twentieth of its peak
    bool flow_steady;     ///< the flow without the cell had come to rest
    bool complete;
    std::string stopped;    ///< why it is not complete
    OffsetLattice lattice;  ///< of the exit
    long steps;             ///< of all stages
    double updates;         ///< of nodes, in all stages
    long nodes;             ///< of the exit
};

/// @throws UsageError, NoSteadyFlow  as run_offset_channel
OffsetExitResult run_offset_exit(const OffsetExitSetup& setup);

}  // namespace bioprint
