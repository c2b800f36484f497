#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/rheology/ink.hpp"

using namespace bioprint;

namespace {

/// Rounding of a logarithm of magnitude 60, amplified by the slope 1/n of the inverse, n ≥ 0.2 here.
constexpr double rounding = 2e-13;

std::vector<Ink> inks() {
    return {CrossInk{.eta0 = 10.0, .eta_inf = 1e-3, .time_constant = 0.05, .alpha = 0.75},
            PowerLawInk{.consistency = 30.6, .flow_index = 0.46},
            PowerLawInk{.consistency = 0.15, .flow_index = 1.0},
            PowerLawInk{.consistency = 2.0, .flow_index = 1.4},
            CarreauYasudaInk{.eta0 = 50.0, .time_constant = 0.7, .transition = 2.0, .flow_index = 0.3},
            CarreauYasudaInk{
                .eta0 = 50.0, .eta_inf = 0.02, .time_constant = 0.7, .transition = 0.8, .flow_index = 0.2},
            HerschelBulkleyInk{.yield_stress = 60.0, .consistency = 790.0, .flow_index = 0.2},
            HerschelBulkleyInk{.yield_stress = 34.7, .consistency = 30.6, .flow_index = 1.0}};
}

}  // namespace

TEST_CASE("laws: the rate at a stress is the inverse of the stress at a rate") {
    for (const Ink& ink : inks()) {
        CAPTURE(law_name(ink));
        for (double rate = 1e-12; rate < 1e13; rate *= 7.3) {
            const double load = stress(ink, rate);
            // Near the yield stress a load in double precision tells its rate to eps τ/(τ − τ_y)/n only.
            const double flowing = load - yield_stress(ink);
            if (flowing < 1e-3 * load) continue;
            CHECK(rate_at_stress(ink, load) == doctest::Approx(rate).epsilon(rounding * load / flowing));
        }
        CHECK(rate_at_stress(ink, 0.0) == 0.0);
    }
}

TEST_CASE("laws: the flow index is the logarithmic slope of the stress") {
    for (const Ink& ink : inks()) {
        CAPTURE(law_name(ink));
        for (double rate = 1e-9; rate < 1e10; rate *= 31.0) {
            constexpr double h = 1e-4;  // the difference is exact to h² and to 1e-16/h
            const double slope =
                std::log(stress(ink, rate * std::exp(h)) / stress(ink, rate * std::exp(-h))) / (2.0 * h);
            CHECK(std::abs(flow_index(ink, rate) - slope) < 1e-7);
        }
    }
}

TEST_CASE("laws: viscosity times rate is the stress") {
    for (const Ink& ink : inks()) {
        for (double rate = 1e-12; rate < 1e13; rate *= 11.0) {
            CHECK(viscosity(ink, rate) * rate == doctest::Approx(stress(ink, rate)).epsilon(1e-14));
        }
    }
}

TEST_CASE("laws: an ink of any law answers as its own law does") {
    const HerschelBulkleyInk law{.yield_stress = 60.0, .consistency = 790.0, .flow_index = 0.2};
    const Ink ink = law;
    CHECK(law_name(ink) == "herschel-bulkley");
    CHECK(law_name(Ink(CrossInk{.eta0 = 1.0, .time_constant = 1.0, .alpha = 0.5})) == "cross");
    CHECK(stress(ink, 3.0) == stress(law, 3.0));
    CHECK(yield_stress(ink) == 60.0);
    CHECK(yield_stress(Ink(PowerLawInk{.consistency = 1.0, .flow_index = 0.5})) == 0.0);
    CHECK_THROWS_AS(cross_law(ink, "test"), UsageError);
}

TEST_CASE("laws: a Carreau-Yasuda ink of index 1 is Newtonian with its zero-shear viscosity") {
    const CarreauYasudaInk ink{.eta0 = 7.0, .eta_inf = 0.1, .time_constant = 0.3, .flow_index = 1.0};
    for (double rate = 1e-12; rate < 1e13; rate *= 100.0) {
        CHECK(viscosity(ink, rate) == doctest::Approx(7.0).epsilon(1e-15));
        CHECK(rate_at_stress(ink, 7.0 * rate) == doctest::Approx(rate).epsilon(1e-15));
    }
}

TEST_CASE("laws: a Carreau-Yasuda ink of transition 2 is Carreau's law") {
    const CarreauYasudaInk ink{.eta0 = 10.0, .eta_inf = 0.01, .time_constant = 0.05, .flow_index = 0.4};
    for (double rate = 1e-9; rate < 1e10; rate *= 17.0) {
        const double x = 0.05 * rate;
        const double carreau = 0.01 + 9.99 * std::pow(1.0 + x * x, -0.3);
        CHECK(viscosity(ink, rate) == doctest::Approx(carreau).epsilon(1e-14));
    }
}

TEST_CASE("laws: a Carreau-Yasuda ink whose transition is 1 minus n is a Cross ink") {
    for (const double alpha : {0.2, 0.75, 1.0}) {
        for (const double eta_inf : {0.0, 0.01}) {
            const CrossInk cross{.eta0 = 10.0, .eta_inf = eta_inf, .time_constant = 0.05, .alpha = alpha};
            const CarreauYasudaInk ink{.eta0 = 10.0,
                                       .eta_inf = eta_inf,
                                       .time_constant = 0.05,
                                       .transition = alpha,
                                       .flow_index = 1.0 - alpha};
            for (double rate = 1e-12; rate < 1e13; rate *= 13.0) {
                CHECK(viscosity(ink, rate) == doctest::Approx(viscosity(cross, rate)).epsilon(1e-14));
                CHECK(flow_index(ink, rate) == doctest::Approx(flow_index(cross, rate)).epsilon(1e-12));
            }
        }
    }
}

TEST_CASE("laws: far past its time constant a Carreau-Yasuda ink is a power-law ink") {
    for (const double a : {0.5, 2.0, 40.0}) {
        const CarreauYasudaInk ink{.eta0 = 10.0, .time_constant = 0.05, .transition = a, .flow_index = 0.4};
        const PowerLawInk limit{.consistency = 10.0 * std::pow(0.05, -0.6), .flow_index = 0.4};
        for (double x = 1e3; x < 1e13; x *= 10.0) {
            // The next order is (1 − n)/a x^−a.
            const double bound = 0.6 / a * std::pow(x, -a) + 1e-13;
            CHECK(std::abs(stress(ink, x / 0.05) / stress(limit, x / 0.05) - 1.0) <= bound);
        }
    }
}

TEST_CASE("laws: a saturating Carreau-Yasuda ink bears its saturation stress and no more") {
    const CarreauYasudaInk ink{.eta0 = 10.0, .time_constant = 0.05, .transition = 1.0, .flow_index = 0.0};
    // t = x/(1+x), as the Cross law at α = 1.
    CHECK(rate_at_stress(ink, 199.0) ==
          doctest::Approx(199.0 / 200.0 * 20.0 / (1.0 - 199.0 / 200.0)).epsilon(1e-12));
    CHECK_THROWS_AS(rate_at_stress(ink, 200.0), NoSteadyFlow);
}

TEST_CASE("laws: below its yield stress an ink does not flow") {
    const HerschelBulkleyInk ink{.yield_stress = 60.0, .consistency = 790.0, .flow_index = 0.2};
    CHECK(rate_at_stress(ink, 59.999) == 0.0);
    CHECK(rate_at_stress(ink, 60.0) == 0.0);
    CHECK(rate_at_stress(ink, 60.0 + 790.0) == doctest::Approx(1.0).epsilon(1e-14));
    CHECK(stress(ink, 0.0) == 60.0);
    CHECK(flow_index(ink, 0.0) == 0.0);
    CHECK(std::isinf(viscosity(ink, 0.0)));
}

TEST_CASE("laws: a yield stress of 0 leaves the power law") {
    const HerschelBulkleyInk ink{.yield_stress = 0.0, .consistency = 30.6, .flow_index = 0.46};
    const PowerLawInk limit{.consistency = 30.6, .flow_index = 0.46};
    for (double rate = 1e-12; rate < 1e13; rate *= 19.0) {
        CHECK(stress(ink, rate) == stress(limit, rate));
        CHECK(viscosity(ink, rate) == viscosity(limit, rate));
        CHECK(flow_index(ink, rate) == flow_index(limit, rate));
        CHECK(rate_at_stress(ink, 30.6 * rate) == rate_at_stress(limit, 30.6 * rate));
    }
    CHECK_FALSE(std::isnan(viscosity(ink, 0.0)));
    CHECK_FALSE(std::isnan(
        viscosity(HerschelBulkleyInk{.yield_stress = 0.0, .consistency = 1.0, .flow_index = 1.5}, 0.0)));
}

TEST_CASE("laws: a load that shears an ink faster than any number is refused") {
    CHECK_THROWS_AS(rate_at_stress(PowerLawInk{.consistency = 1e-3, .flow_index = 0.05}, 1e6), NoSteadyFlow);
    CHECK_THROWS_AS(
        rate_at_stress(HerschelBulkleyInk{.yield_stress = 1.0, .consistency = 1e-3, .flow_index = 0.05}, 1e6),
        NoSteadyFlow);
}
