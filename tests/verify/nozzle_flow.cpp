#include "bioprint/flow/nozzle_flow.hpp"

#include <doctest/doctest.h>
#include <gsl/gsl_sf_hyperg.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_exit.hpp"
#include "numerics/quadrature.hpp"
#include "support/reference_table.hpp"

using namespace bioprint;

namespace {

constexpr double radius = 50e-6;
CrossInk ink(double alpha) {
    return {.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha};
}

double relative(double value, double expected) {
    return expected == 0.0 ? std::abs(value) : std::abs(value / expected - 1.0);
}

/// Rounds to the digits a table prints, so that "every printed digit" is what is compared.
double printed(double value, int digits) {
    const double scale = std::pow(10.0, digits);
    return std::round(value * scale) / scale;
}

}  // namespace

TEST_CASE("nozzle flow: 50-digit closed forms are met from K rate 1e-12 to 1e12") {
    // 1e-10 is what the reference promises; alpha near 1 at x = 1e12 amplifies the rounding of u_avg itself.
    constexpr double tolerance = 1e-10;
    double worst = 0.0;
    for (const test::ReferenceRow& reference : test::read_reference("nozzle_flow.csv")) {
        const auto column = [&](const char* name) { return reference.at(name); };
        const CrossInk row{.eta0 = column("eta0"), .time_constant = column("K"), .alpha = column("alpha")};
        const NozzleFlow flow = NozzleFlow::from_flow_rate(row, column("radius"), column("flow_rate"));
        const NozzleExit exit = nozzle_exit(flow);
        CAPTURE(row.alpha);
        CAPTURE(row.time_constant * column("shear_rate_max"));
        const std::vector<std::pair<double, double>> pairs = {
            {flow.velocity_average(), column("velocity_average")},
            {flow.velocity_max(), column("velocity_max")},
            {flow.pressure_gradient(), column("pressure_gradient")},
            {flow.stress_max(), column("stress_max")},
            {flow.stress_average(), column("stress_average")},
            {flow.shear_rate_max(), column("shear_rate_max")},
            {flow.shear_rate_average(), column("shear_rate_average")},
            {exit.elongation_rate, column("elongation_rate")},
            {exit.elongational_stress, column("elongational_stress")}};
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            CAPTURE(k);
            CHECK(relative(pairs[k].first, pairs[k].second) < tolerance);
            worst = std::max(worst, relative(pairs[k].first, pairs[k].second));
        }
    }
    MESSAGE("worst relative error: " << worst);
}

TEST_CASE("nozzle flow: Table I of the paper is met to every printed digit") {
    struct Row {
        double alpha, gradient, stress_max, stress_average, velocity_max, rate_max, rate_average;
    };
    const std::vector<Row> rows = {
        {0.00, 8.00, 2.00, 1.33, 10.0, 400, 267}, {0.15, 6.37, 1.59, 1.06, 9.77, 410, 265},
        {0.30, 4.87, 1.22, 0.81, 9.45, 426, 262}, {0.45, 3.58, 0.89, 0.60, 9.03, 454, 257},
        {0.60, 2.54, 0.63, 0.42, 8.47, 502, 251}, {0.75, 1.74, 0.44, 0.29, 7.77, 604, 242}};
    for (const Row& row : rows) {
        CAPTURE(row.alpha);
        const NozzleFlow flow = NozzleFlow::from_velocity(ink(row.alpha), radius, 5e-3);
        CHECK(printed(flow.pressure_gradient() * 1e-7, 2) == row.gradient);
        CHECK(printed(flow.stress_max() * 1e-3, 2) == row.stress_max);
        CHECK(printed(flow.stress_average() * 1e-3, 2) == row.stress_average);
        CHECK(printed(flow.velocity_max() * 1e3, row.alpha == 0.0 ? 1 : 2) == row.velocity_max);
        CHECK(printed(flow.shear_rate_max(), 0) == row.rate_max);
        CHECK(printed(flow.shear_rate_average(), 0) == row.rate_average);
    }
}

TEST_CASE("nozzle flow: an OpenFOAM case of a published validation is met by the exact theory") {
    // Zhang et al. 2024 (in-silico bioink viability): OpenFOAM gives 3.00 µL/s; 50-digit theory 3.0076.
    const CrossInk alginate{.eta0 = 203.20667, .eta_inf = 1e-3, .time_constant = 0.981701, .alpha = 0.666894};
    const NozzleFlow flow = NozzleFlow::from_pressure_gradient(alginate, 0.1e-3, 1465.807e3 / 20e-3);
    CHECK(flow.flow_rate() * 1e9 == doctest::Approx(3.0076).epsilon(5e-5));
}

TEST_CASE("nozzle flow: the moments agree with their closed form in 2F1") {
    // ∫_0^x t^n dx = x^(n+1)/(n+1) 2F1(n, (n+1)/α; 1+(n+1)/α; −x^α); the Pfaff transformation brings the
    // argument into GSL's range. The plain differences cancel, so their tolerance carries the factor x_w/(x_w
    // − I).
    for (const double alpha : {0.3, 0.6, 0.75}) {
        for (const double velocity : {1e-5, 1e-4, 5e-3}) {
            const CrossInk law = ink(alpha);
            const NozzleFlow flow = NozzleFlow::from_velocity(law, radius, velocity);
            const double x = law.time_constant * flow.shear_rate_max();
            const double y = std::pow(x, alpha);
            const double t = x / (1.0 + y);
            const auto moment = [&](int n) {
                const double b = (n + 1) / alpha;
                const double f = std::pow(1.0 + y, -n) * gsl_sf_hyperg_2F1(n, 1.0, 1.0 + b, y / (1.0 + y));
                return std::pow(x, n + 1) / (n + 1) * f;
            };
            const double scale = radius / law.time_constant;
            CHECK(relative(scale / 3.0 * (x - moment(3) / (t * t * t)), flow.velocity_average()) < 1e-12);
            CHECK(relative(scale * (x - moment(1) / t), flow.velocity_max()) < 1e-12);
            CHECK(relative((x - moment(2) / (t * t)) / law.time_constant, flow.shear_rate_average()) < 1e-12);
        }
    }
}

TEST_CASE("nozzle flow: adaptive quadrature over the velocity profile gives the flow rate back") {
    for (const double alpha : {0.0, 0.75, 0.95}) {
        const NozzleFlow flow = NozzleFlow::from_velocity(ink(alpha), radius, 5e-3);
        const Integral rate = integrate(
            [&](double r) { return 2.0 * std::numbers::pi * r * flow.velocity(r); }, 0.0, radius, 1e-11);
        CHECK(relative(rate.value, flow.flow_rate()) < 1e-10);
    }
}

TEST_CASE("nozzle flow: the velocity profile of a Newtonian ink is the parabola") {
    const NozzleFlow flow = NozzleFlow::from_velocity(ink(0.0), radius, 5e-3);
    for (double r = 0.0; r <= radius; r += radius / 16.0) {
        CHECK(flow.velocity(r) == doctest::Approx(1e-2 * (1.0 - r * r / radius / radius)).epsilon(1e-13));
    }
    CHECK(flow.velocity(0.0) == flow.velocity_max());
    CHECK(flow.velocity(radius) == 0.0);
}

TEST_CASE("nozzle flow: the four ways to drive a flow describe the same flow") {
    for (const double alpha : {0.0, 0.5, 0.75, 1.0, 1.5}) {
        const CrossInk law{.eta0 = 10.0, .time_constant = 1e-3, .alpha = alpha};
        const NozzleFlow a = NozzleFlow::from_velocity(law, radius, 1e-3);
        const NozzleFlow b = NozzleFlow::from_flow_rate(law, radius, a.flow_rate());
        const NozzleFlow c = NozzleFlow::from_pressure_gradient(law, radius, a.pressure_gradient());
        CHECK(relative(b.pressure_gradient(), a.pressure_gradient()) < 1e-14);
        CHECK(relative(c.velocity_average(), a.velocity_average()) < 1e-12);
        CHECK(relative(c.velocity_excess(), a.velocity_excess()) < 1e-12);
    }
}

TEST_CASE("nozzle flow: a plug keeps the relative accuracy of u_max minus u_avg") {
    // α = 1: ∫(1−q)²(2+q)dx in closed form is not needed; the plain difference loses ln(x)/x, the positive
    // form none.
    const CrossInk law = ink(1.0);
    const NozzleFlow flow =
        NozzleFlow::from_pressure_gradient(law, radius, 2.0 / radius * 200.0 * (1.0 - 1e-9));
    const double x = 1e9 - 1.0;
    // q = c x/(1+x) with c = (1+x_w)/x_w; u_max = R/K (x_w − c (x_w − ln(1+x_w))) = R/K (c ln(1+x_w) − 1)
    const double c = (1.0 + x) / x;
    CHECK(relative(flow.velocity_max(), radius / 0.05 * (c * std::log1p(x) - 1.0)) <
          1e-7);  // load known to 1e-16/1e-9
    CHECK(flow.velocity_excess() > 0.0);
    CHECK(relative(flow.velocity_excess(), flow.velocity_max() - flow.velocity_average()) < 1e-12);
}

TEST_CASE("nozzle flow: no flow is a flow with nothing in it") {
    const NozzleFlow flow = NozzleFlow::from_flow_rate(ink(0.75), radius, 0.0);
    CHECK(flow.stress_max() == 0.0);
    CHECK(flow.velocity(0.0) == 0.0);
    CHECK(nozzle_exit(flow).elongational_stress == 0.0);
}

TEST_CASE("nozzle flow: what an ink cannot bear is refused") {
    CHECK_THROWS_AS(NozzleFlow::from_velocity(ink(2.0), radius, 1.0), NoSteadyFlow);
    CHECK_THROWS_AS(NozzleFlow::from_velocity(ink(1.0), radius, 100.0), NoSteadyFlow);
    CHECK_THROWS_AS(NozzleFlow::from_pressure_gradient(ink(1.0), radius, 2.0 / radius * 200.0), NoSteadyFlow);
}
