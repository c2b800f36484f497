#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bioprint/cell/roscoe.hpp"
#include "cell/checks.hpp"
#include "cell/spheroid.hpp"
#include "numerics/monotone_root.hpp"

// x = |ln α1|. The load of a shape, (2/√3) σ_f/μ = |α1² − 1/α1| g2'', rises from 0.8 x to its turning point.
// With p = load over its limit, p/(1+√(1−p)) is smooth at both ends: linear in x near the sphere and near the
// turning.

namespace bioprint {
namespace {

struct Branch {
    double sign;
    ElongationLimit limit;
};

Branch branch(ElongationDirection direction) {
    return direction == ElongationDirection::extension ? Branch{.sign = 1.0, .limit = extension_limit}
                                                       : Branch{.sign = -1.0, .limit = compression_limit};
}

/// α1² − 1/α1, signed, without cancellation near the sphere.
double stretch_difference(double log_stretch) {
    return 2.0 * std::exp(0.5 * log_stretch) * std::sinh(1.5 * log_stretch);
}

double load_of(double log_stretch) {
    return std::abs(stretch_difference(log_stretch)) * spheroid_integral(log_stretch);
}

double unfold(double part) {
    return part / (1.0 + std::sqrt(std::max(0.0, 1.0 - part)));
}

}  // namespace

double elongation_limit_stress(double shear_modulus, ElongationDirection direction) {
    require_positive(shear_modulus, "shear modulus");
    return 0.5 * std::numbers::sqrt3 * branch(direction).limit.load * shear_modulus;
}

std::optional<EllipsoidState> roscoe_elongation(const ElongationLoad& elongation) {
    require_not_negative(elongation.fluid_stress, "fluid stress");
    require_positive(elongation.shear_modulus, "shear modulus");
    const double sign = branch(elongation.direction).sign;
    const ElongationLimit limit = branch(elongation.direction).limit;
    const double load = 2.0 / std::numbers::sqrt3 * (elongation.fluid_stress / elongation.shear_modulus);
    if (load > limit.load) return std::nullopt;

    double x = 0.0;
    if (load > std::numeric_limits<double>::min()) {
        const double target = unfold(load / limit.load);
        const double start = 1.25 * load;
        const double furthest = std::log(std::abs(std::log(limit.stretch)) / start);
        x = start *
            std::exp(increasing_root(
                [&](double y) {
                    return std::log(unfold(load_of(sign * start * std::exp(y)) / limit.load) / target);
                },
                {.low = -0.5, .high = std::max(-0.5, furthest), .guess = 0.0},
                [](double a, double b) { return std::abs(a - b) <= 1e-12; }));
    }
    const double difference = elongation.shear_modulus * stretch_difference(sign * x);
    const double across = std::exp(-0.5 * sign * x);
    return EllipsoidState{.stretch = {std::exp(sign * x), across, across},
                          .angle = std::nullopt,
                          .frequency = std::nullopt,
                          .von_mises = std::abs(difference),
                          .elastic = {2.0 / 3.0 * difference, -difference / 3.0, -difference / 3.0},
                          .viscous = 0.0};
}

}  // namespace bioprint
