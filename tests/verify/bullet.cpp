#include "bioprint/cell/bullet.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "numerics/quadrature.hpp"

namespace {

using namespace bioprint;

constexpr BulletLoad load{
    .pressure_gradient = 8e7, .viscosity = 5.0, .cell_radius = 8e-6, .shear_modulus = 1000.0};
constexpr double stress = load.pressure_gradient * load.cell_radius;

struct Displacement {
    double z;
    double rho;
};

Displacement displacement(double z, double rho) {
    const double k = load.pressure_gradient / (4.0 * load.shear_modulus);
    return {.z = k * (5.0 / 24.0 * z * z - 85.0 / 48.0 * rho * rho), .rho = -k * 5.0 / 24.0 * rho * z};
}

}  // namespace

TEST_CASE(
    "bullet: the volume average of the von Mises stress is 0.97173 G a by quadrature of the local field") {
    const double a = load.cell_radius;
    const double integral =
        integrate(
            [&](double r) {
                return integrate(
                           [&](double c) {
                               const double sine = std::sqrt(1.0 - c * c);
                               return bullet_local_von_mises(load, r * c, r * sine) * r * r;
                           },
                           -1.0, 1.0)
                    .value;
            },
            0.0, a)
            .value;
    const double average = 2.0 * std::numbers::pi * integral / (4.0 / 3.0 * std::numbers::pi * a * a * a);
    CHECK(bullet(load).von_mises == doctest::Approx(average).epsilon(1e-11));
    CHECK(bullet(load).von_mises / stress == doctest::Approx(0.97173).epsilon(5e-6));
}

TEST_CASE("bullet: the largest von Mises stress is 1.624 G a and sits on the equator") {
    double largest = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const double angle = std::numbers::pi * i / 1000.0;
        largest = std::fmax(largest, bullet_local_von_mises(load, load.cell_radius * std::cos(angle),
                                                            load.cell_radius * std::sin(angle)));
    }
    CHECK(bullet(load).von_mises_max == doctest::Approx(largest).epsilon(1e-12));
    CHECK(bullet(load).von_mises_max / stress == doctest::Approx(1.624).epsilon(3e-4));
}

TEST_CASE("bullet: the local stress is that of the displacement field by finite differences") {
    const double a = load.cell_radius;
    const double h = 1e-4 * a;
    for (const auto& [z, rho] :
         {Displacement{0.3 * a, 0.4 * a}, Displacement{-0.7 * a, 0.2 * a}, Displacement{0.0, 0.9 * a}}) {
        const double zz = (displacement(z + h, rho).z - displacement(z - h, rho).z) / (2 * h);
        const double rr = (displacement(z, rho + h).rho - displacement(z, rho - h).rho) / (2 * h);
        const double tt = displacement(z, rho).rho / rho;
        const double zr = 0.5 * ((displacement(z, rho + h).z - displacement(z, rho - h).z) / (2 * h) +
                                 (displacement(z + h, rho).rho - displacement(z - h, rho).rho) / (2 * h));
        CHECK(std::abs(zz + rr + tt) < 1e-9 * std::abs(zr));
        const double von_mises =
            2.0 * load.shear_modulus * std::sqrt(1.5 * (zz * zz + rr * rr + tt * tt + 2.0 * zr * zr));
        CHECK(von_mises == doctest::Approx(bullet_local_von_mises(load, z, rho)).epsilon(1e-8));
    }
}

TEST_CASE(
    "bullet: the surface follows the third Legendre polynomial with amplitude 0.21875 G a over the modulus") {
    // To first order the surface is at a + u_r, up to the displacement of the whole cell (the P1 part).
    const double a = load.cell_radius;
    const auto radial = [&](double c) {
        const double sine = std::sqrt(1.0 - c * c);
        const auto u = displacement(a * c, a * sine);
        return (u.z * c + u.rho * sine) / a;
    };
    const auto part = [&](auto&& legendre, int n) {
        const GaussRule& rule = gauss_rule();  // exact for these polynomials
        double sum = 0.0;
        for (std::size_t i = 0; i < GaussRule::size; ++i) {
            const double c = 2.0 * rule.node[i] - 1.0;
            sum += 2.0 * rule.weight[i] * radial(c) * legendre(c);
        }
        return (n + 0.5) * sum;
    };
    const auto p3 = [](double c) { return 0.5 * (5.0 * c * c * c - 3.0 * c); };
    const auto p2 = [](double c) { return 0.5 * (3.0 * c * c - 1.0); };
    CHECK(bullet(load).shape_amplitude == doctest::Approx(part(p3, 3)).epsilon(1e-11));
    CHECK(std::abs(part(p2, 2)) < 1e-15);
    CHECK(bullet(load).shape_amplitude ==
          doctest::Approx(0.21875 * stress / load.shear_modulus).epsilon(1e-15));
}

TEST_CASE("bullet: the slip of a small cell is the one of Faxen") {
    // U = u0 + a²/6 ∇²u with ∇²u = −G/η.
    const double faxen = -load.pressure_gradient / load.viscosity * load.cell_radius * load.cell_radius / 6.0;
    CHECK(bullet(load).slip == doctest::Approx(faxen).epsilon(1e-15));
}
