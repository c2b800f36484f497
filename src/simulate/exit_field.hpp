#pragma once

#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "lattice/axisymmetric.hpp"
#include "simulate/lattice_units.hpp"
#include "simulate/run_log.hpp"

/// The steady flow through the nozzle exit on the lattice.
namespace bioprint {

struct ExitField {
    lattice::AxisymmetricFlow flow;
    LatticeUnits units;
};

/// How far the domain reaches beyond the lip, in nozzle radii.
struct ExitReach {
    double upstream;
    double downstream;
};
/// Strong thinning lets the exit be felt farther upstream.
ExitReach exit_reach(const Ink& ink);

/// The developed profile before the lip and a plug behind it, in the units in which it settles soonest.
ExitField unsettled_exit_flow(const NozzleFlow& flow, int nodes, const ExitReach& reach);
ExitField unsettled_exit_flow(const NozzleFlow& flow, int nodes, const ExitReach& reach,
                              const LatticeUnits& units);
inline constexpr long exit_step_limit = 4'000'000;

/// Starts from the developed profile at large viscosity and runs until steady.
/// @throws SimulationIncomplete  cancelled or not steady in time
ExitField settle_exit_flow(const NozzleFlow& flow, int nodes, const ExitReach& reach, double tolerance,
                           RunLog& log);

/// The flow on the axis, SI; x from the lip's columns.
struct AxisProfile {
    std::vector<double> x, velocity, rate, stress, pressure;  ///< rate −∂u_x/∂x, stress η(√3 rate) √3 |rate|
    double peak, peak_position;
    double average;  ///< over ±R about the peak
};
AxisProfile axis_profile(const ExitField& field, const NozzleFlow& flow);

/// The largest radial velocity [m/s].
double largest_radial_velocity(const ExitField& field);

}  // namespace bioprint
