#include "solid/ring_triangles.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace bioprint::solid;

namespace {

std::vector<RingPoint> disturbed(const RingMesh& mesh, double amplitude, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-amplitude, amplitude);
    auto p = mesh.vertices;
    for (std::size_t v = 0; v < p.size(); ++v) {
        p[v].x += shift(random);
        if (mesh.vertices[v].r > 0.0) {
            p[v].r += shift(random);
        }
    }
    return p;
}

double relative_force_error(const NeoHookean& material) {
    const RingTriangles body(half_disk(1.0, 4));
    auto p = disturbed(body.mesh(), 0.03);
    std::vector<RingForce> force(p.size(), RingForce{.x = 0.0, .r = 0.0});
    body.energy(p, material, force);
    double largest = 0.0;
    double error = 0.0;
    constexpr double step = 1e-6;
    for (std::size_t v = 0; v < p.size(); ++v) {
        for (const bool radial : {false, true}) {
            double& c = radial ? p[v].r : p[v].x;
            const double here = c;
            c = here + step;
            const double up = body.energy(p, material, {});
            c = here - step;
            const double down = body.energy(p, material, {});
            c = here;
            const double exact = radial ? force[v].r : force[v].x;
            error = std::max(error, std::abs(exact + (up - down) / (2.0 * step)));
            largest = std::max(largest, std::abs(exact));
        }
    }
    return error / largest;
}

}  // namespace

TEST_CASE("half disk: it has 3n² triangles and the volume of the sphere") {
    for (const int layers : {1, 2, 3, 4, 8, 13}) {
        const RingTriangles body(half_disk(2.0, layers));
        CHECK(body.mesh().triangles.size() == static_cast<std::size_t>(3 * layers * layers));
        const RingShape s = body.shape(body.mesh().vertices, {.shear_modulus = 1.0});
        CHECK(std::abs(s.volume / (4.0 / 3.0 * std::numbers::pi * 8.0) - 1.0) < 1e-12);
        CHECK(std::abs(s.centre) < 1e-12);
        CHECK(s.smallest_jacobian > 0.999);
    }
}

TEST_CASE("half disk: the true outline is approached with the square of the layers") {
    const double coarse = half_disk(1.0, 4).vertices.back().x + 1.0;
    const double fine = half_disk(1.0, 8).vertices.back().x + 1.0;
    CHECK(std::log2(coarse / fine) > 1.8);
}

TEST_CASE("ring triangles: nodal forces are minus the derivative of the energy") {
    // Central differences with 1e-6 leave 1e-9 of the largest force.
    CHECK(relative_force_error({.shear_modulus = 1.3}) < 5e-9);
    CHECK(relative_force_error({.shear_modulus = 1.3, .bulk_modulus = 24.7}) < 5e-9);
}

TEST_CASE("ring triangles: the undeformed body is free of force and stress") {
    const RingTriangles body(half_disk(1.0, 5));
    std::vector<RingForce> force(body.mesh().vertices.size(), RingForce{.x = 0.0, .r = 0.0});
    CHECK(std::abs(body.energy(body.mesh().vertices, {.shear_modulus = 1.0, .bulk_modulus = 3.0}, force)) <
          1e-13);
    for (const auto& f : force) {
        CHECK(std::abs(f.x) < 1e-13);
        CHECK(std::abs(f.r) < 1e-13);
    }
    CHECK(body.shape(body.mesh().vertices, {.shear_modulus = 1.0}).von_mises < 1e-7);
}

TEST_CASE("ring triangles: the forces along the axis sum to nothing") {
    const RingTriangles body(half_disk(1.0, 6));
    const auto p = disturbed(body.mesh(), 0.02);
    std::vector<RingForce> force(p.size(), RingForce{.x = 0.0, .r = 0.0});
    body.energy(p, {.shear_modulus = 1.0, .bulk_modulus = 10.0}, force);
    double sum = 0.0;
    double size = 0.0;
    for (const auto& f : force) {
        sum += f.x;
        size += std::abs(f.x);
    }
    CHECK(std::abs(sum) < 1e-14 * size);
}

TEST_CASE("ring triangles: uniaxial stretch has the energy and stress of the law") {
    const RingTriangles body(half_disk(1.0, 4));
    constexpr double a = 1.4;
    auto p = body.mesh().vertices;
    for (auto& v : p) {
        v.x *= a;
        v.r /= std::sqrt(a);
    }
    constexpr double mu = 2.5;
    const double volume = 4.0 / 3.0 * std::numbers::pi;
    const double energy = 0.5 * mu * (a * a + 2.0 / a - 3.0) * volume;
    CHECK(body.energy(p, {.shear_modulus = mu, .bulk_modulus = 7.0}, {}) ==
          doctest::Approx(energy).epsilon(1e-12));
    const RingShape s = body.shape(p, {.shear_modulus = mu});
    CHECK(s.von_mises == doctest::Approx(mu * (a * a - 1.0 / a)).epsilon(1e-12));
    CHECK(s.volume == doctest::Approx(volume).epsilon(1e-12));
}

TEST_CASE("ring triangles: an element turned inside out is seen") {
    const RingTriangles body(half_disk(1.0, 3));
    auto p = body.mesh().vertices;
    p[0].x = 3.0;
    CHECK(body.shape(p, {.shear_modulus = 1.0}).smallest_jacobian <= 0.0);
}
