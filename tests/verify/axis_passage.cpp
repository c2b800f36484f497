#include "bioprint/cell/axis_passage.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/cell/roscoe.hpp"
#include "bioprint/cell/shape_integrals.hpp"
#include "bioprint/cell/transient.hpp"
#include "bioprint/errors.hpp"
#include "cell/spheroid.hpp"

namespace {

using namespace bioprint;

constexpr CrossInk newtonian{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.0};  // 5 Pa s
constexpr CrossInk thinning{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.6};
constexpr AxisEffects none{.volume_average = false, .quadratic_flow = false, .disturbed_viscosity = false};

}  // namespace

TEST_CASE("spheroid integral: the closed form agrees with the general integrals from discs to needles") {
    for (double x = -6.0; x <= 6.0; x += 0.05) {
        const double across = std::exp(-x);
        const ShapeIntegrals g = shape_integrals({std::exp(2.0 * x), across, across});
        CHECK(spheroid_integral(x) == doctest::Approx(g.second[1]).epsilon(2e-14));
    }
    CHECK(spheroid_integral(0.0) == doctest::Approx(4.0 / 15.0).epsilon(1e-15));
    CHECK(std::isfinite(spheroid_integral(60.0)));
    CHECK(std::isfinite(spheroid_integral(-60.0)));
}

TEST_CASE("axis passage: in a steady elongation the ellipsoid settles at Roscoe's shape") {
    for (const double rate : {-20.0, 15.0}) {
        const auto flow = [&](double) {
            return AxisFlow{.velocity = 1e-3, .elongation = rate, .axial = 0.0, .radial = 0.0};
        };
        const AxisPassage p = carry_along_axis(flow, newtonian, {.radius = 8e-6, .shear_modulus = 1000.0},
                                               {.from = 0.0, .to = 1e-3, .tolerance = 1e-9}, none);
        const auto steady = roscoe_elongation(
            {.fluid_stress = 5.0 * std::numbers::sqrt3 * std::abs(rate),
             .shear_modulus = 1000.0,
             .direction = rate > 0 ? ElongationDirection::extension : ElongationDirection::compression});
        CHECK(p.end.von_mises == doctest::Approx(steady->von_mises).epsilon(1e-8));
        CHECK(p.end.axial_stretch == doctest::Approx(steady->stretch[0]).epsilon(1e-8));
    }
}

TEST_CASE("axis passage: without the effects of size it is the general transient cell on the same way") {
    // The general model takes the gradient over time: u = 1 mm/s and e(z) a bump of -60/s.
    const double speed = 1e-3;
    const auto rate = [](double z) { return -60.0 * std::exp(-std::pow((z - 1e-4) / 3e-5, 2)); };
    const auto on_axis = [&](double z) {
        return AxisFlow{.velocity = speed, .elongation = rate(z), .axial = 0.0, .radial = 0.0};
    };
    for (const double lambda : {0.0, 1.0, 4.0}) {
        const AxisPassage p = carry_along_axis(
            on_axis, thinning, {.radius = 8e-6, .shear_modulus = 500.0, .viscosity_ratio = lambda},
            {.from = 0.0, .to = 1.2e-4, .tolerance = 1e-9}, none);
        const auto in_time = [&](double t) {
            const double e = rate(speed * t);
            return AmbientFlow{.gradient = {{{e, 0, 0}, {0, -0.5 * e, 0}, {0, 0, -0.5 * e}}},
                               .viscosity = viscosity(thinning, std::numbers::sqrt3 * std::abs(e))};
        };
        const TransientState s = carry_cell(in_time, {.shear_modulus = 500.0, .viscosity_ratio = lambda}, {},
                                            0.0, 0.12, {.tolerance = 1e-9});
        CHECK(p.end.von_mises == doctest::Approx(s.von_mises).epsilon(1e-7));
        CHECK(p.end.axial_stretch == doctest::Approx(s.stretch[2]).epsilon(1e-7));
    }
}

TEST_CASE("axis passage: in a pipe the cell stays the bullet and slips as Faxen says") {
    const double gradient = 8e7;
    const double speed = 0.01;
    const auto pipe = [&](double) {
        return AxisFlow{.velocity = speed, .elongation = 0.0, .axial = 0.0, .radial = -0.25 * gradient};
    };
    const AxisPassage p = carry_along_axis(pipe, newtonian, {.radius = 8e-6, .shear_modulus = 1000.0},
                                           {.from = 0.0, .to = 5e-4});
    const BulletState steady = bullet(
        {.pressure_gradient = gradient, .viscosity = 5.0, .cell_radius = 8e-6, .shear_modulus = 1000.0});
    // Six points over the cell's height: 2e-3 of the average.
    CHECK(p.start.von_mises == doctest::Approx(steady.von_mises).epsilon(2e-3));
    CHECK(p.end.von_mises == doctest::Approx(p.start.von_mises).epsilon(1e-10));
    CHECK(p.end.time == doctest::Approx(5e-4 / (speed + steady.slip)).epsilon(1e-9));
    CHECK(p.end.stress_exposure == doctest::Approx(p.end.time * p.end.von_mises).epsilon(1e-9));
}

TEST_CASE("axis passage: out of the pipe the bullet's shape relaxes with the time of the third harmonic") {
    const auto leaving = [](double z) {
        return AxisFlow{.velocity = 0.01, .elongation = 0.0, .axial = 0.0, .radial = z < 1e-4 ? -2e7 : 0.0};
    };
    for (const double lambda : {0.5, 1.0}) {
        const double tau = (19.0 / 16.0 + lambda) * 5.0 / 1000.0;
        const double fast = (2.0 / 3.0 + lambda) * 5.0 / 1000.0;
        std::vector<AxisCellState> seen;
        carry_along_axis(
            leaving, newtonian, {.radius = 8e-6, .shear_modulus = 1000.0, .viscosity_ratio = lambda},
            {.from = 0.0, .to = 1e-4 + 0.01 * 14 * tau, .tolerance = 1e-9, .observe_every = 0.01 * tau}, {},
            [&](const AxisCellState& s) { seen.push_back(s); });
        const std::size_t n = seen.size();
        REQUIRE(n > 12);
        const double found =
            (seen[n - 1].time - seen[n - 3].time) / std::log(seen[n - 3].von_mises / seen[n - 1].von_mises);
        // The other mode is gone but for e^-14(tau/fast - 1).
        CHECK(fast < tau);
        CHECK(found == doctest::Approx(tau).epsilon(0.02));
    }
}

TEST_CASE("axis passage: the elongation a cell feels is its volume average") {
    // u = u0 + c z³: no elongation at the centre, (3/5) c a² on average; a rigid cell bears 15/2 η of it.
    const double c = -1e12;
    const double a = 8e-6;
    const auto flow = [&](double z) {
        return AxisFlow{
            .velocity = 1e-2 + c * z * z * z, .elongation = 3 * c * z * z, .axial = 3 * c * z, .radial = 0.0};
    };
    const AxisCell rigid{.radius = a, .shear_modulus = 1e8};
    const AxisPassage p =
        carry_along_axis(flow, newtonian, rigid, {.from = -1e-7, .to = 0.0},
                         {.volume_average = true, .quadratic_flow = false, .disturbed_viscosity = true});
    CHECK(p.end.von_mises == doctest::Approx(7.5 * 5.0 * 0.6 * std::abs(c) * a * a).epsilon(1e-3));
}

TEST_CASE("axis passage: a soft cell is stretched sideways by the root of the slowing down and no more") {
    // u from 2 to 1: affine radial stretch √2.
    const auto velocity = [](double z) { return 1.5e-2 - 0.5e-2 * std::tanh(z / 3e-5); };
    const auto flow = [&](double z) {
        const double s = std::tanh(z / 3e-5);
        return AxisFlow{.velocity = velocity(z),
                        .elongation = -0.5e-2 / 3e-5 * (1.0 - s * s),
                        .axial = 0.0,
                        .radial = 0.0};
    };
    for (const CrossInk& ink : {newtonian, thinning}) {
        const AxisPassage p =
            carry_along_axis(flow, ink, {.radius = 8e-6, .shear_modulus = 1e-3},
                             {.from = -2e-4, .to = 2e-4, .tolerance = 1e-8},
                             {.volume_average = false, .quadratic_flow = false, .disturbed_viscosity = true});
        CHECK(p.end.radial_stretch == doctest::Approx(std::sqrt(2.0)).epsilon(1e-4));
        CHECK(p.axial_stretch_min == doctest::Approx(0.5).epsilon(1e-4));
    }
}

TEST_CASE("axis passage: the observer sees the way in even steps and its ends once") {
    const auto flow = [](double) {
        return AxisFlow{.velocity = 1e-3, .elongation = -10.0, .axial = 0.0, .radial = 0.0};
    };
    std::vector<double> seen;
    carry_along_axis(flow, newtonian, {.radius = 8e-6, .shear_modulus = 1000.0},
                     {.from = -1e-4, .to = 1e-4, .observe_every = 3e-5}, {},
                     [&](const AxisCellState& s) { seen.push_back(s.position); });
    REQUIRE(seen.size() == 8);
    for (std::size_t i = 0; i < 7; ++i)
        CHECK(seen[i] == doctest::Approx(-1e-4 + 3e-5 * static_cast<double>(i)));
    CHECK(seen.back() == doctest::Approx(1e-4));
}

TEST_CASE(
    "axis passage: moduli over eighteen decades give numbers and a rigid cell takes the implicit method") {
    const auto flow = [](double z) {
        const double s = std::tanh(z / 2e-5);
        return AxisFlow{.velocity = 1.5e-2 - 0.5e-2 * s,
                        .elongation = -0.5e-2 / 2e-5 * (1.0 - s * s),
                        .axial = 0.5e-2 / 4e-10 * s * (1 - s * s),
                        .radial = -1e7 * (1.0 - s)};
    };
    for (const CrossInk& ink :
         {newtonian, thinning, CrossInk{.eta0 = 10.0, .eta_inf = 0.1, .time_constant = 5.0, .alpha = 1.4}}) {
        for (double modulus = 1e-6; modulus < 1e13; modulus *= 100.0) {
            for (const double lambda : {0.0, 1.0, 100.0}) {
                const AxisPassage p = carry_along_axis(
                    flow, ink, {.radius = 8e-6, .shear_modulus = modulus, .viscosity_ratio = lambda},
                    {.from = -2e-4, .to = 3e-4});
                CHECK(std::isfinite(p.peak.von_mises));
                CHECK(p.peak.von_mises > 0.0);
                CHECK(p.peak.von_mises >= p.start.von_mises);
                CHECK(p.radial_stretch_max <
                      (lambda == 0.0 ? 2.0 : 1.5));  // an empty cell runs ahead of the ink
            }
        }
    }
}

TEST_CASE("axis passage: a way that leads backward and a cell without size are refused") {
    const auto flow = [](double) {
        return AxisFlow{.velocity = 1e-3, .elongation = 0.0, .axial = 0.0, .radial = 0.0};
    };
    CHECK_THROWS_AS(
        carry_along_axis(flow, newtonian, {.radius = 8e-6, .shear_modulus = 1.0}, {.from = 1.0, .to = 0.0}),
        UsageError);
    CHECK_THROWS_AS(
        carry_along_axis(flow, newtonian, {.radius = 0.0, .shear_modulus = 1.0}, {.from = 0.0, .to = 1.0}),
        UsageError);
}
