#include "bioprint/rheology/cross.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {
constexpr CrossInk alginate{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75};
}

TEST_CASE("cross law: half the viscosity is gone at the rate 1/K") {
    CHECK(viscosity(alginate, 20.0) == doctest::Approx(5.0).epsilon(1e-15));
    CHECK(viscosity(alginate, 0.0) == 10.0);
}

TEST_CASE("cross law: with alpha 0 the ink is Newtonian with half the sum of both viscosities") {
    CHECK(viscosity({.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.0}, 123.0) == 5.0);
    CHECK(viscosity({.eta0 = 10.0, .eta_inf = 2.0, .time_constant = 0.05, .alpha = 0.0}, 123.0) == 6.0);
}

TEST_CASE("cross law: the infinite-shear viscosity is what remains at high rates") {
    const CrossInk ink{.eta0 = 10.0, .eta_inf = 0.01, .time_constant = 0.05, .alpha = 0.9};
    CHECK(viscosity(ink, 1e12) == doctest::Approx(0.01).epsilon(1e-5));
}

TEST_CASE("cross law: the rate at a stress is the inverse of the stress at a rate") {
    // 2e-13: rounding of a logarithm of magnitude 60, amplified by the slope 1/(1 - alpha) = 20.
    for (const double alpha : {0.0, 1e-6, 0.3, 0.75, 0.95}) {
        for (const double eta_inf : {0.0, 1e-3, 10.0}) {
            const CrossInk ink{.eta0 = 10.0, .eta_inf = eta_inf, .time_constant = 0.05, .alpha = alpha};
            for (double rate = 1e-12; rate < 1e13; rate *= 7.3) {
                CHECK(rate_at_stress(ink, stress(ink, rate)) == doctest::Approx(rate).epsilon(2e-13));
            }
        }
    }
    CHECK(rate_at_stress(alginate, 0.0) == 0.0);
}

TEST_CASE("cross law: past the stress maximum of an ink with alpha above 1 there is no rate") {
    const CrossInk ink{.eta0 = 10.0, .time_constant = 0.05, .alpha = 2.0};
    CHECK(largest_stable_rate(ink) == doctest::Approx(20.0).epsilon(1e-14));
    const double top = stress(ink, 20.0);
    CHECK(rate_at_stress(ink, 0.999 * top) < 20.0);
    CHECK_THROWS_AS(rate_at_stress(ink, 1.001 * top), NoSteadyFlow);
}

TEST_CASE("cross law: at alpha 1 the stress saturates at eta0/K") {
    const CrossInk ink{.eta0 = 10.0, .time_constant = 0.05, .alpha = 1.0};
    CHECK(rate_at_stress(ink, 199.0) ==
          doctest::Approx(199.0 / 200.0 * 20.0 / (1.0 - 199.0 / 200.0)).epsilon(1e-12));
    CHECK_THROWS_AS(rate_at_stress(ink, 200.0), NoSteadyFlow);
}

TEST_CASE("cross law: enough infinite-shear viscosity makes every load bearable above alpha 1") {
    CrossInk ink{.eta0 = 10.0, .eta_inf = 1.0, .time_constant = 0.05, .alpha = 1.5};
    CHECK(std::isinf(largest_stable_rate(ink)));  // (α−1)²/(4α) = 0.042 < e/(1−e) = 0.111
    CHECK(rate_at_stress(ink, stress(ink, 1e6)) == doctest::Approx(1e6).epsilon(1e-12));
    ink.eta_inf = 0.1;
    const double edge = largest_stable_rate(ink);
    CHECK(stress(ink, edge) > stress(ink, 1.01 * edge));
    CHECK(stress(ink, edge) > stress(ink, 0.99 * edge));
}
