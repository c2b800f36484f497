#include "bioprint/predict/population.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"

namespace {

using namespace bioprint;

constexpr double radius = 50e-6;
constexpr double cell_radius = 8e-6;

NozzleFlow nozzle(double alpha) {
    return NozzleFlow::from_velocity(CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}, radius,
                                     5e-3);
}

PopulationRequest cells(int nodes = 16) {
    return {.cell_radius = cell_radius,
            .shear_modulus = 1000.0,
            .length = 5e-3,
            .thresholds = {1000.0, 3000.0},
            .nodes = nodes};
}

void check_close(const Distribution& a, const Distribution& b, double tolerance) {
    CHECK(a.mean == doctest::Approx(b.mean).epsilon(tolerance));
    CHECK(a.median == doctest::Approx(b.median).epsilon(tolerance));
    CHECK(a.percentile_90 == doctest::Approx(b.percentile_90).epsilon(tolerance));
    CHECK(a.percentile_95 == doctest::Approx(b.percentile_95).epsilon(tolerance));
    CHECK(a.percentile_99 == doctest::Approx(b.percentile_99).epsilon(tolerance));
}

}  // namespace

TEST_CASE("population: sixteen streamlines give what ninety-six give to a thousandth") {
    for (const double alpha : {0.0, 0.75}) {
        const NozzleFlow flow = nozzle(alpha);
        const Population coarse = population(flow, cells());
        const Population fine = population(flow, cells(96));
        check_close(coarse.peak_stress, fine.peak_stress, 1e-3);
        check_close(*coarse.exposure, *fine.exposure, 1e-3);
        for (std::size_t i = 0; i < 2; ++i)
            CHECK(std::abs(coarse.share_above[i] - fine.share_above[i]) < 1e-3);
        CHECK(std::abs(coarse.share_peaking_at_exit - fine.share_peaking_at_exit) < 2e-3);
    }
}

TEST_CASE("population: the number of threads does not change a bit") {
    const NozzleFlow flow = nozzle(0.75);
    PopulationRequest request = cells();
    const Population alone = population(flow, request);
    request.jobs = 3;
    const Population shared = population(flow, request);
    CHECK(alone.radius == shared.radius);
    CHECK(alone.nozzle_peak == shared.nozzle_peak);
    CHECK(alone.exit_peak == shared.exit_peak);
    CHECK(alone.peak_stress.percentile_95 == shared.peak_stress.percentile_95);
    CHECK(alone.exposure->mean == shared.exposure->mean);
}

TEST_CASE(
    "population: where the nozzle decides a percentile is the stress at the radius that carries that flux") {
    // Newtonian, settled: the flux within r is 2(r/R)² − (r/R)⁴ of the whole, counted up to the outermost
    // cell.
    const NozzleFlow flow = nozzle(0.0);
    const Population all = population(flow, {.cell_radius = cell_radius, .shear_modulus = 1e5});
    const double outermost = 1.0 - cell_radius / radius;
    const auto flux = [](double rho) { return rho * rho * (2.0 - rho * rho); };
    const auto stress_at = [&](double part) {
        const double c = part * flux(outermost);
        const double r = std::sqrt(1.0 - std::sqrt(1.0 - c)) * radius;
        const double shear =
            roscoe_shear({.fluid_stress = flow.stress(r), .shear_rate = 1.0, .shear_modulus = 1e5}).von_mises;
        const double centre = bullet({.pressure_gradient = flow.pressure_gradient(),
                                      .viscosity = 5.0,
                                      .cell_radius = cell_radius,
                                      .shear_modulus = 1e5})
                                  .von_mises;
        // A stiff cell's uniform part is pure shear, along which half of the bullet's stress lies.
        const double u = shear * shear;
        const double l = centre * centre;
        return std::sqrt(u + l * (1.0 - 0.5 * u / (u + l)));
    };
    CHECK(all.peak_stress.percentile_90 == doctest::Approx(stress_at(0.90)).epsilon(1e-3));
    CHECK(!all.exposure.has_value());
    // Nearer to the axis a stiff cell's stress peaks at the exit.
    CHECK(all.share_peaking_at_exit > 0.05);
    CHECK(all.exit_peak.front() > all.nozzle_peak.front());
}

TEST_CASE("population: the shares above the percentiles are what the percentiles say") {
    const NozzleFlow flow = nozzle(0.45);
    const Population first = population(flow, cells());
    PopulationRequest again = cells();
    again.thresholds = {0.0, first.peak_stress.median, first.peak_stress.percentile_95, 1e9};
    const Population p = population(flow, again);
    CHECK(p.share_above[0] == 1.0);
    CHECK(p.share_above[1] == doctest::Approx(0.5).epsilon(1e-9));
    CHECK(p.share_above[2] == doctest::Approx(0.05).epsilon(1e-8));
    CHECK(p.share_above[3] == 0.0);
    CHECK(p.peak_stress.median < p.peak_stress.percentile_90);
    CHECK(p.peak_stress.percentile_99 <= p.peak_stress.largest);
    CHECK(p.radius.size() >= 16);  // those asked for and some where the place of the peak changes
}

TEST_CASE("population: a cell that fills the nozzle and too few streamlines are refused") {
    const NozzleFlow flow = nozzle(0.45);
    CHECK_THROWS_AS(population(flow, {.cell_radius = radius, .shear_modulus = 1000.0}), UsageError);
    CHECK_THROWS_AS(population(flow, {.cell_radius = cell_radius, .shear_modulus = 1000.0, .nodes = 3}),
                    UsageError);
    CHECK_THROWS_AS(population(flow, {.cell_radius = cell_radius, .shear_modulus = -1.0}), UsageError);
}
