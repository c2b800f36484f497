#pragma once

#include <array>
#include <string>
#include <vector>

#include "bioprint/rheology/cross.hpp"
#include "simulate/watch.hpp"

/// A cell beside the axis of a long nozzle: it tank-treads, moves inward and is loaded by the local stress of
/// the ink.
///
/// Half a nozzle (mirror plane through the axis and the cell's centre), periodic over ten cell radii, started
/// from the exact flow of that ink without a cell. The cell starts as a sphere. Its viscosity is the ink's,
/// local rate by local rate. A centred cell (offset 0) is allowed; the axisymmetric scene does it better.
///
/// The cell may be held at its offset: what it drifts is taken back at every sample, and only its drift is
/// reported. The run ends when the stress, as a share of the ink's where the cell is, has stood still for twice
/// the time a cell needs to answer its load: 5/2 η/μ, or 2/γ̇ where that is shorter.
namespace bioprint {

enum class OffsetDrive { constant_gradient, constant_flow_rate };

struct OffsetChannelSetup {
    CrossInk ink;
    double radius;            ///< of the nozzle [m]
    double velocity_average;  ///< [m/s]
    double cell_radius;       ///< [m]
    double shear_modulus;     ///< of the cell [Pa]
    double offset;            ///< of the cell's centre at the start [m]
    double duration;          ///< at most [s]
    double settle_tolerance =
        0.0;  ///< spread of that stress which counts as none; 0: the whole duration runs
    bool hold_offset = false;
    OffsetDrive drive = OffsetDrive::constant_gradient;
    double nodes = 6.0;         ///< cell radius, in lattice nodes
    double length = 10.0;       ///< of the period, in cell radii
    bool inside = true;         ///< couple through points inside the elements
    double mesh_spacing = 2.0;  ///< in lattice nodes
    bool single = true;         ///< fluid in single precision
    int samples = 200;
    int threads = 1;
    SceneWatch watch = {};
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
    double migration;  ///< velocity of the centre away from the axis since the sample before [m/s]
};

/// How a scene with a cell beside the axis was resolved.
struct OffsetLattice {
    double spacing = 0.0;        ///< [m]
    double time_step = 0.0;      ///< [s]
    double radius = 0.0;         ///< of the nozzle, in nodes
    int length = 0;              ///< in nodes
    double velocity = 0.0;       ///< average, in lattice units
    double viscosity = 0.0;      ///< at no shear, in lattice units
    double wall_reynolds = 0.0;  ///< of unsteadiness
    double shear_modulus = 0.0;  ///< in lattice units
    std::string binding = {};    ///< the limit that set the time step
};

struct OffsetChannelResult {
    std::vector<OffsetChannelSample> series;
    std::vector<std::array<double, 3>> shape;  ///< nodes of the mesh about the centre, in cell radii
    bool complete;                             ///< the run came to its end
    bool steady;                               ///< that end was a settled stress
    std::string stopped;                       ///< why it did not come to its end
    OffsetLattice lattice;
    long steps;
    long nodes;
};

/// What was reached when the cell broke, touched the wall or the run was ended is returned; `stopped` says why.
/// @throws UsageError    a value out of range, or the cell too near the wall
/// @throws NoSteadyFlow  the ink cannot flow so
OffsetChannelResult run_offset_channel(const OffsetChannelSetup& setup);

}  // namespace bioprint
