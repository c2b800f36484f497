#include "solid/tetra_solid.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

const Elasticity soft = elasticity(1.3, 0.48);

/// A strong deformation, different everywhere.
std::vector<Vector3> deformed(const TetraMesh& mesh) {
    std::vector<Vector3> x = mesh.nodes;
    for (auto& p : x) {
        const Vector3 q = p;
        p[0] = 1.3 * q[0] + 0.4 * q[1] + 0.1 * std::sin(2.0 * q[2]);
        p[1] = 0.8 * q[1] - 0.15 * q[0] * q[2];
        p[2] = 1.05 * q[2] + 0.1 * q[0] * q[0];
    }
    return x;
}

std::vector<Vector3> rotated(std::vector<Vector3> x) {
    const double c = std::cos(0.7);
    const double s = std::sin(0.7);
    for (auto& p : x) {
        const Vector3 q = p;
        p = {c * q[0] - s * q[2] + 3.0, q[1] - 2.0, s * q[0] + c * q[2] + 1.0};
    }
    return x;
}

}  // namespace

TEST_CASE("tetrahedra: nodal forces are the derivative of the energy") {
    const TetraSolid solid(ball_mesh(1.0, 0.33, false), soft, false);
    std::vector<Vector3> x = deformed(solid.mesh());
    std::vector<Vector3> f;
    CHECK(solid.forces(x, f) == 0);
    double largest = 0.0;
    double worst = 0.0;
    const double h = 1e-5;
    for (std::size_t n = 0; n < x.size(); n += 7) {
        for (int i = 0; i < 3; ++i) {
            const double keep = x[n][i];
            x[n][i] = keep + h;
            const double up = solid.energy(x);
            x[n][i] = keep - h;
            const double down = solid.energy(x);
            x[n][i] = keep;
            largest = std::max(largest, std::abs(f[n][i]));
            worst = std::max(worst, std::abs(-(up - down) / (2.0 * h) - f[n][i]));
        }
    }
    // Central differences lose h² to truncation and 1e-16 E/h to rounding: both about 1e-9 here.
    CHECK(worst < 1e-8 * largest);
    CHECK(largest > 0.01);
}

TEST_CASE("tetrahedra: forces turn with the body and its energy and stress stay") {
    const TetraSolid solid(ball_mesh(1.0, 0.33, false), soft, false);
    const std::vector<Vector3> x = deformed(solid.mesh());
    std::vector<Vector3> f;
    std::vector<Vector3> turned;
    solid.forces(x, f);
    solid.forces(rotated(x), turned);
    CHECK(solid.energy(rotated(x)) == doctest::Approx(solid.energy(x)).epsilon(1e-12));
    CHECK(solid.state(rotated(x)).von_mises == doctest::Approx(solid.state(x).von_mises).epsilon(1e-12));
    const double c = std::cos(0.7);
    const double s = std::sin(0.7);
    for (std::size_t n = 0; n < x.size(); n += 5) {
        CHECK(std::abs(turned[n][0] - (c * f[n][0] - s * f[n][2])) < 1e-12);
        CHECK(std::abs(turned[n][1] - f[n][1]) < 1e-12);
    }
}

TEST_CASE("tetrahedra: there is no net force and no net torque") {
    const TetraSolid solid(ball_mesh(1.0, 0.25, false), soft, false);
    const std::vector<Vector3> x = deformed(solid.mesh());
    std::vector<Vector3> f;
    solid.forces(x, f);
    Vector3 force{};
    Vector3 torque{};
    for (std::size_t n = 0; n < x.size(); ++n) {
        for (int i = 0; i < 3; ++i) {
            const int k = (i + 1) % 3;
            const int l = (i + 2) % 3;
            force[i] += f[n][i];
            torque[i] += x[n][k] * f[n][l] - x[n][l] * f[n][k];
        }
    }
    for (int i = 0; i < 3; ++i) {
        CHECK(std::abs(force[i]) < 1e-12);
        CHECK(std::abs(torque[i]) < 1e-12);
    }
}

TEST_CASE("tetrahedra: a ball at rest has no force and no stress and is round") {
    for (const bool half : {false, true}) {
        const TetraSolid solid(ball_mesh(2.0, 0.5, half), soft, half);
        std::vector<Vector3> f;
        solid.forces(solid.mesh().nodes, f);
        for (const auto& force : f) {
            CHECK(std::abs(force[0]) + std::abs(force[1]) + std::abs(force[2]) < 1e-12);
        }
        const SolidState state = solid.state(solid.mesh().nodes);
        CHECK(state.von_mises < 1e-12);
        CHECK(state.volume == doctest::Approx(32.0 / 3.0 * std::numbers::pi).epsilon(1e-12));
        for (const double axis : state.ellipsoid.semi_axes) {
            CHECK(axis == doctest::Approx(2.0).epsilon(0.01));
        }
        CHECK(state.worst_quality > 0.1);
    }
}

TEST_CASE("tetrahedra: uniform stretch and shear give the stress of the law") {
    const TetraSolid solid(ball_mesh(1.0, 0.33, true), soft, true);
    std::vector<Vector3> x = solid.mesh().nodes;
    const double a = 1.4;
    const double b = 1.0 / std::sqrt(a);
    for (auto& p : x) {
        p = {a * p[0], b * p[1], b * p[2]};
    }
    const SolidState state = solid.state(x);
    CHECK(state.von_mises == doctest::Approx(1.3 * (a * a - 1.0 / a)).epsilon(1e-10));
    CHECK(state.volume == doctest::Approx(4.0 / 3.0 * std::numbers::pi).epsilon(1e-10));
    CHECK(state.ellipsoid.semi_axes[0] / state.ellipsoid.semi_axes[1] ==
          doctest::Approx(a / b).epsilon(0.02));
    CHECK(std::abs(state.ellipsoid.inclination) < 0.05);
    std::vector<Vector3> v = x;
    for (auto& p : v) {
        p = {0.3 * p[1], -0.1 * p[0], 0.0};
    }
    const Matrix3 gradient = solid.mean_gradient(x, v);
    CHECK(gradient[0][1] == doctest::Approx(0.3).epsilon(1e-10));
    CHECK(gradient[1][0] == doctest::Approx(-0.1).epsilon(1e-10));
    CHECK(std::abs(gradient[0][0]) < 1e-10);
}

TEST_CASE("tetrahedra: an inverted element is reported and not hidden") {
    const TetraSolid solid(ball_mesh(1.0, 0.33, false), soft, false);
    std::vector<Vector3> x = solid.mesh().nodes;
    for (auto& p : x) {
        p[0] = -p[0];
    }
    std::vector<Vector3> f;
    CHECK(solid.forces(x, f) == static_cast<int>(solid.mesh().elements.size()));
    CHECK(std::isinf(solid.energy(x)));
    CHECK(solid.state(x).smallest_j < 0.0);
}

TEST_CASE("tetrahedra: the ball of the paper has about 9376 elements") {
    const auto count = static_cast<double>(paper_ball_mesh(1.0).elements.size());
    CHECK(std::abs(count / 9376.0 - 1.0) < 0.02);
}

TEST_CASE("tetrahedra: a damaged mesh file is refused with its name") {
    for (const char* text : {"", "tetrahedra 2\n4 1\n", "tetrahedra 1\n4 1\n0 0 0\n1 0 0\n0 1 0\n",
                             "triangles 1\n4 1\n", "tetrahedra 1\n4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 2 4\n",
                             "tetrahedra 1\n4 1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 2 3\n"}) {
        std::istringstream input{text};
        CHECK_THROWS_AS(read_tetra_mesh(input, "a.tet"), DataError);
    }
}

TEST_CASE("tetrahedra: the mesh of a ball has a ball's centre and inertia however coarse it is") {
    for (const bool half : {true, false}) {
        for (const double edge : {0.67, 0.5, 0.33}) {
            CAPTURE(edge);
            const TetraSolid solid(ball_mesh(1.0, edge, half), soft, half);
            const Ellipsoid at_rest = solid.state(solid.mesh().nodes).ellipsoid;
            for (int i = 0; i < 3; ++i) {
                CHECK(at_rest.semi_axes[i] == doctest::Approx(at_rest.semi_axes[0]).epsilon(1e-9));
                CHECK(std::abs(at_rest.centre[i]) < 1e-9);
            }
            // Corners stand out of a ball of the same volume.
            CHECK(at_rest.semi_axes[0] == doctest::Approx(1.0).epsilon(1e-3));
        }
    }
}
