#pragma once

#include <array>
#include <functional>
#include <vector>

#include "bioprint/rheology/cross.hpp"

/// A cell beside the axis on its way through the nozzle's exit into the strand.
///
/// Half of nozzle and strand (mirror plane through the axis and the cell's centre), inflow with the ink's own
/// profile, a free-slip strand of the nozzle's radius. The cell first runs in a long nozzle for `settle`;
/// then the flow through the exit is brought to rest without it, and it is put in `approach` radii before the
/// lip. The run ends `travel` radii behind the lip.
namespace bioprint {

struct OffsetExitSetup {
    CrossInk ink;
    double radius;            ///< of the nozzle [m]
    double velocity_average;  ///< [m/s]
    double cell_radius;       ///< [m]
    double shear_modulus;     ///< of the cell [Pa]
    double offset;            ///< of the cell's centre where it starts in the long nozzle [m]
    double settle = 0.05;     ///< time in the long nozzle [s]
    double approach = 1.5;    ///< [radii]
    double travel = 3.0;      ///< [radii]
    double nodes = 6.0;       ///< cell radius, in lattice nodes
    double mesh_spacing = 2.0;
    bool single = true;  ///< fluid in single precision
    int samples = 200;
    int threads = 1;
    std::function<bool(double fraction)> progress{};  ///< false ends the run
};

struct OffsetExitSample {
    double time;                    ///< since the start before the lip [s]
    double position;                ///< of the centre behind the lip [m]
    double offset;                  ///< [m]
    double von_mises;               ///< mean over the cell [Pa]
    std::array<double, 3> stretch;  ///< the last is across the mirror plane
    double angle;                   ///< of the longest axis to the nozzle's [rad]
    double viscous;                 ///< [Pa]
    double volume;                  ///< over the rest volume
};

struct OffsetExitResult {
    std::vector<OffsetExitSample> series;
    double channel_von_mises;  ///< at the end of the long nozzle [Pa]
    double peak_von_mises;     ///< [Pa]
    double peak_position;      ///< behind the lip [m]
    bool flow_steady;          ///< the flow without the cell had come to rest
    bool complete;
    double time_step;  ///< [s]
    long steps;        ///< with the cell in the exit
    long nodes;
};

/// @throws UsageError, NoSteadyFlow, NotConverged  as run_offset_channel
OffsetExitResult run_offset_exit(const OffsetExitSetup& setup);

}  // namespace bioprint
