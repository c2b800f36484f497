#include "cell/planar_cell.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/cell/shape_integrals.hpp"
#include "bioprint/cell/transient.hpp"

namespace {

using namespace bioprint;

/// The brief shape integrals' error, times what a history of some strain units makes of it.
constexpr double same_cell = 2e-7;

PlanarFlow history(double t) {
    const double xx = -0.9 * std::sin(2.0 * t);
    const double tt = 0.3 * std::sin(2.0 * t) + 0.2 * std::cos(t);
    return {.xx = xx,
            .xr = -2.0 + t,
            .rx = 0.7 * std::cos(3.0 * t),
            .rr = -xx - tt,
            .tt = tt,
            .viscosity = 1.0 + 0.5 * std::sin(t)};
}

AmbientFlow general(const PlanarFlow& f) {
    return {.gradient = {{{f.xx, f.xr, 0.0}, {f.rx, f.rr, 0.0}, {0.0, 0.0, f.tt}}}, .viscosity = f.viscosity};
}

PlanarState carried(const PlanarCell& cell, double to) {
    return dormand_prince<3>([&](double t, const PlanarState& y) { return cell.derivative(history(t), y); },
                             0.0, to, PlanarState{}, {1.0, 1.0, 1.0}, {.tolerance = 1e-10},
                             [](const OdeStep<3>&) { return true; })
        .y;
}

}  // namespace

TEST_CASE("planar cell: a history with a plane of symmetry gives what the general cell gives") {
    for (const double lambda : {0.0, 0.4, 1.0, 3.0, 20.0}) {
        for (const double modulus : {0.1, 1.0, 30.0}) {
            CAPTURE(lambda);
            CAPTURE(modulus);
            const PlanarStrain planar =
                planar_strain(carried({.shear_modulus = modulus, .viscosity_ratio = lambda}, 2.5));
            const TransientState full = carry_cell([](double t) { return general(history(t)); },
                                                   {.shear_modulus = modulus, .viscosity_ratio = lambda}, {},
                                                   0.0, 2.5, {.tolerance = 1e-10});
            const Tensor b = strain_of(full.deformation);
            const double size = std::abs(b[0][0]) + std::abs(b[0][1]) + std::abs(b[2][2]);
            CHECK(std::abs(planar.xx - b[0][0]) < same_cell * size);
            CHECK(std::abs(planar.xr - b[0][1]) < same_cell * size);
            CHECK(std::abs(planar.rr - b[1][1]) < same_cell * size);
            CHECK(std::abs(planar.tt - b[2][2]) < same_cell * size);
            const PlanarShape shape = planar_shape(planar);
            CHECK(modulus * shape.von_mises == doctest::Approx(full.von_mises).epsilon(1e-6));
            CHECK(modulus * planar_stress(planar).von_mises == doctest::Approx(full.von_mises).epsilon(1e-6));
            CHECK(shape.stretch[0] * shape.stretch[1] * shape.stretch[2] ==
                  doctest::Approx(1.0).epsilon(1e-12));
            CHECK(std::abs(shape.angle) <= 0.25 * 3.1415927);
        }
    }
}

TEST_CASE(
    "planar cell: in a shear that falls with r it settles at the stretch and angle and frequency of Roscoe") {
    for (const double lambda : {0.0, 1.0, 5.0}) {
        for (const double ratio : {1e-4, 0.1, 0.8}) {
            CAPTURE(lambda);
            CAPTURE(ratio);
            const PlanarCell cell{.shear_modulus = 1.0 / ratio, .viscosity_ratio = lambda};
            const PlanarFlow shear{.xx = 0.0, .xr = -1.0, .rx = 0.0, .rr = 0.0, .tt = 0.0, .viscosity = 1.0};
            const double time = 40.0 * std::fmax(1.0, (1.5 + lambda) * ratio);
            const auto end =
                dormand_prince<3>([&](double, const PlanarState& y) { return cell.derivative(shear, y); },
                                  0.0, time, PlanarState{}, {ratio, ratio, ratio}, {.tolerance = 1e-9},
                                  [](const OdeStep<3>&) { return true; });
            const EllipsoidState steady = roscoe_shear({.fluid_stress = 1.0,
                                                        .shear_rate = 1.0,
                                                        .shear_modulus = 1.0 / ratio,
                                                        .viscosity_ratio = lambda});
            const PlanarStrain strain = planar_strain(end.y);
            const PlanarShape shape = planar_shape(strain);
            for (std::size_t i = 0; i < 3; ++i)
                CHECK(std::abs(shape.stretch[i] - steady.stretch[i]) < 1e-6 * ratio);
            CHECK(shape.angle == doctest::Approx(*steady.angle).epsilon(1e-5));
            CHECK(shape.von_mises / ratio == doctest::Approx(steady.von_mises).epsilon(1e-6));
            const double inner = cell.inner_shear(shear, strain);
            CHECK(2.0 * lambda * inner == doctest::Approx(steady.viscous).epsilon(1e-5));
            const double a = shape.stretch[0] * shape.stretch[0] - shape.stretch[1] * shape.stretch[1];
            CHECK(2.0 * shape.stretch[0] * shape.stretch[1] / a * inner ==
                  doctest::Approx(*steady.frequency).epsilon(1e-5));
        }
    }
}

TEST_CASE("planar cell: state and strain are each other's inverse from 1e-9 to a tenfold stretch") {
    for (const double size : {1e-9, 1e-3, 0.5, 2.0}) {
        const PlanarState state{size, -0.3 * size, 0.8 * size};
        const PlanarState again = planar_state(planar_strain(state));
        for (std::size_t i = 0; i < 3; ++i) CHECK(again[i] == doctest::Approx(state[i]).epsilon(1e-7));
    }
}

TEST_CASE(
    "planar cell: the axis nearer to the flow comes first and a lean towards the axis counts positive") {
    const PlanarShape squeezed = planar_shape({.xx = -0.3, .xr = 0.0, .rr = 0.2, .tt = 0.2});
    CHECK(squeezed.stretch[0] < squeezed.stretch[1]);
    CHECK(squeezed.angle == 0.0);
    CHECK(squeezed.shear_part == 0.0);
    const PlanarShape leaning = planar_shape({.xx = 0.3, .xr = -0.2, .rr = -0.1, .tt = 0.0});
    CHECK(leaning.stretch[0] > leaning.stretch[1]);
    CHECK(leaning.angle > 0.0);
    CHECK(planar_shape({}).angle == 0.0);
}

TEST_CASE("shape integrals: the brief ones are within 1e-7 from spheres to needles and discs") {
    for (const double a : {1.0, 1.3, 9.0, 1e4, 1e10}) {
        for (const double b : {1.0, 0.7, 1e-3, 1e-9}) {
            const std::array<double, 3> q{a, b, 1.0 / (a * b)};
            const ShapeIntegrals exact = shape_integrals(q);
            const ShapeIntegrals brief = shape_integrals_brief(q);
            for (std::size_t i = 0; i < 3; ++i) {
                CHECK(brief.first[i] == doctest::Approx(exact.first[i]).epsilon(1e-7));
                CHECK(brief.second[i] == doctest::Approx(exact.second[i]).epsilon(1e-7));
            }
        }
    }
}
