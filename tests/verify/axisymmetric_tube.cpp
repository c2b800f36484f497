#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/flow/nozzle_flow.hpp"
#include "lattice/axisymmetric.hpp"
#include "simulate/lattice_units.hpp"

using namespace bioprint;

namespace {

struct TubeError {
    double axis;     ///< of the largest velocity
    double largest;  ///< over the profile, relative to the largest velocity
};

TubeError tube(double alpha, int nodes, double eta_inf = 0.0) {
    const CrossInk ink{.eta0 = 10.0, .eta_inf = eta_inf, .time_constant = 0.05, .alpha = alpha};
    const NozzleFlow exact = NozzleFlow::from_velocity(ink, 50e-6, 5e-3);
    const LatticeUnits units = units_for_flow(exact, nodes);
    const LatticeProfile profile = lattice_profile(exact, units);
    lattice::AxisymmetricFlow flow(
        {.length = 16, .radius = nodes, .lip = 16, .periodic = true, .body_force = profile.pressure_gradient},
        units.relaxation(ink));
    auto start = profile.velocity;
    for (double& u : start) {
        u *= 0.9;
    }
    flow.start(start, profile.slope, 0.0);
    REQUIRE(flow.run_to_steady(1e-8, 1000000));
    const auto f = flow.measure();
    const double axis = (9.0 * f.velocity_x[f.at(0, 0)] - f.velocity_x[f.at(0, 1)]) / 8.0;
    TubeError error{.axis = std::abs(axis * units.velocity / exact.velocity_max() - 1.0), .largest = 0.0};
    for (int j = 0; j < nodes; ++j) {
        const double u = f.velocity_x[f.at(5, j)] * units.velocity;
        error.largest = std::max(error.largest, std::abs(u - exact.velocity((j + 0.5) * units.spacing)));
    }
    error.largest /= exact.velocity_max();
    return error;
}

}  // namespace

TEST_CASE("tube: a Newtonian ink flows exactly on any lattice") {
    for (const int nodes : {12, 19, 38}) {
        CHECK(tube(0.0, nodes).largest < 1e-8);  // what the steadiness criterion leaves
    }
}

TEST_CASE("tube: the profile of a thinning ink converges with second order") {
    for (const double alpha : {0.3, 0.75}) {
        const double coarse = tube(alpha, 19).largest;
        const double middle = tube(alpha, 38).largest;
        const double fine = tube(alpha, 57).largest;
        MESSAGE("alpha " << alpha << ": " << coarse << " " << middle << " " << fine);
        CHECK(std::log2(coarse / middle) > 1.9);
        CHECK(std::log(middle / fine) / std::log(1.5) > 1.9);
    }
}

TEST_CASE("tube: the largest velocity is right to 4e-4 at 38 nodes for every ink up to 0.75") {
    for (const double alpha : {0.0, 0.15, 0.3, 0.45, 0.6, 0.75}) {
        CHECK(tube(alpha, 38).axis < 4e-4);
    }
}

TEST_CASE("tube: a finite viscosity at high rates is met") {
    CHECK(tube(0.75, 38, 0.2).axis < 4e-4);
}
