#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/flow/flow_check.hpp"
#include "bioprint/flow/nozzle_exit.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "numerics/quadrature.hpp"
#include "support/reference_table.hpp"

using namespace bioprint;

namespace {

constexpr double radius = 50e-6;

double relative(double value, double expected) {
    return expected == 0.0 ? std::abs(value) : std::abs(value / expected - 1.0);
}

/// The textbook's flow rate of a Herschel-Bulkley fluid in a pipe of a wall stress, as it is printed: other terms than
/// the program's.
double textbook_flow_rate(const HerschelBulkleyInk& ink, double wall_stress) {
    const double n = ink.flow_index;
    const double over = wall_stress - ink.yield_stress;
    return std::numbers::pi * radius * radius * radius * n * std::pow(over, (n + 1.0) / n) /
           (std::pow(ink.consistency, 1.0 / n) * std::pow(wall_stress, 3)) *
           (over * over / (3.0 * n + 1.0) + 2.0 * ink.yield_stress * over / (2.0 * n + 1.0) +
            ink.yield_stress * ink.yield_stress / (n + 1.0));
}

std::vector<Ink> inks() {
    return {PowerLawInk{.consistency = 30.6, .flow_index = 0.46},
            PowerLawInk{.consistency = 2.0, .flow_index = 1.4},
            CarreauYasudaInk{.eta0 = 50.0, .time_constant = 0.7, .transition = 2.0, .flow_index = 0.3},
            CarreauYasudaInk{
                .eta0 = 50.0, .eta_inf = 0.02, .time_constant = 0.7, .transition = 0.8, .flow_index = 0.2},
            HerschelBulkleyInk{.yield_stress = 60.0, .consistency = 790.0, .flow_index = 0.2},
            HerschelBulkleyInk{.yield_stress = 34.7, .consistency = 30.6, .flow_index = 1.0}};
}

}  // namespace

TEST_CASE("nozzle laws: a Carreau-Yasuda ink meets 50-digit integrals from K rate 1e-12 to 1e12") {
    // What the header promises; at n = 0 the wall stress saturates and amplifies the rounding of u_avg.
    constexpr double tolerance = 1e-11;
    double worst = 0.0;
    for (const test::ReferenceRow& reference : test::read_reference("nozzle_carreau_yasuda.csv")) {
        const auto column = [&](const char* name) { return reference.at(name); };
        const CarreauYasudaInk ink{.eta0 = column("eta0"),
                                   .eta_inf = column("eta_inf"),
                                   .time_constant = column("K"),
                                   .transition = column("transition"),
                                   .flow_index = column("flow_index")};
        CAPTURE(ink.transition);
        CAPTURE(ink.flow_index);
        CAPTURE(ink.time_constant * column("shear_rate_max"));
        // Without a limiting slope the stress comes so near its limit that no double tells the rate any more.
        if (ink.flow_index == 0.0 &&
            ink.transition * std::log10(ink.time_constant * column("shear_rate_max")) > 15.0) {
            continue;
        }
        const NozzleFlow flow = NozzleFlow::from_velocity(ink, column("radius"), column("velocity_average"));
        for (const auto& [value, expected] : {std::pair(flow.shear_rate_max(), column("shear_rate_max")),
                                              {flow.stress_max(), column("stress_max")},
                                              {flow.velocity_max(), column("velocity_max")},
                                              {flow.velocity_excess(), column("velocity_excess")},
                                              {flow.shear_rate_average(), column("shear_rate_average")}}) {
            CHECK(relative(value, expected) < tolerance);
            worst = std::max(worst, relative(value, expected));
        }
    }
    MESSAGE("worst relative error: " << worst);
}

TEST_CASE("nozzle laws: a power-law ink has the textbook's pipe flow at rates from 1e-12 to 1e12") {
    for (const double n : {0.04, 0.2, 0.46, 0.8, 1.0, 1.5}) {
        const PowerLawInk ink{.consistency = 30.6, .flow_index = n};
        for (double rate = 1e-12; rate < 1e13; rate *= 100.0) {
            const double average = rate * radius;
            const NozzleFlow flow = NozzleFlow::from_velocity(ink, radius, average);
            const double wall = (3.0 * n + 1.0) / n * rate;
            CHECK(relative(flow.shear_rate_max(), wall) < 1e-14);
            CHECK(relative(flow.stress_max(), 30.6 * std::pow(wall, n)) < 1e-13);
            CHECK(relative(flow.velocity_max(), average * (3.0 * n + 1.0) / (n + 1.0)) < 1e-14);
            CHECK(relative(flow.velocity_excess(), average * 2.0 * n / (n + 1.0)) < 1e-14);
            CHECK(relative(flow.shear_rate_average(), wall * 2.0 * n / (2.0 * n + 1.0)) < 1e-14);
            // The way back amplifies the rounding of the stress by 1/n.
            const NozzleFlow back = NozzleFlow::from_pressure_gradient(ink, radius, flow.pressure_gradient());
            CHECK(relative(back.velocity_average(), average) < 1e-14 / n * (1.0 + std::abs(std::log(rate))));
            for (const double r : {0.01, 0.3, 0.999}) {
                const double profile = flow.velocity_max() * -std::expm1((n + 1.0) / n * std::log(r));
                CHECK(relative(flow.velocity(r * radius), profile) < 1e-12);
            }
        }
    }
}

TEST_CASE("nozzle laws: a Herschel-Bulkley ink has the textbook's flow rate") {
    for (const double n : {0.2, 0.46, 1.0, 1.3}) {
        const HerschelBulkleyInk ink{.yield_stress = 60.0, .consistency = 8.0, .flow_index = n};
        for (const double over : {1e-3, 0.1, 1.0, 30.0, 1e4}) {
            const double wall_stress = 60.0 * (1.0 + over);
            const NozzleFlow flow =
                NozzleFlow::from_pressure_gradient(ink, radius, 2.0 * wall_stress / radius);
            CHECK(relative(flow.flow_rate(), textbook_flow_rate(ink, wall_stress)) < 1e-12);
            CHECK(flow.plug_radius() == doctest::Approx(radius / (1.0 + over)).epsilon(1e-14));
            const NozzleFlow back = NozzleFlow::from_flow_rate(ink, radius, flow.flow_rate());
            CHECK(relative(back.stress_max(), wall_stress) < 1e-12);
            CHECK(relative(back.shear_rate_max(), flow.shear_rate_max()) < 1e-12);
        }
    }
}

TEST_CASE("nozzle laws: Bingham's plastic has the flow rate of Buckingham and Reiner") {
    const HerschelBulkleyInk ink{.yield_stress = 34.7, .consistency = 0.3, .flow_index = 1.0};
    for (const double wall_stress : {40.0, 100.0, 1e4}) {
        const NozzleFlow flow = NozzleFlow::from_pressure_gradient(ink, radius, 2.0 * wall_stress / radius);
        const double phi = 34.7 / wall_stress;
        const double newtonian = std::numbers::pi * std::pow(radius, 3) * wall_stress / (4.0 * 0.3);
        CHECK(relative(flow.flow_rate(), newtonian * (1.0 - 4.0 / 3.0 * phi + std::pow(phi, 4) / 3.0)) <
              1e-12);
    }
}

TEST_CASE("nozzle laws: an almost whole plug keeps the relative accuracy of what moves in it") {
    // To first order in ψ = 1 − φ: u_max = R γ̇_w ψ n/(1+n) and u_max − u_avg = 6 n² ψ²/((1+n)(1+2n)) R γ̇_w/3. Here ψ is
    // 1e-12, where their plain differences hold no digit.
    const double n = 0.5;
    for (const double sheared : {1e-6, 1e-9, 1e-12}) {
        const double rate = std::pow(sheared / (1.0 - sheared), 1.0 / n);
        const HerschelBulkleyInk ink{.yield_stress = 1.0, .consistency = 1.0, .flow_index = n};
        const NozzleFlow flow = NozzleFlow::from_wall_rate(ink, radius, rate);
        const double scale = radius * rate;
        CHECK(relative(flow.velocity_max(), scale * sheared * n / (1.0 + n)) < 1e-13);
        CHECK(relative(flow.velocity_excess(),
                       2.0 * n * n * sheared * sheared / ((1.0 + n) * (1.0 + 2.0 * n)) * scale) <
              2.0 * sheared + 1e-13);
        const NozzleFlow back = NozzleFlow::from_velocity(ink, radius, flow.velocity_average());
        CHECK(relative(back.velocity_excess(), flow.velocity_excess()) < 1e-11);
        CHECK(relative(back.shear_rate_max(), rate) < 1e-11);
    }
}

TEST_CASE("nozzle laws: below its yield stress an ink is refused with the gradient that moves it") {
    const HerschelBulkleyInk ink{.yield_stress = 60.0, .consistency = 790.0, .flow_index = 0.2};
    const double threshold = 2.0 * 60.0 / radius;
    for (const double part : {1e-9, 0.5, 1.0}) {
        CHECK_THROWS_WITH_AS(NozzleFlow::from_pressure_gradient(ink, radius, part * threshold),
                             doctest::Contains("above a pressure gradient of 2.4e+06 Pa/m"), NoSteadyFlow);
    }
    CHECK(NozzleFlow::from_pressure_gradient(ink, radius, threshold * 1.01).velocity_average() > 0.0);
    CHECK(NozzleFlow::from_pressure_gradient(ink, radius, 0.0).velocity_average() == 0.0);
    const NozzleFlow rest = NozzleFlow::from_velocity(ink, radius, 0.0);
    CHECK(rest.stress_max() == 0.0);
    CHECK(rest.plug_radius() == radius);
    CHECK(nozzle_exit(rest).elongational_stress == 0.0);
}

TEST_CASE("nozzle laws: the plug moves as one and the shear begins at its edge") {
    const HerschelBulkleyInk ink{.yield_stress = 60.0, .consistency = 79.0, .flow_index = 0.4};
    const NozzleFlow flow = NozzleFlow::from_velocity(ink, radius, 5e-3);
    const double edge = flow.plug_radius();
    REQUIRE(edge > 0.05 * radius);
    CHECK(flow.velocity(0.5 * edge) == flow.velocity_max());
    CHECK(flow.shear_rate(0.999 * edge) == 0.0);
    CHECK(flow.shear_rate(1.001 * edge) > 0.0);
    CHECK(flow.velocity(1.01 * edge) < flow.velocity_max());
    CHECK(flow.stress(edge) == doctest::Approx(60.0).epsilon(1e-14));
}

TEST_CASE("nozzle laws: adaptive quadrature over the profile gives flow rate and excess back") {
    for (const Ink& ink : inks()) {
        CAPTURE(law_name(ink));
        for (const double average : {1e-6, 5e-3, 1.0}) {
            const NozzleFlow flow = NozzleFlow::from_velocity(ink, radius, average);
            const double edge = flow.plug_radius();
            const auto ring = [&](double r) { return 2.0 * std::numbers::pi * r * flow.velocity(r); };
            const double rate = std::numbers::pi * edge * edge * flow.velocity_max() +
                                integrate(ring, edge, radius, 1e-10).value;
            CHECK(relative(rate, flow.flow_rate()) < 1e-9);
            const FlowCheck check = check_flow(flow);
            CHECK(relative(check.velocity_average, average) < 1e-9);
            CHECK(relative(check.velocity_excess, flow.velocity_excess()) < 1e-9);
        }
    }
}

TEST_CASE("nozzle laws: the velocity falls at the rate of strain") {
    for (const Ink& ink : inks()) {
        CAPTURE(law_name(ink));
        const NozzleFlow flow = NozzleFlow::from_velocity(ink, radius, 5e-3);
        for (const double place : {0.3, 0.6, 0.9, 0.999}) {
            const double r = place * radius;
            const double h = 1e-5 * radius;
            const double slope = (flow.velocity(r - h) - flow.velocity(r + h)) / (2.0 * h);
            CHECK(std::abs(slope - flow.shear_rate(r)) < 1e-5 * flow.shear_rate_max());
        }
    }
}

TEST_CASE("nozzle laws: a Carreau-Yasuda ink whose transition is 1 minus n flows as the Cross ink") {
    for (const double alpha : {0.3, 0.75, 1.0}) {
        for (const double eta_inf : {0.0, 1e-3}) {
            const CrossInk cross{.eta0 = 10.0, .eta_inf = eta_inf, .time_constant = 0.05, .alpha = alpha};
            const CarreauYasudaInk same{.eta0 = 10.0,
                                        .eta_inf = eta_inf,
                                        .time_constant = 0.05,
                                        .transition = alpha,
                                        .flow_index = 1.0 - alpha};
            for (const double average : {1e-9, 1e-5, 5e-3}) {
                if (alpha == 1.0 && eta_inf == 0.0 && average > 1e-4) continue;  // near the saturation
                const NozzleFlow a = NozzleFlow::from_velocity(cross, radius, average);
                const NozzleFlow b = NozzleFlow::from_velocity(same, radius, average);
                CHECK(relative(b.stress_max(), a.stress_max()) < 1e-12);
                CHECK(relative(b.velocity_excess(), a.velocity_excess()) < 1e-12);
                CHECK(relative(b.velocity(0.7 * radius), a.velocity(0.7 * radius)) < 1e-12);
                CHECK(relative(nozzle_exit(b).elongational_stress, nozzle_exit(a).elongational_stress) <
                      1e-12);
            }
        }
    }
}

TEST_CASE("nozzle laws: far past its time constant a Carreau-Yasuda ink flows as the power law") {
    const double n = 0.4;
    const CarreauYasudaInk ink{.eta0 = 10.0, .time_constant = 0.05, .transition = 2.0, .flow_index = n};
    const PowerLawInk limit{.consistency = 10.0 * std::pow(0.05, n - 1.0), .flow_index = n};
    for (const double x : {1e4, 1e8, 1e12}) {
        const NozzleFlow a = NozzleFlow::from_wall_rate(ink, radius, x / 0.05);
        const NozzleFlow b = NozzleFlow::from_wall_rate(limit, radius, x / 0.05);
        // The plateau near the axis reaches x⁻² into the integrals, and x^−(1+n) where they weigh it by the rate.
        const double bound = 10.0 * std::pow(x, -(1.0 + n)) + 1e-12;
        CHECK(relative(a.velocity_average(), b.velocity_average()) < bound);
        CHECK(relative(a.velocity_max(), b.velocity_max()) < bound);
        CHECK(relative(a.velocity_excess(), b.velocity_excess()) < bound);
    }
}

TEST_CASE("nozzle laws: the exit of a yielding ink bears its yield stress at least") {
    const HerschelBulkleyInk ink{.yield_stress = 60.0, .consistency = 79.0, .flow_index = 0.4};
    for (const double average : {1e-12, 1e-6, 5e-3}) {
        const NozzleExit exit = nozzle_exit(NozzleFlow::from_velocity(ink, radius, average));
        CHECK(exit.elongation_rate > 0.0);
        CHECK(exit.elongational_stress ==
              doctest::Approx(60.0 + 79.0 * std::pow(std::sqrt(3.0) * exit.elongation_rate, 0.4))
                  .epsilon(1e-14));
    }
    CHECK_FALSE(flow_at_elongational_stress(ink, radius, 59.0).has_value());
    const auto edge = flow_at_elongational_stress(ink, radius, 300.0);
    REQUIRE(edge.has_value());
    CHECK(nozzle_exit(*edge).elongational_stress == doctest::Approx(300.0).epsilon(1e-9));
}

TEST_CASE("nozzle laws: an ink whose stress saturates is refused past it") {
    const CarreauYasudaInk ink{.eta0 = 10.0, .time_constant = 0.05, .transition = 1.0, .flow_index = 0.0};
    CHECK_THROWS_AS(NozzleFlow::from_velocity(ink, radius, 100.0), NoSteadyFlow);
    CHECK_THROWS_AS(NozzleFlow::from_pressure_gradient(ink, radius, 2.0 / radius * 200.0), NoSteadyFlow);
}
