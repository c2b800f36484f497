#include "bioprint/predict/streamline_passage.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/predict/exit_passage.hpp"

namespace {

using namespace bioprint;

constexpr double radius = 50e-6;

NozzleFlow nozzle(double alpha) {
    return NozzleFlow::from_velocity({.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}, radius, 5e-3);
}

}  // namespace

TEST_CASE("streamline passage: next to the axis it is the passage on the axis by another integrator") {
    const AxisEffects none{.volume_average = false, .quadratic_flow = false, .disturbed_viscosity = false};
    for (const double alpha : {0.0, 0.3, 0.75}) {
        const NozzleFlow flow = nozzle(alpha);
        const auto axis =
            exit_passage(flow, {.cell = {.radius = 8e-6, .shear_modulus = 1000.0}, .effects = none}).passage;
        const auto beside =
            streamline_passage(flow, {.start_radius = 1e-5 * radius, .shear_modulus = 1000.0});
        CHECK(beside.exit_peak == doctest::Approx(axis.peak.von_mises).epsilon(2e-3));
        CHECK(beside.exit_shear_share < 1e-6);
        CHECK(beside.place == StreamlinePlace::exit);
    }
}

TEST_CASE("streamline passage: without a length the cell has settled in the nozzle at Roscoe's stress") {
    const NozzleFlow flow = nozzle(0.3);
    const double r = 0.6 * radius;
    const auto p =
        streamline_passage(flow, {.start_radius = r, .shear_modulus = 1000.0, .viscosity_ratio = 2.0});
    const auto steady = roscoe_shear({.fluid_stress = flow.stress(r),
                                      .shear_rate = flow.shear_rate(r),
                                      .shear_modulus = 1000.0,
                                      .viscosity_ratio = 2.0});
    CHECK(p.nozzle_steady == doctest::Approx(steady.von_mises).epsilon(1e-12));
    CHECK(p.nozzle_peak == p.nozzle_steady);
    CHECK(!p.exposure.has_value());
    // The shape it enters the exit with does not change until the exit is felt.
    CHECK(p.exit_peak == doctest::Approx(steady.von_mises).epsilon(0.02));
}

TEST_CASE(
    "streamline passage: a nozzle long enough starts up with an overshoot and ends as if it had no "
    "beginning") {
    // σ_f/μ = 1.5 in a Newtonian ink: 7.20 before 4.80.
    const NozzleFlow flow = nozzle(0.0);
    const double r = 0.5 * radius;
    const double modulus = flow.stress(r) / 1.5;
    const auto p = streamline_passage(flow, {.start_radius = r, .shear_modulus = modulus, .length = 0.02});
    CHECK(p.nozzle_peak / modulus == doctest::Approx(7.206).epsilon(2e-3));
    CHECK(p.nozzle_steady / modulus == doctest::Approx(4.801).epsilon(1e-3));
    CHECK(p.settles.value());
    CHECK(p.settling_time.value() > 0.0);
    CHECK(p.settling_time.value() < 0.02 / flow.velocity(r));
    const auto settled = streamline_passage(flow, {.start_radius = r, .shear_modulus = modulus});
    CHECK(p.exit_peak == doctest::Approx(settled.exit_peak).epsilon(1e-4));
    // A long nozzle's exposure is the steady stress times the residence, but for the start.
    CHECK(p.exposure.value() ==
          doctest::Approx(p.nozzle_steady * (0.02 - 4 * radius) / flow.velocity(r)).epsilon(0.02));
}

TEST_CASE("streamline passage: a short nozzle is left before the cell has settled") {
    const NozzleFlow flow = nozzle(0.75);
    const auto p =
        streamline_passage(flow, {.start_radius = 0.3 * radius, .shear_modulus = 1000.0, .length = 250e-6});
    CHECK(!p.settles.value());
    CHECK(!p.settling_time.has_value());
    CHECK(p.nozzle_peak < p.nozzle_steady);
}

TEST_CASE("streamline passage: positions outside the nozzle and cells without stiffness are refused") {
    const NozzleFlow flow = nozzle(0.3);
    CHECK_THROWS_AS(streamline_passage(flow, {.start_radius = -1e-9, .shear_modulus = 1000.0}), UsageError);
    CHECK_THROWS_AS(streamline_passage(flow, {.start_radius = radius, .shear_modulus = 1000.0}), UsageError);
    CHECK_THROWS_AS(streamline_passage(flow, {.start_radius = 0.1 * radius, .shear_modulus = 0.0}),
                    UsageError);
}
