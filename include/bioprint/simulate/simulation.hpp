#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/rheology/cross.hpp"
#include "bioprint/simulate/snapshot.hpp"

/// Simulation of one scene: lattice Boltzmann flow of the ink, and a neo-Hookean cell in it where the scene
/// has one.
///
///   exit_flow  the steady flow from the nozzle into the strand, no cell
///   channel    a cell inside the long nozzle, until its shape is steady
///   exit       that cell carried through the exit into the strand, until it has relaxed
///   shear      a cell between two plates that move in opposite directions, until its shape is steady
/// The first three are axisymmetric while the cell is on the axis. Off it they run in three dimensions, as does
/// shear: half of the scene, with a mirror plane through the axis and the cell's centre. The strand keeps the
/// nozzle's diameter and its surface is free of shear stress (no die swell).
///
/// Each run is made twice, at the resolution asked for and at half of it, and every value carries the numerical
/// error estimated from the two. On the axis, what converges with a known order is extrapolated; in space nothing
/// is. A cell of 3 nodes has no coarser run beside it (nor has one of less than 6 in space); its errors are those
/// measured on reference cases.
///
/// Accuracy (R_c = 6 nodes; tests/verify/simulate_channel.cpp, tests/validate/exit_flow.cpp,
/// tests/verify/space_simulation.cpp):
///   exit flow   peak and average stress 0.1 %, stress on the axis 0.3 % of the peak (finite elements)
///   channel     stress of a rigid sphere 0.5 %, its speed 0.01 %
///   exit        peak stress 2 %, stretches 1 % (runs at twice the resolution)
///   shear       every value 1 % (runs at twice the resolution)
///   in space    stress 5 % in an ink of α 0.75, 2 % in a Newtonian one
namespace bioprint {

enum class SceneKind { exit_flow, channel, exit, shear };

/// What is kept constant in the channel while the cell deforms.
enum class ChannelDrive { flow_rate, pressure_gradient };

struct SimulatedCell {
    double radius;         ///< [m]
    double shear_modulus;  ///< [Pa]
};

struct Scene {
    SceneKind kind = SceneKind::exit;
    CrossInk ink;
    double nozzle_radius;     ///< [m]; not read by shear, as is the velocity
    double velocity_average;  ///< [m/s]
    SimulatedCell cell{};     ///< not read by exit_flow, whose nozzle gets 6.25 times the resolution
    ChannelDrive drive = ChannelDrive::flow_rate;
    double offset = 0.0;  ///< of the cell's centre from the axis [m]: above 0, channel and exit in space
    double fluid_stress = 0.0;  ///< of the undisturbed ink [Pa]; read by shear alone
};

/// How the cell meets the lattice; the second is the usual way, kept for comparison with published
/// simulations.
enum class CellCoupling { inside_elements, at_vertices };

struct SimulationProgress {
    const char* stage;  ///< "flow", "channel", "exit", "strand", "shear"
    double done;        ///< of the stage, 0 … 1
};

/// A checkpoint: everything a simulation needs to go on to the same numbers. Parts are lists of numbers by
/// name, to be stored without loss.
struct SimulationState {
    std::map<std::string, std::vector<double>> parts;
};

struct SimulationOptions {
    double resolution = 6.0;     ///< lattice nodes a cell radius, ≥ 3 (draft 3, standard 6, fine 12)
    bool estimate_error = true;  ///< run at half the resolution too
    int threads = 1;  ///< on the axis two run both resolutions at once; the numbers do not depend on it
    double accuracy =
        8e-3;  ///< largest share of the lattice fluid's compression in the stress; sets the time step
    double settle_tolerance = 3e-3;  ///< of the cell's stress in the channel
    double channel_time = 0.0;       ///< the cell's time in the nozzle [s]; 0: until its shape is steady
    CellCoupling coupling = CellCoupling::inside_elements;
    double bulk_modulus_ratio = 0.0;  ///< κ/μ of the cell; 0 leaves its volume to the fluid
    double mesh_spacing = 1.52;       ///< lattice spacings an element
    std::function<void(const SimulationProgress&)> progress = {};
    const std::atomic<bool>* cancel = nullptr;
    /// Called `snapshots` times on the way of each stage and at its ends, from the thread that computes. The exit's
    /// way is that of the cell, the strand's the logarithm of its stress.
    std::function<void(const SimulationSnapshot&)> snapshot = {};
    int snapshots = 20;
    /// Called now and then and at the end, from the thread that computes, with what a later call can resume
    /// from.
    std::function<void(const SimulationState&)> checkpoint = {};
    double checkpoint_interval = 10.0;  ///< [s] of wall time; a cancelled run hands out its state at once
    const SimulationState* resume = nullptr;  ///< of the same scene and options
};

struct SimulatedValue {
    std::string name;     ///< as in the command's answer: "von_mises_peak", "stretch.0" …
    double value;         ///< SI; extrapolated from two resolutions where the order is known
    double error;         ///< estimated numerical error, SI; 0 when it was not estimated
    double resolved = 0;  ///< what the finer run alone gave
};

struct SimulationSeries {
    std::vector<std::string> columns;  ///< with units, "time [s]"
    std::vector<std::vector<double>> rows;
};

struct LatticeReport {
    int nodes_per_radius = 0;  ///< of the nozzle
    int length = 0;            ///< columns
    double nodes_per_cell_radius = 0.0;
    double spacing = 0.0;        ///< [m]
    double time_step = 0.0;      ///< [s]
    double velocity = 0.0;       ///< average velocity in lattice units
    double viscosity = 0.0;      ///< zero-shear viscosity in lattice units
    double wall_reynolds = 0.0;  ///< of unsteadiness
    double shear_modulus = 0.0;  ///< of the cell in lattice units
    std::string binding;         ///< the limit that set the time step
    std::string vector_width;    ///< of the kernels
};

struct SimulationWarning {
    std::string code;
    std::string message;
};

struct SimulationResult {
    SceneKind scene{};
    double offset = 0.0;        ///< of the cell's centre from the axis [m]
    double fluid_stress = 0.0;  ///< of the undisturbed ink where the cell is [Pa]; 0 on the axis
    double shear_rate = 0.0;    ///< there [1/s]
    ChannelDrive drive{};
    std::vector<SimulatedValue> values;
    LatticeReport lattice;
    long steps = 0;                   ///< of every run
    double wall_time = 0.0;           ///< [s]
    double updates_per_second = 0.0;  ///< node updates of all runs over the wall time
    SimulationSeries series;          ///< along the axis (exit_flow) or in time, at the resolution asked for
    SimulationSeries outline;         ///< of the cell, at the end of the channel and at the peak
    std::vector<SimulationWarning> warnings;

    /// @throws UsageError  there is no such value
    [[nodiscard]] const SimulatedValue& at(const std::string& name) const;
};

/// A run that was cancelled or broke down, with what it had.
class SimulationIncomplete : public NotConverged {
  public:
    SimulationIncomplete(const std::string& message, SimulationResult partial)
        : NotConverged(message), result_(std::move(partial)) {}
    [[nodiscard]] const SimulationResult& result() const { return result_; }

  private:
    SimulationResult result_;
};

/// Every check that simulate() makes before it takes memory and time.
/// @throws UsageError, NoSteadyFlow  as simulate()
void check_scene(const Scene& scene, const SimulationOptions& options = {});

/// @throws UsageError            the scene does not fit the lattice at any or at this resolution; says what
/// would
/// @throws NoSteadyFlow          from the nozzle flow
/// @throws SimulationIncomplete  cancelled, an element turned inside out, or no steady state in time
SimulationResult simulate(const Scene& scene, const SimulationOptions& options = {});

}  // namespace bioprint
