#include "simulate/shear_scene.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

constexpr double modulus = 1000.0;
constexpr double rate = 10.0;

struct Compared {
    ShearSceneResult simulated;
    EllipsoidState exact;
    double stress_error;
};

Compared compare(const ShearSceneSetup& setup) {
    Compared c{.simulated = run_shear_scene(setup),
               .exact = roscoe_shear(
                   {.fluid_stress = setup.fluid_stress, .shear_rate = rate, .shear_modulus = modulus}),
               .stress_error = 0.0};
    c.stress_error = c.simulated.von_mises / c.exact.von_mises - 1.0;
    const double degree = 180.0 / std::numbers::pi;
    std::printf(
        "%5.2f %5.1f  %6.2f %%   %6.3f %6.3f   %6.3f %6.3f   %5.2f %5.2f   %5.3f %5.3f   %7.1f %7.1f\n",
        setup.fluid_stress / modulus, setup.nodes, 100.0 * c.stress_error, c.simulated.stretch[0],
        c.exact.stretch[0], c.simulated.stretch[1], c.exact.stretch[1], c.simulated.angle * degree,
        c.exact.angle.value_or(0.0) * degree, c.simulated.frequency / rate,
        c.exact.frequency.value_or(0.0) / rate, c.simulated.viscous, c.exact.viscous);
    return c;
}

void heading() {
    std::printf(
        "   Ca nodes    stress   alpha1  exact   alpha2  exact   angle exact   freq. exact   viscous   "
        "exact\n");
}

}  // namespace

TEST_CASE("shear scene: a draft comes near the exact ellipsoid") {
    heading();
    const Compared c = compare({.fluid_stress = 0.5 * modulus,
                                .shear_modulus = modulus,
                                .shear_rate = rate,
                                .nodes = 3.0,
                                .longest = 8.0});
    // Three nodes a radius leave 5 % in stress and shape.
    CHECK(std::abs(c.stress_error) < 0.05);
    CHECK(c.simulated.stretch[0] == doctest::Approx(c.exact.stretch[0]).epsilon(0.05));
    CHECK(c.simulated.stretch[1] == doctest::Approx(c.exact.stretch[1]).epsilon(0.05));
    CHECK(c.simulated.frequency == doctest::Approx(c.exact.frequency.value()).epsilon(0.05));
    CHECK(c.simulated.volume == doctest::Approx(1.0).epsilon(0.005));
    CHECK(c.simulated.peak_von_mises > c.simulated.von_mises);
}

TEST_CASE("shear scene: values out of range are refused") {
    CHECK_THROWS_AS(run_shear_scene({.fluid_stress = 0.0, .shear_modulus = 1.0, .shear_rate = 1.0}),
                    UsageError);
    CHECK_THROWS_AS(
        run_shear_scene({.fluid_stress = 1.0, .shear_modulus = 1.0, .shear_rate = 1.0, .nodes = 1.0}),
        UsageError);
    CHECK_THROWS_AS(
        run_shear_scene(
            {.fluid_stress = 1.0, .shear_modulus = 1.0, .shear_rate = 1.0, .box = {1.0, 15.0, 5.0}}),
        UsageError);
}
