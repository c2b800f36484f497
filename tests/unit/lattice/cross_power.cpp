#include "lattice/cross_power.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

TEST_CASE("lattice power: the polynomial power matches the library to single precision") {
    double worst = 0.0;
    for (double exponent = -29.0; exponent < 29.0; exponent += 0.0137) {
        for (const float p : {0.05F, 0.075F, 0.375F, 0.5F, 1.0F}) {
            const auto y = static_cast<float>(std::pow(10.0, exponent));
            const double exact = std::pow(static_cast<double>(y), static_cast<double>(p));
            const auto value = static_cast<double>(bioprint::d3q19::power(y, p));
            worst = std::max(worst, std::abs(value / exact - 1.0));
        }
    }
    CHECK(worst < 4e-6);  // the rounding of p log2 y, up to 96, dominates at the far ends
    double near_one = 0.0;
    for (double y = 1e-3; y < 1e3; y *= 1.01) {
        const auto value = static_cast<double>(bioprint::d3q19::power(static_cast<float>(y), 0.375F));
        near_one = std::max(
            near_one, std::abs(value / std::pow(static_cast<double>(static_cast<float>(y)), 0.375) - 1.0));
    }
    CHECK(near_one < 5e-7);
}

TEST_CASE("lattice power: the polynomial power matches the library to double precision") {
    double worst = 0.0;
    for (double exponent = -29.0; exponent < 29.0; exponent += 0.0137) {
        for (const double p : {0.05, 0.375, 0.5, 1.0}) {
            const double y = std::pow(10.0, exponent);
            worst = std::max(worst, std::abs(bioprint::d3q19::power(y, p) / std::pow(y, p) - 1.0));
        }
    }
    CHECK(worst < 2e-14);
}

TEST_CASE("lattice power: zero and infinity stay finite and positive") {
    CHECK(bioprint::d3q19::power(0.0, 0.375) > 0.0);
    CHECK(bioprint::d3q19::power(0.0, 0.375) < 1e-10);
    CHECK(std::isfinite(bioprint::d3q19::power(HUGE_VAL, 0.5)));
    CHECK(std::isfinite(bioprint::d3q19::power(HUGE_VALF, 0.5F)));
}
