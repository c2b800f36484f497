#include "lattice/fast_power.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace bioprint::lattice;

TEST_CASE("fast power: 2^(a log2 x) is x^a to 3e-13 over forty decades") {
    for (double exponent : {0.0, 0.075, 0.375, 0.5, 0.9}) {
        for (double decade = -20.0; decade <= 20.0; decade += 0.0137) {
            const double x = std::pow(10.0, decade);
            const double exact = std::pow(x, exponent);
            CHECK(std::abs(fast_exp2(exponent * fast_log2(x)) / exact - 1.0) < 3e-13);
        }
    }
}

TEST_CASE("fast power: powers of two have exact logarithms") {
    for (int n = -300; n <= 300; n += 7) {
        CHECK(fast_log2(std::ldexp(1.0, n)) == n);
    }
}

TEST_CASE("fast power: the smallest argument of the kernels gives a finite power") {
    const double power = fast_exp2(0.45 * fast_log2(1e-280));
    CHECK(power >= 0.0);
    CHECK(power < 1e-100);
}
