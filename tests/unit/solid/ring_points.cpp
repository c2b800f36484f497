#include "solid/ring_points.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "solid/volume_relaxation.hpp"

using namespace bioprint::solid;

TEST_CASE("ring points: spreading and gathering are adjoint") {
    const RingMesh mesh = half_disk(1.0, 4);
    RingPoints points(mesh);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<RingForce> force(mesh.vertices.size());
    std::vector<RingPoint> velocity(points.size());
    for (auto& f : force) {
        f = {.x = normal(random), .r = normal(random)};
    }
    for (auto& u : velocity) {
        u = {.x = normal(random), .r = normal(random)};
    }
    std::vector<RingForce> spread(points.size());
    std::vector<RingPoint> gathered(mesh.vertices.size());
    points.spread(force, spread);
    points.gather(velocity, gathered);
    double at_points = 0.0;
    double at_vertices = 0.0;
    for (std::size_t q = 0; q < points.size(); ++q) {
        at_points += spread[q].x * velocity[q].x + spread[q].r * velocity[q].r;
    }
    for (std::size_t v = 0; v < force.size(); ++v) {
        at_vertices += force[v].x * gathered[v].x + force[v].r * gathered[v].r;
    }
    CHECK(at_points == doctest::Approx(at_vertices).epsilon(1e-12));
}

TEST_CASE("ring points: a velocity linear in space is gathered exactly") {
    const RingMesh mesh = half_disk(1.0, 5);
    RingPoints points(mesh);
    std::vector<RingPoint> place(points.size());
    points.place(mesh.vertices, place);
    std::vector<RingPoint> velocity;
    for (const auto& p : place) {
        velocity.push_back({.x = 0.3 - 2.0 * p.x, .r = 1.0 * p.r});
    }
    std::vector<RingPoint> gathered(mesh.vertices.size());
    points.gather(velocity, gathered);
    for (std::size_t v = 0; v < gathered.size(); ++v) {
        CHECK(std::abs(gathered[v].x - (0.3 - 2.0 * mesh.vertices[v].x)) < 1e-12);
        CHECK(std::abs(gathered[v].r - mesh.vertices[v].r) < 1e-12);
    }
}

TEST_CASE("ring points: the net force and its first moment are kept") {
    const RingMesh mesh = half_disk(1.0, 4);
    RingPoints points(mesh);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::vector<RingForce> force(mesh.vertices.size());
    double net = 0.0;
    double moment = 0.0;
    for (std::size_t v = 0; v < force.size(); ++v) {
        force[v] = {.x = normal(random), .r = 0.0};
        net += force[v].x;
        moment += force[v].x * mesh.vertices[v].x;
    }
    std::vector<RingForce> spread(points.size());
    std::vector<RingPoint> place(points.size());
    points.spread(force, spread);
    points.place(mesh.vertices, place);
    for (std::size_t q = 0; q < spread.size(); ++q) {
        net -= spread[q].x;
        moment -= spread[q].x * place[q].x;
    }
    CHECK(std::abs(net) < 1e-12);
    CHECK(std::abs(moment) < 1e-12);
}

TEST_CASE("volume relaxation: a blown-up body shrinks back to its volume and a true one stays") {
    const RingTriangles body(half_disk(1.0, 4));
    VolumeRelaxation relaxation(body.mesh());
    auto p = body.mesh().vertices;
    relaxation.apply(p, 0.05);
    for (std::size_t v = 0; v < p.size(); ++v) {
        CHECK(std::abs(p[v].x - body.mesh().vertices[v].x) < 1e-14);
        CHECK(std::abs(p[v].r - body.mesh().vertices[v].r) < 1e-14);
    }
    for (auto& v : p) {
        v.x *= 1.03;
        v.r *= 1.03;
    }
    const double rest = body.shape(body.mesh().vertices, {.shear_modulus = 1.0}).volume;
    double before = body.shape(p, {.shear_modulus = 1.0}).volume;
    for (int n = 0; n < 2000; ++n) {
        relaxation.apply(p, 0.05);
        const double now = body.shape(p, {.shear_modulus = 1.0}).volume;
        CHECK(now <= before * (1.0 + 1e-12));
        before = now;
    }
    CHECK(std::abs(before / rest - 1.0) < 1e-6);
}
