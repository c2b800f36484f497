#include "predict/exit_field.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <tuple>

namespace {

using namespace bioprint;

constexpr double radius = 50e-6;

NozzleFlow nozzle(double alpha) {
    return NozzleFlow::from_velocity(CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}, radius,
                                     5e-3);
}

}  // namespace

TEST_CASE("exit field: far upstream it is the nozzle's flow and far downstream the plug") {
    const NozzleFlow flow = nozzle(0.5);
    const ExitField field(flow);
    for (double r = 0.05 * radius; r < 0.95 * radius; r += 0.1 * radius) {
        const auto up = field.at(-8.0 * radius, r);
        CHECK(up.axial_velocity == doctest::Approx(flow.velocity(r)).epsilon(2e-3));
        CHECK(up.gradient[0][1] == doctest::Approx(-flow.shear_rate(r)).epsilon(3e-3).scale(1.0));
        CHECK(up.rate == doctest::Approx(flow.shear_rate(r)).epsilon(3e-3).scale(1.0));
        const auto down = field.at(8.0 * radius, r);
        CHECK(down.axial_velocity == doctest::Approx(flow.velocity_average()).epsilon(1e-6));
        CHECK(std::abs(down.radial_velocity) < 1e-8);
    }
}

TEST_CASE("exit field: its gradient is that of its velocity and its divergence is zero") {
    const ExitField field(nozzle(0.5));
    const double h = 1e-9;
    for (const double x : {-0.7, -0.1, 0.06, 0.8}) {
        for (const double r : {0.12, 0.4, 0.77}) {
            const auto p = field.at(x * radius, r * radius);
            const auto a = field.at(x * radius + h, r * radius);
            const auto b = field.at(x * radius - h, r * radius);
            const auto c = field.at(x * radius, r * radius + h);
            const auto d = field.at(x * radius, r * radius - h);
            CHECK(p.gradient[0][0] ==
                  doctest::Approx((a.axial_velocity - b.axial_velocity) / (2 * h)).epsilon(1e-5).scale(1.0));
            CHECK(p.gradient[0][1] ==
                  doctest::Approx((c.axial_velocity - d.axial_velocity) / (2 * h)).epsilon(1e-5).scale(1.0));
            CHECK(
                p.gradient[1][0] ==
                doctest::Approx((a.radial_velocity - b.radial_velocity) / (2 * h)).epsilon(1e-5).scale(1.0));
            CHECK(
                p.gradient[1][1] ==
                doctest::Approx((c.radial_velocity - d.radial_velocity) / (2 * h)).epsilon(1e-5).scale(1.0));
            CHECK(p.gradient[2][2] == doctest::Approx(p.radial_velocity / (r * radius)));
        }
    }
}

TEST_CASE("exit field: the velocity on the axis is that of the profile it is built on") {
    const NozzleFlow flow = nozzle(0.75);
    const ExitField field(flow);
    const ExitAxis axis(flow);
    for (double x = -3.0; x < 3.0; x += 0.25) {
        const auto p = field.at(x * radius, 0.0);
        const AxisFlow f = axis(x * radius);
        CHECK(p.axial_velocity == doctest::Approx(f.velocity).epsilon(1e-8));
        CHECK(p.gradient[0][0] == doctest::Approx(f.elongation).epsilon(1e-5).scale(1.0));
        CHECK(p.shear_share < 1e-4);  // a millionth of the radius aside, where the elongation is faint
    }
}

TEST_CASE("exit field: the largest radial velocity is within five per cent of the finite-element one") {
    for (const auto& [alpha, largest, bound] :
         {std::tuple{0.0, 1.1058e-3, 0.02}, std::tuple{0.3, 1.1182e-3, 0.02},
          std::tuple{0.75, 0.9706e-3, 0.05}}) {
        const ExitField field(nozzle(alpha));
        double found = 0.0;
        for (double x = -1.0; x < 1.0; x += 0.02) {
            for (double r = 0.3; r < 0.98; r += 0.02) {
                found = std::fmax(found, field.at(x * radius, r * radius).radial_velocity);
            }
        }
        CAPTURE(alpha);
        CHECK(std::abs(found / largest - 1.0) < bound);
    }
}

TEST_CASE("exit field: a streamline ends where the plug carries the flux it started with") {
    const NozzleFlow flow = nozzle(0.3);
    const ExitField field(flow);
    for (const double start : {0.0, 0.01, 0.2, 0.5, 0.84}) {
        const double end = field.streamline(start * radius, 8.0 * radius);
        CHECK(0.5 * flow.velocity_average() * end * end ==
              doctest::Approx(field.nozzle_flux(start * radius)).epsilon(1e-6));
        CHECK(field.streamline(start * radius, -8.0 * radius) ==
              doctest::Approx(start * radius).epsilon(1e-3));
        CHECK(end >= start * radius);
    }
}
