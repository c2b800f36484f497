#pragma once

#include <array>
#include <string>
#include <vector>

#include "simulate/watch.hpp"

/// A cell between two plates moving in opposite directions: the scene on which Roscoe's theory is exact but
/// for the size of the box.
///
/// A box of 10 × 15 × 5 cell radii (flow, gradient, vorticity), periodic along the flow and the vorticity, a
/// Newtonian ink, a neo-Hookean cell of the same viscosity. Half of it is simulated: z = 0 is a mirror plane.
/// Everything depends on σ_f/μ alone. A shear-thinning ink, which no exact theory covers, shows what its thinning
/// around the cell and its thickening inside do.
namespace bioprint {

struct ShearSceneSetup {
    double fluid_stress;                         ///< σ_f = η γ̇ of the undisturbed flow [Pa], > 0
    double shear_modulus;                        ///< μ of the cell [Pa], > 0
    double shear_rate;                           ///< γ̇ [1/s], > 0
    double cell_radius = 1.0;                    ///< [m]; of pictures alone
    double alpha = 0.0;                          ///< thinning exponent of the ink, in the cell too
    double reduced_rate = 0.0;                   ///< K γ̇ of the undisturbed ink; 0: Newtonian
    double nodes = 6.0;                          ///< cell radius, in lattice nodes
    std::array<double, 3> box{10.0, 15.0, 5.0};  ///< in cell radii; rounded to whole nodes, the first to 16
    double longest = 30.0;                       ///< γ̇ t at which the run ends in any case
    double steady = 2e-4;  ///< relative change of the von Mises stress per unit of γ̇ t that counts as none
    bool inside = true;    ///< couple through points inside the elements
    double mesh_spacing = 2.0;  ///< in lattice nodes
    int threads = 1;
    SceneWatch watch = {};
};

struct ShearSample {
    double time;       ///< [s]
    double von_mises;  ///< mean over the cell [Pa]
    std::array<double, 3> stretch;
    double angle;  ///< of the longest axis to the flow [rad]
};

struct ShearSceneResult {
    std::vector<ShearSample> series;
    bool steady;                    ///< the run ended because nothing changed any more
    std::array<double, 3> stretch;  ///< semi-axes over the radius; the last is along the vorticity
    double angle;                   ///< [rad]
    double frequency;               ///< angular frequency of the tank-treading [1/s]
    double von_mises;               ///< [Pa]
    double peak_von_mises;          ///< over the whole run [Pa]
    std::array<double, 3> elastic;  ///< mean deviatoric elastic stress along the ellipsoid's axes [Pa]
    double viscous;                 ///< viscous shear stress σ12 in those axes [Pa]
    double volume;                  ///< over the rest volume
    std::array<double, 3> box;      ///< as simulated, in cell radii
    std::string stopped;            ///< why the run ended early; empty: it came to its end
    double time_step;               ///< [s]
    double viscosity;               ///< of the lattice
    double shear_modulus;           ///< of the lattice
    int length;                     ///< nodes along the flow
    long steps;
    long nodes;  ///< of the lattice
};

/// Of a run, known before it.
struct ShearSceneSteps {
    long fewest;
    long most;
    long nodes;  ///< of the lattice
};
ShearSceneSteps shear_scene_steps(const ShearSceneSetup& setup);

/// What was reached when the cell broke or the run was ended is returned, with `stopped` saying so.
/// @throws UsageError  a value out of range
ShearSceneResult run_shear_scene(const ShearSceneSetup& setup);

}  // namespace bioprint
