#pragma once

#include <array>
#include <optional>

/// Stationary shape and stress of a cell in a steady flow: Roscoe's ellipsoid (J. Fluid Mech. 28, 1967).
///
/// The cell is an incompressible neo-Hookean body of shear modulus μ whose inner viscosity is λ times that of
/// the ink; around it the ink flows with a uniform gradient and the viscosity it has there. Everything
/// depends on the stress ratio σ_f/μ and on λ alone. Stretches α_i are semi-axes over the undeformed radius,
/// α1 α2 α3 = 1.
///
/// **Shear** (the cell tank-treads; axis 1 is inclined to the flow by an angle, axis 3 is the vorticity's).
/// One of Roscoe's three conditions holds neither σ_f nor λ, so every stationary shape lies on one universal
/// curve, which is tabulated; on it the other two are explicit and a single equation in one variable is left.
///   σ_f/μ → 0: elastic stress 5/2 : −5/2 : 0, von Mises (5/2)√3, in units of σ_f.
///   σ_f/μ → ∞, λ = 1: 1.9659 : −1.0622 : −0.9036 and 2.9520, after a minimum of 2.8970 at σ_f/μ = 8.19.
///   λ ≤ 2: the deformation grows without bound; λ > 2: it stays bounded and the cell turns like a solid.
///
/// **Elongation** (axis 1 along the flow, α2 = α3). No stationary shape exists past a turning point.
///
/// Accuracy: 1e-12 relative, for shear also of the deviation from the sphere and of the angle, for σ_f/μ from
/// 1e-30 to 1e30 and λ from 0 to 100; near the turning points of elongation 1e-8. tests/verify/roscoe.cpp
/// Cost: about 2 µs, 4 µs for λ > 2; elongation 1 µs.                                tests/bench/cell.cpp
namespace bioprint {

/// Shape and stress of an ellipsoidal cell, in its principal axes.
struct EllipsoidState {
    std::array<double, 3> stretch;    ///< α1, α2, α3
    std::optional<double> angle;      ///< of axis 1 to the flow [rad], 0 to π/4; none in elongation
    std::optional<double> frequency;  ///< angular frequency of the tank-treading [1/s]; none in elongation
    double von_mises;                 ///< of the elastic stress [Pa]
    std::array<double, 3> elastic;    ///< principal deviatoric elastic stresses [Pa]
    double viscous;  ///< viscous shear stress σ12 inside the cell [Pa]; 0 in steady elongation
};

struct ShearLoad {
    double fluid_stress;           ///< σ_f = η γ̇ of the undisturbed ink [Pa], ≥ 0
    double shear_rate;             ///< γ̇ [1/s], ≥ 0; enters the frequency only
    double shear_modulus;          ///< μ [Pa], > 0
    double viscosity_ratio = 1.0;  ///< λ, ≥ 0
};

/// The stationary cell in steady shear.
/// @throws UsageError    a value outside its range or not finite
/// @throws NotConverged  a stress ratio past what numbers can hold (above 1e40)
EllipsoidState roscoe_shear(const ShearLoad& shear);

enum class ElongationDirection {
    extension,    ///< the flow pulls along axis 1: α1 > 1
    compression,  ///< the flow presses along axis 1, as at a nozzle exit: α1 < 1
};

struct ElongationLoad {
    double fluid_stress;   ///< σ_f = √3 η ε̇ [Pa], ≥ 0
    double shear_modulus;  ///< μ [Pa], > 0
    ElongationDirection direction = ElongationDirection::compression;
};

/// The stationary cell in steady uniaxial elongation; no value past the turning point.
/// @throws UsageError  a value outside its range or not finite
std::optional<EllipsoidState> roscoe_elongation(const ElongationLoad& load);

/// Where the stationary branch of elongation ends.
struct ElongationLimit {
    double load;     ///< (2/√3) σ_f/μ
    double stretch;  ///< α1
};
inline constexpr ElongationLimit extension_limit{.load = 0.66678146200700012, .stretch = 4.1082497337786417};
inline constexpr ElongationLimit compression_limit{.load = 0.57295399875620901,
                                                   .stretch = 0.25948865723366848};

/// The fluid stress [Pa] past which no stationary shape exists, for a shear modulus [Pa].
double elongation_limit_stress(double shear_modulus, ElongationDirection direction);

/// How well a stationary shape in shear solves Roscoe's equations, by adaptive quadrature instead of the
/// table.
struct ShearResidual {
    double shape;             ///< relative residual of the condition on the shape
    double torque;            ///< of the condition on the angle
    double load;              ///< of the condition on the load
    double quadrature_error;  ///< relative, as the quadrature itself estimates it
};
ShearResidual shear_residual(const ShearLoad& load, const EllipsoidState& state);

}  // namespace bioprint
