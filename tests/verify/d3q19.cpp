#include "lattice/d3q19.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "bioprint/errors.hpp"

using namespace bioprint;
using d3q19::InstructionSet;

namespace {

template <class Real>
void run(D3q19<Real>& lattice, int cycles) {
    for (int i = 0; i < cycles; ++i) {
        lattice.cycle();
    }
}

/// Runs until the velocity at the node farthest from the wall changes by less than `tolerance` of itself in
/// `every` cycles.
template <class Real>
int run_until_steady(D3q19<Real>& lattice, int row, double tolerance, int every, int most) {
    double before = 0.0;
    for (int cycles = 0; cycles < most; cycles += every) {
        run(lattice, every);
        const double now = lattice.at(0, row).velocity[0];
        if (std::abs(now - before) <= tolerance * std::abs(now)) {
            return cycles + every;
        }
        before = now;
    }
    FAIL("the flow did not become steady");
    return most;
}

/// Relative error of a developed Newtonian tube flow in the discrete L2 norm.
double tube_error(double radius, double nu, bool half) {
    const double force = 1e-3 * nu / (radius * radius);
    const auto exact = [&](double y, double z) {
        return force / (4.0 * nu) * (radius * radius - y * y - z * z);
    };
    D3q19<double> lattice({.nx = 16,
                           .section = tube(radius, half),
                           .viscosity = {.nu0 = nu},
                           .body_force = {force, 0.0, 0.0},
                           .inflow = {}});
    lattice.initialise([&](double, double y, double z) {
        return FlowState{.velocity = {exact(y, z), 0.0, 0.0},
                         .strain_rate = {0.0, 0.0, 0.0, -0.25 * force * y / nu, -0.25 * force * z / nu, 0.0}};
    });
    const Section& s = lattice.section();
    run_until_steady(lattice, lattice.row(s.ny / 2, half ? 0 : s.nz / 2), 1e-9, 20, 20000);
    double error = 0.0;
    double norm = 0.0;
    for (int z = 0; z < s.nz; ++z) {
        for (int y = 0; y < s.ny; ++y) {
            if (const int row = lattice.row(y, z); row >= 0) {
                const double e = exact(s.y_of(y), s.z_of(z));
                const double d = lattice.at(0, row).velocity[0] - e;
                error += d * d;
                norm += e * e;
            }
        }
    }
    return std::sqrt(error / norm);
}

}  // namespace

TEST_CASE("3-D lattice: Couette flow between moving plates is exact for every viscosity") {
    for (const double nu : {0.05, 0.5, 5.0}) {
        D3q19<double> lattice({.nx = 16,
                               .section = plates(8, 4, -0.01, 0.02, Sides::periodic),
                               .viscosity = {.nu0 = nu},
                               .inflow = {}});
        run_until_steady(lattice, lattice.row(7, 1), 1e-13, 200, 20000);
        for (int y = 0; y < 8; ++y) {
            const NodeState state = lattice.at(3, lattice.row(y, 1));
            CHECK(state.velocity[0] == doctest::Approx(-0.01 + 0.03 * (y + 0.5) / 8.0).epsilon(1e-9));
            CHECK(state.strain_rate[3] == doctest::Approx(0.5 * 0.03 / 8.0).epsilon(1e-9));
            CHECK(std::abs(state.velocity[1]) < 1e-14);
            CHECK(std::abs(state.density) < 1e-14);
        }
    }
}

TEST_CASE("3-D lattice: plane Poiseuille flow between half-way walls is exact for every viscosity") {
    for (const double nu : {0.05, 0.5, 5.0}) {
        const double force = 1e-5 * nu;
        D3q19<double> lattice({.nx = 16,
                               .section = plates(10, 2, 0.0, 0.0, Sides::mirrors),
                               .viscosity = {.nu0 = nu},
                               .body_force = {force, 0.0, 0.0},
                               .inflow = {}});
        run_until_steady(lattice, lattice.row(5, 0), 1e-12, 200, 20000);
        for (int y = 0; y < 10; ++y) {
            const double exact = force / (2.0 * nu) * (y + 0.5) * (9.5 - y);
            CHECK(lattice.at(0, lattice.row(y, 0)).velocity[0] == doctest::Approx(exact).epsilon(1e-8));
        }
    }
}

TEST_CASE("3-D lattice: tube flow converges with the second power of the radius") {
    // Radii that are not whole put the wall at every fraction of a link.
    std::printf("radius   error (L2)   order\n");
    double before = 0.0;
    double radius_before = 0.0;
    for (const double radius : {6.3, 12.6, 25.2}) {
        const double error = tube_error(radius, 0.5, true);
        const double order = before > 0.0 ? std::log(before / error) / std::log(radius / radius_before) : 0.0;
        std::printf("%6.1f   %10.3e   %5.2f\n", radius, error, order);
        if (before > 0.0) {
            CHECK(order > 1.8);
        }
        before = error;
        radius_before = radius;
    }
    CHECK(before < 1e-3);
}

TEST_CASE("3-D lattice: the error of tube flow does not depend on the viscosity") {
    const double reference = tube_error(8.0, 0.5, true);
    CHECK(tube_error(8.0, 0.05, true) == doctest::Approx(reference).epsilon(1e-3));
    CHECK(tube_error(8.0, 5.0, true) == doctest::Approx(reference).epsilon(1e-3));
}

TEST_CASE("3-D lattice: half a tube with a mirror gives what the whole tube gives") {
    CHECK(tube_error(7.5, 0.5, true) == doctest::Approx(tube_error(7.5, 0.5, false)).epsilon(1e-6));
}
