#pragma once

/// A cell carried along the axis of a nozzle: the "bullet".
///
/// An elastic sphere of radius a, free of force, in the parabolic middle of a pipe flow with pressure
/// gradient G. To first order in Ga/μ the tractions are those on a rigid sphere in the quadratic flow (Lamb's
/// solution), and the elastic field they cause is quadratic too; with z along the flow and ρ across it, both
/// from the cell's centre,
///
///   u_z = G/(4μ) (5/24 z² − 85/48 ρ²)        u_ρ = −G/(4μ) 5/24 ρ z
///   von Mises = G/4 sqrt(1.5625 z² + 42.1875 ρ²)
///
/// It depends on G alone, which is why a thinner ink loads the centred cell less at the same flow rate. The
/// strains are odd in z, so the volume averages of strain and of the stress components vanish: to this order
/// the cell keeps its length and its width, while its front sharpens and its rear flattens, r/a = 1 + 0.21875
/// (Ga/μ) P3(cos θ).
///
/// Validity: Ga/μ small (the shape is off by its square), a small against the nozzle (unbounded fluid), inner
/// viscosity of no influence (nothing moves inside), and an ink whose velocity is parabolic over the cell's
/// width: a strongly thinning ink is flatter there, for which the stress is an estimate. Source: this
/// project; checked by integrating its own local fields.                      tests/verify/bullet.cpp
namespace bioprint {

struct BulletLoad {
    double pressure_gradient;  ///< G [Pa/m], ≥ 0
    double viscosity;          ///< of the ink on the axis [Pa s], > 0; enters the slip only
    double cell_radius;        ///< a [m], > 0
    double shear_modulus;      ///< μ [Pa], > 0
};

struct BulletState {
    double von_mises;      ///< volume average [Pa], 0.97173 G a
    double von_mises_max;  ///< largest, on the equator of the surface [Pa], 1.624 G a
    double slip;  ///< cell velocity minus the undisturbed velocity on the axis [m/s], −(2/3) G a²/(4η)
    double shape_amplitude;      ///< coefficient of P3 in r/a − 1
    double deformation_measure;  ///< Ga/μ: what must be small
};

/// @throws UsageError  a value outside its range or not finite
BulletState bullet(const BulletLoad& load);

/// How much of its von Mises stress the bullet has a time after it entered the nozzle round: the two modes of
/// its shape grow to their steady values with (2/3 + λ) η/μ and (19/16 + λ) η/μ. From 0 to 1; the time in
/// units of η/μ.
double bullet_growth(double time, double viscosity_ratio = 1.0);

/// The local von Mises stress [Pa] of the same field, z and ρ from the cell's centre [m].
double bullet_local_von_mises(const BulletLoad& load, double z, double rho);

/// Small-deformation relaxation time of a cell in an ink of viscosity η [s]: (3/2 + λ) η/μ.
double relaxation_time(double viscosity, double shear_modulus, double viscosity_ratio = 1.0);

}  // namespace bioprint
