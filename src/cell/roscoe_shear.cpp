#include <algorithm>
#include <cmath>
#include <limits>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/cell/shape_integrals.hpp"
#include "bioprint/errors.hpp"
#include "cell/checks.hpp"
#include "cell/shear_curve.hpp"
#include "numerics/monotone_root.hpp"

// s = α2/α1, δ = 1 − s, k = 1 − (1−λ)h, κ = k(1−s²). Roscoe's condition on the angle θ and the one on the
// load become
//
//   cos2θ = κ(1+s²)/B          sin2θ = 2s √((2−κ)(2s²+κ))/B          B = 4s² + κ(1−s²)
//   ν/γ̇   = s(1+s²)/B          σ12   = λ σ_f (1−s⁴)/B
//   σ_f/μ = (1−s²) w / (2 α1 sin2θ)
//
// For λ > 2, κ reaches 2 at an s* > 0: the shape of infinite load. At λ ≤ 2 that is s* = 0.

namespace bioprint {
namespace {

constexpr double largest_stress_ratio = 1e40;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The unknown is t = δ/(s − s*): the logarithm of the load is nearly linear in that of t, all the way.
AxisRatio axis_ratio(double t, const AxisRatio& limit) {
    if (t > 1.0) {
        const double u = 1.0 / t;
        return {.s = (u + limit.s) / (1.0 + u), .delta = limit.delta / (1.0 + u)};
    }
    return {.s = (1.0 + t * limit.s) / (1.0 + t), .delta = t * limit.delta / (1.0 + t)};
}

struct Stationary {
    AxisRatio ratio;
    ShearCurve curve;
    double kappa;            ///< k(1−s²)
    double two_minus_kappa;  ///< vanishes at s*
    double b;
    double log_stretch;  ///< ln α1
};

Stationary stationary(const AxisRatio& ratio, double lambda) {
    const ShearCurve curve = shear_curve(ratio);
    const double s = ratio.s;
    const double slip = s * curve.slip;  // 1 − h
    const double k = lambda < 1.0 ? lambda + (1.0 - lambda) * slip : 1.0 + (lambda - 1.0) * (1.0 - slip);
    const double kappa = k * ratio.delta * (1.0 + s);
    const double small = s < 0.5 ? (2.0 - lambda) + (lambda - 1.0) * slip + k * s * s : 2.0 - kappa;
    const double ell = 0.5 + ratio.delta * curve.lean;
    return {.ratio = ratio,
            .curve = curve,
            .kappa = kappa,
            .two_minus_kappa = small,
            .b = 4.0 * s * s + kappa * ratio.delta * (1.0 + s),
            .log_stretch = (log_ratio(ratio) + ratio.delta * ell) / 3.0};
}

/// (1−s²) w / (2 α1): the load times sin2θ.
double load_times_sine(const Stationary& p) {
    return 0.5 * p.ratio.delta * (1.0 + p.ratio.s) * p.curve.bearing * std::exp(-p.log_stretch);
}

double load(const Stationary& p) {
    if (!(p.two_minus_kappa > 0.0)) return infinity;
    const double s = p.ratio.s;
    const double half_sine = s * std::sqrt(p.two_minus_kappa * (2.0 * s * s + p.kappa)) / p.b;
    return 0.5 * load_times_sine(p) / half_sine;
}

/// A step this small is round-off.
bool same_shape(const AxisRatio& a, const AxisRatio& b) {
    constexpr double tolerance = 3e-15;
    return std::abs(a.delta - b.delta) <= tolerance * a.delta && std::abs(a.s - b.s) <= tolerance * a.s;
}

/// The shape at which f passes zero; f increases with ln t, about as fast.
template <typename F>
AxisRatio solve_for(F&& f, double start, const AxisRatio& limit) {
    const auto at = [&](double y) { return axis_ratio(start * std::exp(y), limit); };
    const double lowest = -std::log(1e10 * std::max(1.0, start));
    const double highest = std::log(1e290 / start);
    return at(increasing_root([&](double y) { return f(at(y)); },
                              {.low = lowest, .high = highest, .guess = 0.0},
                              [&](double a, double b) { return same_shape(at(a), at(b)); }));
}

/// s*: the axis ratio at infinite load, where κ = 2. Close to λ = 2 it is (λ−2)/5.08; for large λ, δ*
/// = 2.5/λ.
AxisRatio limit_ratio(double lambda) {
    constexpr AxisRatio none{.s = 0.0, .delta = 1.0};
    if (lambda <= 2.0) return none;
    const auto f = [&](const AxisRatio& r) {
        return std::log1p(-0.5 * stationary(r, lambda).two_minus_kappa);
    };
    return solve_for(f, (2.5 + 2.58 / (lambda - 1.0)) / (lambda - 2.0), none);
}

Stationary solve(double stress_ratio, double lambda) {
    const AxisRatio limit = limit_ratio(lambda);
    const auto f = [&](const AxisRatio& r) { return std::log(load(stationary(r, lambda)) / stress_ratio); };
    return stationary(solve_for(f, 2.5 * stress_ratio / limit.delta, limit), lambda);
}

}  // namespace

EllipsoidState roscoe_shear(const ShearLoad& shear) {
    require_not_negative(shear.fluid_stress, "fluid stress");
    require_not_negative(shear.shear_rate, "shear rate");
    require_positive(shear.shear_modulus, "shear modulus");
    require_not_negative(shear.viscosity_ratio, "viscosity ratio");
    const double stress_ratio = shear.fluid_stress / shear.shear_modulus;
    if (!(stress_ratio <= largest_stress_ratio)) {
        throw NotConverged(
            "stationary cell in shear: the ratio of fluid stress to shear modulus is past 1e40");
    }
    const double lambda = shear.viscosity_ratio;
    const bool loaded = stress_ratio > std::numeric_limits<double>::min();
    const Stationary p = loaded ? solve(stress_ratio, lambda) : stationary({.s = 1.0, .delta = 0.0}, lambda);

    const double s = p.ratio.s;
    const double z = log_ratio(p.ratio);
    // ln α3 is even in z; from its own small difference, so that σ33 keeps its digits near the sphere.
    const double log3 =
        (log_ratio_excess(p.ratio) - 2.0 * p.ratio.delta * p.ratio.delta * p.curve.lean) / 3.0;
    const double mu = shear.shear_modulus;
    const double half_difference = mu * std::exp(-log3) * std::sinh(z);
    const double half_sinh = std::sinh(0.5 * z);
    const double third =
        2.0 / 3.0 * mu * std::exp(-log3) * (std::expm1(3.0 * log3) - 2.0 * half_sinh * half_sinh);
    const double cosine = p.kappa * (1.0 + s * s) / p.b;
    const double sine = loaded ? load_times_sine(p) / stress_ratio : 1.0;
    return {.stretch = {std::exp(0.5 * (z - log3)), std::exp(-0.5 * (z + log3)), std::exp(log3)},
            .angle = 0.5 * std::atan2(sine, cosine),
            .frequency = shear.shear_rate * (s * (1.0 + s * s) / p.b),
            .von_mises = std::hypot(std::sqrt(3.0) * half_difference, 1.5 * third),
            .elastic = {half_difference - 0.5 * third, -half_difference - 0.5 * third, third},
            .viscous = lambda * shear.fluid_stress * (p.ratio.delta * (1.0 + s) * (1.0 + s * s) / p.b)};
}

ShearResidual shear_residual(const ShearLoad& load, const EllipsoidState& state) {
    const auto& a = state.stretch;
    const std::array<double, 3> q{a[0] * a[0], a[1] * a[1], a[2] * a[2]};
    const CheckedShapeIntegrals checked = shape_integrals_adaptive(q);
    const auto& g1 = checked.value.first;
    const auto& g = checked.value.second;
    const double angle = state.angle.value_or(0.0);
    const double inner_rate = load.shear_rate > 0.0
                                  ? 0.5 * *state.frequency / load.shear_rate * (q[0] - q[1]) / (a[0] * a[1])
                                  : 0.0;
    const double determinant = g[0] * g[1] + g[1] * g[2] + g[2] * g[0];
    const double sum = (q[0] + q[1]) * g1[2];
    const double left = inner_rate - 2.0 * (inner_rate - 0.5 * std::cos(2.0 * angle)) / sum;
    const double balance =
        2.0 * load.fluid_stress / load.shear_modulus * std::sin(2.0 * angle) * (g[0] + g[1]);
    const double deviation = q[0] - q[1];
    return {
        .shape = deviation > 0.0 ? ((q[0] - q[2]) * g[1] - (q[2] - q[1]) * g[0]) / (deviation * g[1]) : 0.0,
        .torque = load.shear_rate > 0.0 ? left - load.viscosity_ratio * inner_rate : 0.0,
        .load = deviation > 0.0 ? balance / (determinant * deviation) - 1.0 : balance / determinant,
        .quadrature_error = checked.relative_error};
}

}  // namespace bioprint
