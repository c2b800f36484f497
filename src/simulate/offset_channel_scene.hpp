#pragma once

#include <array>
#include <functional>
#include <vector>

#include "bioprint/rheology/cross.hpp"

/// A cell beside the axis of a long nozzle: it tank-treads, moves inward and is loaded by the local stress of
/// the ink.
///
/// Half a nozzle (mirror plane through the axis and the cell's centre), periodic over ten cell radii, started
/// from the exact flow of that ink without a cell. The cell starts as a sphere. Its viscosity is the ink's,
/// local rate by local rate. A centred cell (offset 0) is allowed; the axisymmetric scene does it better.
namespace bioprint {

enum class OffsetDrive { constant_gradient, constant_flow_rate };

struct OffsetChannelSetup {
    CrossInk ink;
    double radius;            ///< of the nozzle [m]
    double velocity_average;  ///< [m/s]
    double cell_radius;       ///< [m]
    double shear_modulus;     ///< of the cell [Pa]
    double offset;            ///< of the cell's centre at the start [m]
    double duration;          ///< [s]
    OffsetDrive drive = OffsetDrive::constant_gradient;
    double nodes = 6.0;         ///< cell radius, in lattice nodes
    double length = 10.0;       ///< of the period, in cell radii
    bool inside = true;         ///< couple through points inside the elements
    double mesh_spacing = 2.0;  ///< in lattice nodes
    bool single = true;         ///< fluid in single precision
    int samples = 200;
    int threads = 1;
    std::function<bool(double fraction)> progress{};  ///< called at every sample; false ends the run
};

struct OffsetChannelSample {
    double time;                    ///< [s]
    double path;                    ///< along the nozzle [m]
    double offset;                  ///< of the centre from the axis [m]
    double velocity;                ///< of the centre along the nozzle since the sample before [m/s]
    double von_mises;               ///< mean over the cell [Pa]
    double fluid_stress;            ///< of the undisturbed ink at the centre [Pa]
    std::array<double, 3> stretch;  ///< the last is across the mirror plane
    double angle;                   ///< of the longest axis to the nozzle's [rad]
    double frequency;               ///< angular frequency of the tank-treading [1/s]
    double viscous;                 ///< viscous shear stress in the ellipsoid's axes, from the lattice [Pa]
    double volume;                  ///< over the rest volume
    double pressure_gradient;       ///< [Pa/m]
};

struct OffsetChannelResult {
    std::vector<OffsetChannelSample> series;
    std::vector<std::array<double, 3>> shape;  ///< nodes of the mesh about the centre, in cell radii
    bool complete;                             ///< false when `progress` ended the run
    double time_step;                          ///< [s]
    double radius_lu;                          ///< of the nozzle, in nodes
    long steps;
    long nodes;
};

/// @throws UsageError    a value out of range, or the cell too near the wall
/// @throws NoSteadyFlow  the ink cannot flow so
/// @throws NotConverged  the cell broke or touched the wall
OffsetChannelResult run_offset_channel(const OffsetChannelSetup& setup);

}  // namespace bioprint
