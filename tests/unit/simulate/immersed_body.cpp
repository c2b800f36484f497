#include "simulate/immersed_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

std::vector<Vector3> noise(std::size_t count, double size) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> value(-size, size);
    std::vector<Vector3> result(count);
    for (auto& v : result) {
        v = {value(generator), value(generator), value(generator)};
    }
    return result;
}

double dot(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i][0] * b[i][0] + a[i][1] * b[i][1] + a[i][2] * b[i][2];
    }
    return sum;
}

D3q19<double> sheared_box() {
    D3q19<double> lattice(
        {.nx = 32, .section = plates(24, 10, -0.012, 0.012, Sides::mirrors), .viscosity = {.nu0 = 0.5}});
    lattice.initialise([](double, double y, double) {
        return FlowState{.velocity = {1e-3 * y, 0.0, 0.0}, .strain_rate = {0.0, 0.0, 0.0, 5e-4, 0.0, 0.0}};
    });
    return lattice;
}

/// A body out of its rest shape, symmetric about the mirror plane.
std::vector<Vector3> stretched(std::vector<Vector3> x) {
    for (auto& p : x) {
        p = {1.2 * p[0] + 0.3 * p[1], 0.9 * p[1], 0.95 * p[2]};
    }
    return x;
}

}  // namespace

TEST_CASE("points in tetrahedra: spreading and gathering are adjoint") {
    const TetraMesh mesh = ball_mesh(4.0, 1.6, true);
    TetraPoints points(mesh, true);
    std::vector<Vector3> forces = noise(mesh.nodes.size(), 1.0);
    for (std::size_t n = 0; n < forces.size(); ++n) {
        forces[n][2] = mesh.nodes[n][2] == 0.0 ? 0.0 : forces[n][2];
    }
    const std::vector<Vector3> velocities = noise(points.size(), 1.0);
    std::vector<Vector3> spread;
    std::vector<Vector3> gathered;
    points.spread(forces, spread);
    points.gather(velocities, gathered);
    CHECK(dot(spread, velocities) == doctest::Approx(dot(forces, gathered)).epsilon(1e-11));
}

TEST_CASE(
    "points in tetrahedra: a velocity linear in space is gathered exactly and the total force is kept") {
    const TetraMesh mesh = ball_mesh(4.0, 1.6, false);
    TetraPoints points(mesh, false);
    std::vector<Vector3> places;
    points.place(mesh.nodes, places);
    std::vector<Vector3> velocities = places;
    for (auto& v : velocities) {
        v = {0.1 + 0.2 * v[1] - 0.3 * v[2], 0.5 * v[0], 1.0 - 0.1 * v[2]};
    }
    std::vector<Vector3> gathered;
    points.gather(velocities, gathered);
    double worst = 0.0;
    for (std::size_t n = 0; n < gathered.size(); ++n) {
        const Vector3& x = mesh.nodes[n];
        worst =
            std::max({worst, std::abs(gathered[n][0] - (0.1 + 0.2 * x[1] - 0.3 * x[2])),
                      std::abs(gathered[n][1] - 0.5 * x[0]), std::abs(gathered[n][2] - (1.0 - 0.1 * x[2]))});
    }
    CHECK(worst < 1e-11);
    const std::vector<Vector3> forces = noise(mesh.nodes.size(), 1.0);
    std::vector<Vector3> spread;
    points.spread(forces, spread);
    const std::vector<Vector3> along_x(spread.size(), {1.0, 0.0, 0.0});
    const std::vector<Vector3> along_x_nodes(forces.size(), {1.0, 0.0, 0.0});
    CHECK(dot(spread, along_x) == doctest::Approx(dot(forces, along_x_nodes)).epsilon(1e-10));
}

TEST_CASE("immersed body: the power put into the fluid is the power of the nodal forces") {
    for (const bool inside : {false, true}) {
        D3q19<double> lattice = sheared_box();
        ImmersedBody<double> body(
            {.radius = 5.0, .inside = inside, .shear_modulus = 0.01, .volume_strength = 0.0}, lattice,
            {15.3, 0.2, 0.0});
        std::vector<Vector3> x = stretched(body.solid().mesh().nodes);
        for (auto& p : x) {
            p[0] += 30.2;  // across the periodic face
        }
        body.set_positions(x);
        std::vector<Vector3> forces;
        body.solid().forces(x, forces);
        body.load();
        lattice.step();
        body.move();
        double power = 0.0;
        double total = 0.0;
        for (int row = 0; row < lattice.rows(); ++row) {
            for (int node = 0; node < lattice.nx(); ++node) {
                for (int axis = 0; axis < 3; ++axis) {
                    power += lattice.force(axis, row)[node] * lattice.velocity(axis, row)[node];
                }
                total += lattice.force(0, row)[node];
            }
        }
        std::vector<Vector3> velocities = body.velocities();
        for (std::size_t n = 0; n < velocities.size(); ++n) {
            // In the mirror plane the two halves' forces across it cancel.
            velocities[n][2] = body.solid().mesh().nodes[n][2] == 0.0 ? 0.0 : velocities[n][2];
        }
        CHECK(power == doctest::Approx(dot(forces, velocities)).epsilon(1e-9));
        CHECK(std::abs(total) < 1e-12);
        CHECK(std::abs(power) > 1e-9);
    }
}

TEST_CASE("immersed body: a body that leaves the fluid or turns inside out ends the run") {
    D3q19<double> lattice = sheared_box();
    ImmersedBody<double> near_wall({.radius = 5.0, .shear_modulus = 0.01}, lattice, {16.0, 8.0, 0.0});
    CHECK_THROWS_AS(near_wall.load(), NotConverged);
    ImmersedBody<double> inverted({.radius = 5.0, .shear_modulus = 0.01}, lattice, {16.0, 0.0, 0.0});
    std::vector<Vector3> x = inverted.positions();
    for (auto& p : x) {
        p[0] = -p[0];
    }
    inverted.set_positions(x);
    CHECK_THROWS_AS(inverted.load(), NotConverged);
}
