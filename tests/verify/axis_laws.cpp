#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "bioprint/cell/axis_passage.hpp"
#include "cell/disturbed_viscosity.hpp"

using namespace bioprint;

namespace {

constexpr AxisCell cell{.radius = 8e-6, .shear_modulus = 1000.0};

/// The axis of an exit: 8 mm/s falling to 5 mm/s over some 50 µm, with the nozzle's pressure gradient before it.
AxisFlow exit_flow(double z) {
    constexpr double length = 25e-6;
    constexpr double fall = 1.5e-3;
    const double t = std::tanh(z / length);
    const double slope = -fall / length * (1.0 - t * t);
    return {.velocity = 6.5e-3 - fall * t,
            .elongation = slope,
            .axial = -slope * t / length,
            .radial = -0.25 * 1.7e7 * 0.5 * (1.0 - t)};
}

AxisPassage pass(const Ink& ink, const AxisEffects& effects = {}) {
    const auto flow = [](double z) { return exit_flow(z); };
    return carry_along_axis(flow, ink, cell, {.from = -200e-6, .to = 375e-6}, effects);
}

}  // namespace

TEST_CASE(
    "axis passage: a Carreau-Yasuda ink whose transition is 1 minus n squeezes the cell as the Cross ink") {
    for (const double eta_inf : {0.0, 0.1}) {
        const CrossInk cross{.eta0 = 10.0, .eta_inf = eta_inf, .time_constant = 0.05, .alpha = 0.6};
        const CarreauYasudaInk same{
            .eta0 = 10.0, .eta_inf = eta_inf, .time_constant = 0.05, .transition = 0.6, .flow_index = 0.4};
        const DisturbedViscosity a(cross, 0.0);
        const Ink kept = same;
        const DisturbedViscosity b(kept, 0.0);
        for (const double e : {-1000.0, -3.0, 0.1}) {
            for (const double d : {-50.0, 2.0, 1e4})
                CHECK(b(e, d) == doctest::Approx(a(e, d)).epsilon(1e-12));
        }
        const AxisPassage one = pass(cross);
        const AxisPassage other = pass(same);
        CHECK(other.peak.von_mises == doctest::Approx(one.peak.von_mises).epsilon(1e-9));
        CHECK(other.peak.axial_stretch == doctest::Approx(one.peak.axial_stretch).epsilon(1e-9));
    }
}

TEST_CASE("axis passage: a power-law ink of index 1 squeezes the cell as the Newtonian ink") {
    const AxisPassage one = pass(CrossInk{.eta0 = 4.0, .time_constant = 1.0, .alpha = 0.0});
    const AxisPassage other = pass(PowerLawInk{.consistency = 2.0, .flow_index = 1.0});
    CHECK(other.peak.von_mises == doctest::Approx(one.peak.von_mises).epsilon(1e-9));
    const AxisPassage plastic =
        pass(HerschelBulkleyInk{.yield_stress = 0.0, .consistency = 2.0, .flow_index = 1.0});
    CHECK(plastic.peak.von_mises == doctest::Approx(one.peak.von_mises).epsilon(1e-9));
}

TEST_CASE("axis passage: a power-law ink is the limit of inks whose plateau recedes") {
    // The plateau of K is felt below 1/K: a tenth of the rates along the way leaves a few per cent, a thousandth less.
    const double n = 0.5;
    const AxisPassage limit = pass(PowerLawInk{.consistency = 10.0, .flow_index = n});
    constexpr double settled = 5e-3;  // there the plateau is no longer what tells the two apart
    double before = 1.0;
    for (const double time_constant : {1.0, 100.0, 1e4}) {
        const CarreauYasudaInk ink{.eta0 = 10.0 * std::pow(time_constant, 1.0 - n),
                                   .time_constant = time_constant,
                                   .transition = 2.0,
                                   .flow_index = n};
        const double off = std::abs(pass(ink).peak.von_mises / limit.peak.von_mises - 1.0);
        MESSAGE("K " << time_constant << " s: " << off);
        CHECK(off < std::max(before, settled));
        before = off;
    }
    CHECK(before < 0.02);
}

TEST_CASE("axis passage: an ink with a yield stress loads the cell more than without and stays finite") {
    const AxisPassage without = pass(PowerLawInk{.consistency = 8.0, .flow_index = 0.4});
    double last = without.peak.von_mises;
    for (const double yield : {1.0, 10.0, 60.0}) {
        const AxisPassage with =
            pass(HerschelBulkleyInk{.yield_stress = yield, .consistency = 8.0, .flow_index = 0.4});
        CHECK(std::isfinite(with.end.von_mises));
        CHECK(with.peak.von_mises > last);
        last = with.peak.von_mises;
    }
}
