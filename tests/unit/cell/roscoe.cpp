#include "bioprint/cell/roscoe.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/errors.hpp"

namespace {

using namespace bioprint;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
/// Where a shape is saturated it repeats itself at every load but for the rounding of δ and of its 1/s.
constexpr double rounding = 1e-14;
constexpr double infinite = std::numeric_limits<double>::infinity();

bool finite(const EllipsoidState& s) {
    bool all = std::isfinite(s.von_mises) && std::isfinite(s.viscous);
    for (const double v : s.stretch) all = all && std::isfinite(v) && v > 0.0;
    for (const double v : s.elastic) all = all && std::isfinite(v);
    return all && std::isfinite(s.angle.value_or(0.0)) && std::isfinite(s.frequency.value_or(0.0));
}

}  // namespace

TEST_CASE(
    "roscoe shear: every load from 1e-30 to 1e30 and every viscosity ratio gives finite numbers that rise "
    "with the load") {
    for (const double lambda : {0.0, 1e-12, 1e-3, 0.2, 0.9999, 1.0, 1.7, 2.0 - 1e-12, 2.0, 2.0 + 1e-12, 2.001,
                                2.2, 2.36, 2.5, 5.0, 30.0, 100.0, 1e8}) {
        CAPTURE(lambda);
        double stretch = 0.0;
        double von_mises = 0.0;
        for (double exponent = -30.0; exponent <= 30.0; exponent += 0.25) {
            const double stress = std::pow(10.0, exponent);
            const EllipsoidState s = roscoe_shear(
                {.fluid_stress = stress, .shear_rate = 2.0, .shear_modulus = 1.0, .viscosity_ratio = lambda});
            CAPTURE(stress);
            REQUIRE(finite(s));
            // Volume, trace and von Mises are identities of the state.
            CHECK(std::abs(s.stretch[0] * s.stretch[1] * s.stretch[2] - 1.0) <
                  1e-14 * std::fmax(1.0, std::log(s.stretch[0])));
            CHECK(std::abs(s.elastic[0] + s.elastic[1] + s.elastic[2]) <= 1e-15 * s.von_mises);
            const double d12 = s.elastic[0] - s.elastic[1], d23 = s.elastic[1] - s.elastic[2],
                         d31 = s.elastic[2] - s.elastic[0];
            CHECK(std::sqrt(0.5) * std::hypot(d12, d23, d31) == doctest::Approx(s.von_mises).epsilon(1e-14));
            CHECK(s.stretch[0] >= stretch * (1.0 - rounding));
            CHECK(s.von_mises >= von_mises * (1.0 - rounding));
            CHECK(*s.angle > 0.0);
            CHECK(*s.angle <= std::numbers::pi / 4 * (1.0 + 1e-15));
            CHECK(*s.frequency <= 1.0 + 1e-15);
            stretch = s.stretch[0];
            von_mises = s.von_mises;
        }
    }
}

TEST_CASE("roscoe shear: no load leaves the sphere at rest in shape") {
    const EllipsoidState s = roscoe_shear({.fluid_stress = 0.0, .shear_rate = 3.0, .shear_modulus = 1.0});
    CHECK(s.stretch == std::array<double, 3>{1.0, 1.0, 1.0});
    CHECK(s.von_mises == 0.0);
    CHECK(s.viscous == 0.0);
    CHECK(*s.angle == doctest::Approx(std::numbers::pi / 4));
    CHECK(*s.frequency == doctest::Approx(1.5));
}

TEST_CASE("roscoe shear: stresses scale with the modulus and the frequency with the rate") {
    const EllipsoidState a =
        roscoe_shear({.fluid_stress = 0.7, .shear_rate = 1.0, .shear_modulus = 1.0, .viscosity_ratio = 0.4});
    const EllipsoidState b = roscoe_shear(
        {.fluid_stress = 700.0, .shear_rate = 5.0, .shear_modulus = 1000.0, .viscosity_ratio = 0.4});
    CHECK(b.von_mises == doctest::Approx(1000.0 * a.von_mises).epsilon(1e-14));
    CHECK(b.viscous == doctest::Approx(1000.0 * a.viscous).epsilon(1e-14));
    CHECK(*b.frequency == doctest::Approx(5.0 * *a.frequency).epsilon(1e-14));
    CHECK(b.stretch[0] == doctest::Approx(a.stretch[0]).epsilon(1e-14));
}

TEST_CASE(
    "roscoe: the stress of a rigid sphere is approached at small loads in shear and in elongation alike") {
    // 5/2 of the undisturbed deviatoric stress: von Mises (5/2) √3 σ_f with σ_f = η sqrt(2 S:S) in both
    // flows.
    const double shear =
        roscoe_shear({.fluid_stress = 1e-7, .shear_rate = 1.0, .shear_modulus = 1.0}).von_mises;
    const double elongation = roscoe_elongation({.fluid_stress = 1e-7, .shear_modulus = 1.0})->von_mises;
    CHECK(shear == doctest::Approx(elongation).epsilon(1e-6));
}

TEST_CASE("roscoe elongation: compression gives an oblate and extension a prolate cell of unit volume") {
    for (const double stress : {1.0, 100.0, 490.0}) {
        const auto c = roscoe_elongation({.fluid_stress = stress, .shear_modulus = 1000.0});
        const auto e = roscoe_elongation(
            {.fluid_stress = stress, .shear_modulus = 1000.0, .direction = ElongationDirection::extension});
        CHECK(c->stretch[0] < 1.0);
        CHECK(e->stretch[0] > 1.0);
        for (const auto& s : {*c, *e}) {
            REQUIRE(finite(s));
            CHECK(std::abs(s.stretch[0] * s.stretch[1] * s.stretch[2] - 1.0) < 1e-14);
            CHECK(std::abs(s.elastic[0] + s.elastic[1] + s.elastic[2]) <= 1e-15 * s.von_mises);
            CHECK(std::abs(s.elastic[0] - s.elastic[1]) == doctest::Approx(s.von_mises).epsilon(1e-14));
            CHECK(!s.angle.has_value());
            CHECK(!s.frequency.has_value());
        }
    }
    const auto none = roscoe_elongation({.fluid_stress = 0.0, .shear_modulus = 1000.0});
    CHECK(none->stretch == std::array<double, 3>{1.0, 1.0, 1.0});
    CHECK(none->von_mises == 0.0);
}

TEST_CASE("roscoe elongation: deformation rises with the load up to the last representable one") {
    for (const auto direction : {ElongationDirection::extension, ElongationDirection::compression}) {
        const double limit = elongation_limit_stress(1.0, direction);
        double before = 0.0;
        for (int i = 1; i <= 2000; ++i) {
            const auto s = roscoe_elongation(
                {.fluid_stress = limit * (1.0 - std::pow(1.0 - i / 2000.0, 3)) * (1.0 - 1e-15),
                 .shear_modulus = 1.0,
                 .direction = direction});
            REQUIRE(s.has_value());
            REQUIRE(finite(*s));
            CHECK(s->von_mises > before);
            before = s->von_mises;
        }
    }
}

TEST_CASE("cell: values that are no numbers or out of range are refused") {
    CHECK_THROWS_AS(roscoe_shear({.fluid_stress = -1.0, .shear_rate = 1.0, .shear_modulus = 1.0}),
                    UsageError);
    CHECK_THROWS_AS(roscoe_shear({.fluid_stress = not_a_number, .shear_rate = 1.0, .shear_modulus = 1.0}),
                    UsageError);
    CHECK_THROWS_AS(roscoe_shear({.fluid_stress = 1.0, .shear_rate = infinite, .shear_modulus = 1.0}),
                    UsageError);
    CHECK_THROWS_AS(roscoe_shear({.fluid_stress = 1.0, .shear_rate = 1.0, .shear_modulus = 0.0}), UsageError);
    CHECK_THROWS_AS(
        roscoe_shear({.fluid_stress = 1.0, .shear_rate = 1.0, .shear_modulus = 1.0, .viscosity_ratio = -0.1}),
        UsageError);
    CHECK_THROWS_AS(roscoe_shear({.fluid_stress = 1e60, .shear_rate = 1.0, .shear_modulus = 1e-3}),
                    NotConverged);
    CHECK_THROWS_AS(roscoe_elongation({.fluid_stress = 1.0, .shear_modulus = not_a_number}), UsageError);
    CHECK_THROWS_AS(
        bullet({.pressure_gradient = 1.0, .viscosity = 0.0, .cell_radius = 1.0, .shear_modulus = 1.0}),
        UsageError);
    CHECK_THROWS_AS(relaxation_time(1.0, 0.0), UsageError);
}

TEST_CASE("relaxation time: an equal inner viscosity gives 5/2 of viscosity over modulus") {
    CHECK(relaxation_time(5.0, 1000.0) == doctest::Approx(12.5e-3));
    CHECK(relaxation_time(5.0, 1000.0, 0.0) == doctest::Approx(7.5e-3));
}
