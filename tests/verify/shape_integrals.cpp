#include "bioprint/cell/shape_integrals.hpp"

#include <doctest/doctest.h>
#include <gsl/gsl_sf_ellint.h>

#include <cmath>

namespace {

using namespace bioprint;

/// g_i', g_i'' from Carlson's R_D: I_k = ∫ dλ/((α_k²+λ)Δ) = 2/3 R_D(α_i², α_j², α_k²), partial fractions.
/// Loses as many digits as two squares have in common.
ShapeIntegrals from_carlson(const std::array<double, 3>& q) {
    const auto rd = [](double x, double y, double z) {
        return 2.0 / 3.0 * gsl_sf_ellint_RD(x, y, z, GSL_PREC_DOUBLE);
    };
    const std::array<double, 3> single{rd(q[1], q[2], q[0]), rd(q[2], q[0], q[1]), rd(q[0], q[1], q[2])};
    ShapeIntegrals g{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        g.first[i] = (single[j] - single[k]) / (q[k] - q[j]);
        g.second[i] = (q[k] * single[k] - q[j] * single[j]) / (q[k] - q[j]);
    }
    return g;
}

double largest_difference(const ShapeIntegrals& a, const ShapeIntegrals& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        worst = std::fmax(worst, std::abs(a.first[i] / b.first[i] - 1.0));
        worst = std::fmax(worst, std::abs(a.second[i] / b.second[i] - 1.0));
    }
    return worst;
}

}  // namespace

TEST_CASE(
    "shape integrals: a sphere has g' = 2/5 and g'' = 4/15 and they scale with the fifth and third power") {
    for (const double radius : {1e-3, 1.0, 40.0}) {
        const ShapeIntegrals g = shape_integrals({radius * radius, radius * radius, radius * radius});
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(g.first[i] * std::pow(radius, 5) == doctest::Approx(0.4).epsilon(2e-15));
            CHECK(g.second[i] * std::pow(radius, 3) == doctest::Approx(4.0 / 15.0).epsilon(2e-15));
        }
    }
}

TEST_CASE(
    "shape integrals: equal steps agree with Carlson's R_D where its partial fractions keep their digits") {
    // Carlson's route loses a factor of the relative distance of two squares: 1e-13 for distances above 0.1.
    for (const auto& q :
         {std::array<double, 3>{4.0, 0.5, 1.2}, {9.0, 0.09, 1.3}, {100.0, 1e-4, 6.0}, {0.3, 2.0, 1.0}}) {
        CHECK(largest_difference(shape_integrals(q), from_carlson(q)) < 1e-13);
    }
    CHECK(largest_difference(shape_integrals({1e4, 1e-8, 1e3}), from_carlson({1e4, 1e-8, 1e3})) < 1e-11);
}

TEST_CASE("shape integrals: equal steps agree with adaptive quadrature from spheres to needles and discs") {
    // Adaptive quadrature asks for 1e-13 and reaches it; its own estimate has to say so.
    for (const auto& q : {std::array<double, 3>{1.0, 1.0, 1.0},
                          {1.0 + 1e-9, 1.0, 1.0 - 1e-9},
                          {1.21, 0.9, 1.0},
                          {25.0, 0.2, 0.2},
                          {0.04, 5.0, 5.0},
                          {1e6, 1e-3, 1e-3},
                          {1e4, 1e4, 1e-8},
                          {1e8, 1e-12, 1e4}}) {
        const CheckedShapeIntegrals checked = shape_integrals_adaptive(q);
        CHECK(checked.relative_error < 1e-11);
        CHECK(largest_difference(shape_integrals(q), checked.value) < 2e-13);
    }
}

TEST_CASE("shape integrals: permuting the axes permutes the integrals") {
    const ShapeIntegrals a = shape_integrals({4.0, 0.5, 1.2});
    const ShapeIntegrals b = shape_integrals({0.5, 1.2, 4.0});
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(b.first[i] == doctest::Approx(a.first[(i + 1) % 3]).epsilon(1e-15));
        CHECK(b.second[i] == doctest::Approx(a.second[(i + 1) % 3]).epsilon(1e-15));
    }
}

TEST_CASE("shape integrals: the sum rules hold for every shape") {
    // Σ α_i² (..) identities: α_j² + λ = λ + α_j² gives I_k = g_i'' + α_j² g_i', and Σ I = 2/(α1 α2 α3).
    for (double power = -8.0; power <= 8.0; power += 0.5) {
        const std::array<double, 3> q{std::pow(10.0, power), 1.0, std::pow(10.0, -0.3 * power)};
        const ShapeIntegrals g = shape_integrals(q);
        const double i1 = g.second[1] + q[2] * g.first[1];
        const double i2 = g.second[2] + q[0] * g.first[2];
        const double i3 = g.second[0] + q[1] * g.first[0];
        CHECK((i1 + i2 + i3) * 0.5 * std::sqrt(q[0] * q[1] * q[2]) == doctest::Approx(1.0).epsilon(5e-15));
    }
}
