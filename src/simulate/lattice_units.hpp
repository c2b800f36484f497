#pragma once

#include <string>
#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/simulate/simulation.hpp"
#include "lattice/axisymmetric.hpp"

/// Where SI and lattice units meet.
///
/// A creeping flow leaves the time step free; four limits close it, and the tightest is named:
///   unsteadiness   Re_wall = u R/ν_wall of the lattice ≤ 5: the flow follows the cell within 1 %
///   compression    largest stress/(ρ c_s²) ≤ `accuracy`: what the lattice fluid yields to a pressure
///   elastic waves  the larger of μ and κ/(ρ c_s²) ≤ 0.2 in lattice units: stability of the coupling
///   velocity       u ≤ 0.05
/// A stiff cell in a slow flow would leave the lattice too little viscosity; it is kept at 0.05 around the cell and
/// the flow slowed instead, up to 1e5 steps a nozzle radius.
/// With S the largest stress and Re = u R/ν0: u = Re ν0/N, stress in lattice units = S R/(η0 U) · Re ν0²/N².
namespace bioprint {

struct LatticeUnits {
    int radius;           ///< nodes, N
    double spacing;       ///< [m]
    double time_step;     ///< [s]
    double velocity;      ///< [m/s] a lattice unit
    double stress;        ///< [Pa] a lattice unit
    double velocity_lu;   ///< average velocity
    double viscosity_lu;  ///< zero-shear viscosity
    double wall_reynolds;
    std::string binding;

    [[nodiscard]] lattice::CrossRelaxation relaxation(const Ink& ink) const;
    /// The same resolution with another viscosity and velocity.
    [[nodiscard]] LatticeUnits with(double velocity_lu, double viscosity_lu, const NozzleFlow& flow) const;
};

/// The developed profile on the lattice: velocity at r = 1/2, 3/2 …, its slope there, and velocity at r = 0,
/// 1, 2 …, scaled to carry the flow rate exactly.
struct LatticeProfile {
    std::vector<double> velocity, slope, links;
    double pressure_gradient;  ///< −dp/dx
};
LatticeProfile lattice_profile(const NozzleFlow& flow, const LatticeUnits& units);

/// Nodes a nozzle radius for a mesh of so many layers.
int nodes_for(const Scene& scene, int layers, double mesh_spacing);
int layers_for(double resolution, double mesh_spacing);

/// Units for a run with a cell.
/// @throws UsageError  naming the nearest setting that fits
LatticeUnits units_for_cell(const Scene& scene, const NozzleFlow& flow, int nodes,
                            const SimulationOptions& options);

/// Units for a steady flow: viscosity chosen so that it settles soonest.
LatticeUnits units_for_flow(const NozzleFlow& flow, int nodes);

/// How many times thinner the ink around the cell can be than the ink at rest inside a stiff one: in the nozzle by the
/// rate at r = R_c, at the exit also by its elongation.
double viscosity_contrast(const Scene& scene, const NozzleFlow& flow);

/// @throws UsageError  a quantity of the scene is out of range, or the cell too large for the nozzle
void check(const Scene& scene, const SimulationOptions& options);

/// A cell on the axis keeps a shape in a long nozzle only up to some G R_c/μ; softer ones are drawn out without end.
/// @throws UsageError  it is softer, and no time in the nozzle was given
void check_softness(const Scene& scene, const NozzleFlow& flow, const SimulationOptions& options);

}  // namespace bioprint
