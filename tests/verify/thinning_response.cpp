#include "cell/thinning_response.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace bioprint;

double undisturbed(double alpha, double k, double elongation) {
    return 1.0 / (1.0 + std::pow(k * std::numbers::sqrt3 * std::abs(elongation), alpha));
}

}  // namespace

TEST_CASE("thinning response: a Newtonian ink resists the disturbance as it does the flow") {
    const ThinningResponse response(0.0, 0.05);
    for (const double e : {-30.0, 0.0, 5.0}) CHECK(response(e, 2.0) == 0.5);
}

TEST_CASE(
    "thinning response: a small disturbance in weakly thinning ink meets 1 - 2/7 of the thinning exponent") {
    // First order in α: the local exponent m = dlnη/dlnγ̇ = −αX/(1+X), and ⟨(e:ε')²⟩ = (2/7) e:e ⟨ε':ε'⟩.
    const double alpha = 1e-3;
    const double k = 0.1;
    const ThinningResponse response(alpha, k);
    for (const double e : {0.1, 10.0, 1e4}) {
        const double power = std::pow(k * std::numbers::sqrt3 * e, alpha);
        const double m = -alpha * power / (1.0 + power);
        const double ratio = response.integral(e, 1e-3 * e) / undisturbed(alpha, k, e);
        CHECK((ratio - 1.0) / m == doctest::Approx(2.0 / 7.0).epsilon(5e-3));
    }
}

TEST_CASE("thinning response: the table repeats its integral") {
    // The tolerances grow towards an ink at rest around a moving cell, where the far ink keeps its full
    // viscosity.
    for (const double alpha : {0.15, 0.3, 0.5, 0.75, 0.9}) {
        const ThinningResponse response(alpha, 1.0);
        double worst = 0.0;
        double worst_at_rest = 0.0;
        for (double size = 1e-4; size < 30.0; size *= 1.7) {
            for (double angle = -1.57; angle < 1.57; angle += 0.0313) {
                const double e = size * std::cos(angle);
                const double y = size * std::sin(angle);
                const double error = std::abs(response(e, y) / response.integral(e, y) - 1.0);
                worst_at_rest = std::fmax(worst_at_rest, error);
                if (std::abs(angle) < 1.2) worst = std::fmax(worst, error);
            }
        }
        CAPTURE(alpha);
        CHECK(worst < 8e-3 * alpha);
        CHECK(worst_at_rest < 4e-2 * alpha);
    }
}

TEST_CASE(
    "thinning response: reversing the flow and the disturbance changes nothing and reversing one does") {
    const ThinningResponse response(0.75, 0.05);
    CHECK(response(-60.0, 25.0) == doctest::Approx(response(60.0, -25.0)).epsilon(1e-14));
    CHECK(std::abs(response(60.0, 25.0) - response(60.0, -25.0)) > 1e-3);
}

TEST_CASE("thinning response: around a rigid sphere the disturbance meets less viscosity than the flow") {
    const ThinningResponse response(0.75, 0.05);
    for (const double e : {5.0, 50.0, 500.0}) {
        const double ratio = response(-e, e) / undisturbed(0.75, 0.05, e);
        CHECK(ratio < 1.0);
        CHECK(ratio > 0.7);
    }
    CHECK(response(0.0, 0.0) == 1.0);
}
