#include "lattice/d3q19.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_flow.hpp"

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

/// Relative L2 error of developed flow of an ink, driven by its exact pressure gradient.
double ink_error(double alpha, double radius) {
    const double dx = 50e-6 / radius;
    const NozzleFlow flow = NozzleFlow::from_velocity(
        CrossInk{.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = alpha}, 50e-6, 5e-3);
    const double dt = 0.02 * dx / 5e-3;
    const double nu0 = 10.0;
    D3q19<double> lattice({.nx = 16,
                           .section = tube(radius, true),
                           .viscosity = {.nu0 = nu0, .time_constant = 0.05 / dt, .alpha = alpha},
                           .body_force = {flow.pressure_gradient() * dx * nu0 * dt / 10.0, 0.0, 0.0},
                           .inflow = {}});
    lattice.initialise([&](double, double y, double z) {
        const double r = std::hypot(y, z);
        const double slope = -0.5 * flow.shear_rate(r * dx) * dt / r;
        return FlowState{.velocity = {flow.velocity(r * dx) * dt / dx, 0.0, 0.0},
                         .strain_rate = {0.0, 0.0, 0.0, slope * y, slope * z, 0.0}};
    });
    const Section& s = lattice.section();
    run_until_steady(lattice, lattice.row(s.ny / 2, 0), 1e-7, 50, 20000);
    double error = 0.0;
    double norm = 0.0;
    for (int row = 0, z = 0; z < s.nz; ++z) {
        for (int y = 0; y < s.ny; ++y) {
            if (s.is_fluid(y, z)) {
                const double exact = flow.velocity(std::hypot(s.y_of(y), s.z_of(z)) * dx) * dt / dx;
                const double difference = lattice.at(0, row++).velocity[0] - exact;
                error += difference * difference;
                norm += exact * exact;
            }
        }
    }
    return std::sqrt(error / norm);
}

/// A tube with everything in it, in some setting, as bytes.
template <class Real>
std::vector<double> fingerprint(int threads, InstructionSet instructions) {
    const double radius = 9.3;
    D3q19<Real> lattice(
        {.nx = 48,
         .section = tube(radius, true),
         .viscosity = {.nu0 = 0.7, .nu_inf = 0.01, .time_constant = 500.0, .alpha = 0.75},
         .body_force = {1e-6, 2e-6, 0.0},
         .ends = Ends::inflow_outflow,
         .inflow = [=](double y, double z) { return 0.01 * (1.0 - (y * y + z * z) / (radius * radius)); },
         .slip_begin = 20,
         .slip_end = 48,
         .threads = threads,
         .instructions = instructions});
    run(lattice, 40);
    std::vector<double> values;
    for (int row = 0; row < lattice.rows(); ++row) {
        for (int x = 0; x < lattice.nx(); ++x) {
            const NodeState state = lattice.at(x, row);
            values.insert(values.end(),
                          {state.density, state.velocity[0], state.velocity[1], state.viscosity});
        }
    }
    return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0.0;
    double size = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
        size = std::max(size, std::abs(a[i]));
    }
    return worst / size;
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

TEST_CASE("3-D lattice: shear-thinning tube flow converges with the second power of the radius") {
    std::printf("alpha  radius   error (L2)   order\n");
    for (const double alpha : {0.3, 0.75}) {
        double before = 0.0;
        double radius_before = 0.0;
        for (const double radius : {6.3, 12.6, 25.2}) {
            const double error = ink_error(alpha, radius);
            const double order = std::log(before / error) / std::log(radius / radius_before);
            std::printf("%5.2f  %6.1f  %15.2e  %6.2f\n", alpha, radius, error, before == 0.0 ? 0.0 : order);
            if (before != 0.0) {
                CHECK(order > 1.8);
            }
            before = error;
            radius_before = radius;
        }
        CHECK(std::abs(before) < 4e-3);
    }
}

TEST_CASE("3-D lattice: the number of threads does not change a bit") {
    const auto one = fingerprint<float>(1, InstructionSet::best);
    CHECK(one == fingerprint<float>(2, InstructionSet::best));
    CHECK(one == fingerprint<float>(5, InstructionSet::best));
}

TEST_CASE("3-D lattice: every instruction set gives the same flow up to rounding") {
    const auto in_float = fingerprint<float>(1, InstructionSet::baseline);
    const auto in_double = fingerprint<double>(1, InstructionSet::baseline);
    CHECK(largest_difference(in_float, in_double) < 1e-4);
    for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
        if (d3q19::kernels<float>(set) != nullptr) {
            CHECK(largest_difference(in_float, fingerprint<float>(1, set)) < 1e-5);
            CHECK(largest_difference(in_double, fingerprint<double>(1, set)) < 1e-12);
        }
    }
}

TEST_CASE("3-D lattice: a free-slip cylinder leaves a rigid rotation and a plug flow alone") {
    D3q19<double> lattice(
        {.nx = 16, .section = tube(10.0, false), .inflow = {}, .slip_begin = 0, .slip_end = 16});
    const double spin = 1e-4;
    lattice.initialise([&](double, double y, double z) {
        return FlowState{.velocity = {2e-3, -spin * z, spin * y}};
    });
    run(lattice, 300);
    double worst = 0.0;
    for (int z = 0; z < 20; ++z) {
        for (int y = 0; y < 20; ++y) {
            if (const int row = lattice.row(y, z); row >= 0) {
                const NodeState state = lattice.at(5, row);
                worst = std::max(
                    {worst, std::abs(state.velocity[0] - 2e-3) / 2e-3,
                     std::abs(state.velocity[1] + spin * lattice.section().z_of(z)) / (10.0 * spin)});
            }
        }
    }
    CHECK(worst < 1e-3);
}

TEST_CASE("3-D lattice: a setup that cannot run is refused") {
    CHECK_THROWS_AS(D3q19<float>({.nx = 20, .section = tube(5.0, true), .inflow = {}}), UsageError);
    CHECK_THROWS_AS(
        D3q19<float>({.nx = 16, .section = tube(5.0, true), .viscosity = {.nu0 = -1.0}, .inflow = {}}),
        UsageError);
    CHECK_THROWS_AS(
        D3q19<float>({.nx = 16, .section = tube(5.0, true), .ends = Ends::inflow_outflow, .inflow = {}}),
        UsageError);
    CHECK_THROWS_AS(
        D3q19<float>(
            {.nx = 16, .section = plates(8, 8, 0, 0, Sides::periodic), .inflow = {}, .slip_end = 16}),
        UsageError);
    CHECK_THROWS_AS(tube(1.0, true), UsageError);
}
