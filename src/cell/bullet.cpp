#include "bioprint/cell/bullet.hpp"

#include <cmath>

#include "cell/checks.hpp"

namespace bioprint {
namespace {

// (G/4)² (z_part z² + rho_part ρ²) is the square of the local von Mises stress: 25/16 and 675/16.
constexpr double z_part = 1.5625;
constexpr double rho_part = 42.1875;
constexpr double shape_part = 0.21875;  // 7/32

/// Volume average of sqrt(along z² + across ρ²), along < across, over the unit ball: (3/4) ∫_0^1 sqrt(across −
/// (difference) c²) dc, c the cosine of the polar angle.
double average_over_ball(double along = z_part, double across = rho_part) {
    const double e = std::sqrt(1.0 - along / across);
    return 0.75 * std::sqrt(across) * 0.5 * (std::sqrt(1.0 - e * e) + std::asin(e) / e);
}

}  // namespace

BulletState bullet(const BulletLoad& load) {
    require_not_negative(load.pressure_gradient, "pressure gradient");
    require_positive(load.viscosity, "viscosity");
    require_positive(load.cell_radius, "cell radius");
    require_positive(load.shear_modulus, "shear modulus");
    const double a = load.cell_radius;
    const double stress = load.pressure_gradient * a;
    const double measure = stress / load.shear_modulus;
    return {.von_mises = 0.25 * stress * average_over_ball(),
            .von_mises_max = 0.25 * stress * std::sqrt(rho_part),
            .slip = -stress * a / (6.0 * load.viscosity),
            .shape_amplitude = shape_part * measure,
            .deformation_measure = measure};
}

double bullet_growth(double time, double viscosity_ratio) {
    if (!(time > 0.0)) return 0.0;
    require_not_negative(viscosity_ratio, "viscosity ratio");
    // The displacement u_z = A z² + B ρ², u_ρ = −A ρ z has the modes A + 2B and 2A − B: −10/3 and 35/16 when
    // steady, in units of Ga/(4μ).
    const double first = 10.0 / 3.0 * std::expm1(-time / (2.0 / 3.0 + viscosity_ratio));
    const double third = -35.0 / 16.0 * std::expm1(-time / (19.0 / 16.0 + viscosity_ratio));
    const double a = (first + 2.0 * third) / 5.0;
    const double b = (2.0 * first - third) / 5.0;
    const double shear = 2.0 * (b - 0.5 * a);
    const double across = 3.0 * shear * shear;
    return across > 0.0 ? average_over_ball(36.0 * a * a, across) / average_over_ball() : 0.0;
}

double bullet_local_von_mises(const BulletLoad& load, double z, double rho) {
    return 0.25 * load.pressure_gradient * std::sqrt(z_part * z * z + rho_part * rho * rho);
}

double relaxation_time(double viscosity, double shear_modulus, double viscosity_ratio) {
    require_not_negative(viscosity, "viscosity");
    require_positive(shear_modulus, "shear modulus");
    require_not_negative(viscosity_ratio, "viscosity ratio");
    return (1.5 + viscosity_ratio) * viscosity / shear_modulus;
}

}  // namespace bioprint
