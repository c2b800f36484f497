#pragma once

#include <array>
#include <optional>

#include "numerics/dormand_prince.hpp"

/// The transient ellipsoid (transient.hpp) in a flow that has a plane of symmetry through the cell's centre,
/// as it has along a streamline of an axisymmetric flow: x along the axis, r across it, θ out of the plane.
///
/// One axis of the ellipsoid is then θ, and of the factor C in B = C Cᵀ three numbers are left: the
/// logarithms of C_xx and C_rr, and C_rx. The third diagonal follows from the volume, which is thus kept
/// exactly. A quarter of the work of the general cell, the same equations.
///
/// Accuracy: rates to 1e-7 (shape_integrals_brief).             tests/verify/planar_cell.cpp
namespace bioprint {

/// The undisturbed ink at the cell's centre.
struct PlanarFlow {
    double xx;  ///< ∂u_x/∂x [1/s]
    double xr;  ///< ∂u_x/∂r
    double rx;  ///< ∂u_r/∂x
    double rr;
    double tt;         ///< u_r/r = −xx − rr
    double viscosity;  ///< η [Pa s], > 0
};

/// ln C_xx, ln C_rr, C_rx.
using PlanarState = OdeState<3>;

/// B − 1 in x, r, θ.
struct PlanarStrain {
    double xx;
    double xr;
    double rr;
    double tt;
};

PlanarStrain planar_strain(const PlanarState& state);

/// What planar_strain gives back; the volume is set to that at rest.
PlanarState planar_state(const PlanarStrain& strain);

/// The ellipsoid in its axes: the first is the one in the plane that is nearer to x, the second the other in
/// the plane, the third θ.
struct PlanarShape {
    std::array<double, 3> stretch;
    std::array<double, 3> elastic;  ///< principal deviatoric elastic stresses over μ
    double angle;       ///< of the first axis to x, positive when it leans towards −r [rad], ±π/4
    double von_mises;   ///< over μ
    double shear_part;  ///< 3 (B_xr)² over the square of von_mises: 1 in pure shear, 0 along x
};

PlanarShape planar_shape(const PlanarStrain& strain);

/// Only the last two of that.
struct PlanarStress {
    double von_mises;
    double shear_part;
};
PlanarStress planar_stress(const PlanarStrain& strain);

struct PlanarCell {
    double shear_modulus;    ///< μ [Pa], > 0
    double viscosity_ratio;  ///< λ ≥ 0

    [[nodiscard]] PlanarState derivative(const PlanarFlow& flow, const PlanarState& state) const;

    /// The rate of shear inside, between the first two axes: the viscous stress of Roscoe's theory is 2λη
    /// times it, and the tank-treading frequency 2 α1α2/(α1²−α2²) times it, positive in a flow that falls
    /// with r [1/s].
    [[nodiscard]] double inner_shear(const PlanarFlow& flow, const PlanarStrain& strain) const;
};

}  // namespace bioprint
