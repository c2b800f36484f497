#pragma once

#include "bioprint/function_ref.hpp"
#include "bioprint/rheology/ink.hpp"

/// A cell carried along the axis of an axisymmetric flow: an ellipsoid of revolution in time, with the first
/// effects of the cell's own size.
///
/// The steady theory (roscoe.hpp) asks which shape would rest in a flow; this asks what becomes of the cell
/// on its way. With x = ln α1, e the elongation rate, d that inside the cell, S = (3/2) g2'' and k = 1/S − 1
/// (sphere: 3/2),
///
///   dx/dt = d,     2η e + 2η_b k (e − d) = (2/3) μ (α1² − 1/α1) + 2λ η(d) d
///
/// the balance of the stress outside and inside. No turning point: there is an answer for every load. Beyond
/// the ellipsoid in a uniform flow this model has, none of them fitted to a printed cell,
///
///  - the elongation averaged over the cell's volume (in a Newtonian ink Faxén's law), and its slip against
///    the ink;
///  - the part of the flow that is quadratic in position. It deforms the cell as in the nozzle (bullet.hpp),
///    with two modes of their own relaxation times, (2/3+λ) η/μ and (19/16+λ) η/μ; the von Mises stress is
///    averaged over the sum of the uniform and the linear stress field. To second order the bent cell is
///    shorter and wider, by three quarters of what its elasticity alone would do: this factor alone was
///    measured, in the simulated channel;
///  - the thinning of the ink by the cell's own disturbance (η_b: see thinning_response.hpp) and inside the
///    cell, whose viscosity is λ times the ink's at the inner rate, as it is when the cell is filled with ink.
///
/// An ink without a viscosity at rest (power law, yield stress) is taken at that of a millionth of velocity over cell
/// radius where it rests: there it holds the cell as it is, but for what the cell's own relaxation thins.
///
/// Validity: a cell small against the nozzle (a third at most), no wall; to first order in the quadratic
/// part. Accuracy of the model: see predict/exit_passage.hpp. Cost: 80 to 110 µs in a Newtonian ink,
/// 150 to 240 µs in one that thins, up to 1 ms where the cell follows the flow all the way.
namespace bioprint {

/// The undisturbed flow about a point of the axis, z along it: u_z = velocity + elongation z + axial z² +
/// radial/η ρ².
struct AxisFlow {
    double velocity;    ///< [m/s], > 0
    double elongation;  ///< ∂u/∂z, negative where the flow slows down [1/s]
    double axial;       ///< ½ ∂²u/∂z² [1/(m s)]
    double radial;      ///< coefficient of ρ², times the viscosity [Pa/m]: −G/4 in a pipe
};

struct AxisCell {
    double radius;                 ///< a [m], > 0; the size effects vanish with it
    double shear_modulus;          ///< μ [Pa], > 0
    double viscosity_ratio = 1.0;  ///< λ ≥ 0
};

/// What of the cell's own size and of the ink's thinning is taken in; all by default.
struct AxisEffects {
    bool volume_average = true;
    bool quadratic_flow = true;
    bool disturbed_viscosity = true;
    double quadratic_share =
        1.0;  ///< of the quadratic part's load on the cell that its shape can carry, 0 … 1
};

/// The cell at one place.
struct AxisCellState {
    double position;         ///< [m]
    double time;             ///< since the start [s]
    double axial_stretch;    ///< α1
    double radial_stretch;   ///< α2 = α3
    double von_mises;        ///< volume average of the elastic stress [Pa]
    double fluid_stress;     ///< σ = η √3|e| of the undisturbed ink at the cell's centre [Pa]
    double stress_exposure;  ///< ∫ von Mises dt [Pa s]
};

/// Where the cell comes from and goes to, along z [m]. It starts as it travels in a long nozzle: round but
/// for the two quadratic modes, which are steady in the flow at `from`.
struct AxisWay {
    double from;
    double to;
    double tolerance = 3e-5;  ///< of the integrator, relative: leaves 2e-4 of a peak
    double observe_every =
        0;  ///< distance between calls of the observer [m]; 0: one a step of the integrator
};

struct AxisPassage {
    AxisCellState start;
    AxisCellState peak;  ///< where the von Mises stress is largest
    AxisCellState end;
    double axial_stretch_min;  ///< over the whole way
    double axial_stretch_max;
    double radial_stretch_max;
    int steps;  ///< taken by the integrator
};

/// Carries the cell through a flow that does not change in time.
/// @param flow     the undisturbed flow at z; called with z up to a cell radius outside the way
/// @param observe  called with the cell's state in order of z, start and end included
/// @throws UsageError    a value outside its range or not finite
/// @throws NotConverged  the integrator gave up
AxisPassage carry_along_axis(FunctionRef<AxisFlow(double)> flow, const Ink& ink, const AxisCell& cell,
                             const AxisWay& way, const AxisEffects& effects,
                             FunctionRef<void(const AxisCellState&)> observe);
AxisPassage carry_along_axis(FunctionRef<AxisFlow(double)> flow, const Ink& ink, const AxisCell& cell,
                             const AxisWay& way, const AxisEffects& effects = {});

}  // namespace bioprint
