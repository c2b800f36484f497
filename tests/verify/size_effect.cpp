#include "predict/size_effect.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/predict/streamline_passage.hpp"
#include "cell/tensor.hpp"

namespace {

using namespace bioprint;

constexpr double radius = 50e-6;
constexpr double cell_radius = 8e-6;

NozzleFlow nozzle(double alpha) {
    return NozzleFlow::from_velocity({.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}, radius, 5e-3);
}

/// The bullet's elastic stress at a point of the unit ball, G = a = 1; z along x.
Tensor bullet_stress(double x, double r, double t) {
    const double a = 5.0 / 24.0 / 4.0;
    const double b = -85.0 / 48.0 / 4.0;
    const double slope = 2.0 * b - a;
    return {{{4.0 * a * x, slope * r, slope * t},
             {slope * r, -2.0 * a * x, 0.0},
             {slope * t, 0.0, -2.0 * a * x}}};
}

double von_mises(const Tensor& s) {
    double square = 0.0;
    for (const auto& row : s) {
        for (const double v : row) square += v * v;
    }
    return std::sqrt(1.5 * square);
}

/// The volume average over the unit ball of uniform plus bullet stress, by the midpoint rule.
double average(const Tensor& uniform) {
    constexpr int n = 60;
    double sum = 0.0;
    double volume = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (int k = 0; k < n; ++k) {
                const double x = 2.0 * (i + 0.5) / n - 1.0;
                const double r = 2.0 * (j + 0.5) / n - 1.0;
                const double t = 2.0 * (k + 0.5) / n - 1.0;
                if (x * x + r * r + t * t > 1.0) continue;
                Tensor s = bullet_stress(x, r, t);
                for (std::size_t p = 0; p < 3; ++p) {
                    for (std::size_t q = 0; q < 3; ++q) s[p][q] += uniform[p][q];
                }
                sum += von_mises(s);
                volume += 1.0;
            }
        }
    }
    return sum / volume;
}

}  // namespace

TEST_CASE("size effect: the rule for uniform and linear stress is within 2 % of the volume average") {
    const double linear =
        bullet({.pressure_gradient = 1.0, .viscosity = 1.0, .cell_radius = 1.0, .shear_modulus = 1.0})
            .von_mises;
    CHECK(average({}) == doctest::Approx(linear).epsilon(3e-3));  // the midpoint rule's own error
    double worst = 0.0;
    // Shear of the plane, a settled soft cell's 2 : −1.1 : −0.9 at 27 degrees, compression along x.
    const double c = std::cos(0.47), s = std::sin(0.47);
    const std::array<Tensor, 3> shapes{{{{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}}},
                                        {{{2 * c * c - 1.1 * s * s, 3.1 * c * s, 0},
                                          {3.1 * c * s, 2 * s * s - 1.1 * c * c, 0},
                                          {0, 0, -0.9}}},
                                        {{{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}};
    for (const Tensor& shape : shapes) {
        for (const double size : {0.1, 0.3, 0.6, 1.0, 1.7, 3.0, 6.0}) {
            Tensor uniform = shape;
            const double scale = size / von_mises(shape);
            for (auto& row : uniform) {
                for (double& v : row) v *= scale;
            }
            const double shear = 3.0 * uniform[0][1] * uniform[0][1] / (size * size);
            const double exact = average(uniform);
            const double error = combined_stress(size, linear, shear) / exact - 1.0;
            INFO("shear part " << shear << ", uniform " << size << ": " << 100.0 * error << " %");
            worst = std::fmax(worst, std::abs(error));
            CHECK(std::abs(error) < 0.02);
        }
    }
    MESSAGE("worst " << 100.0 * worst << " %");
}

TEST_CASE("size effect: every value tends to that on the axis as the offset goes to zero") {
    for (const double alpha : {0.0, 0.3, 0.75}) {
        CAPTURE(alpha);
        const NozzleFlow flow = nozzle(alpha);
        const AxisCell cell{.radius = cell_radius, .shear_modulus = 1000.0};
        const AxisPassage axis = exit_passage(flow, exit_passage_request(flow, cell)).passage;
        const double linear = bullet({.pressure_gradient = flow.pressure_gradient(),
                                      .viscosity = 1.0,
                                      .cell_radius = cell_radius,
                                      .shear_modulus = 1000.0})
                                  .von_mises;
        for (const double offset : {0.0, 1e-6, 0.01}) {
            CAPTURE(offset);
            const StreamlinePassage p = streamline_passage(
                flow,
                {.start_radius = offset * cell_radius, .shear_modulus = 1000.0, .cell_radius = cell_radius});
            // At 0.01 R_c the shear is there, a hundredth of that at R_c.
            const double tolerance = offset > 1e-3 ? 4e-3 : 1e-3;
            CHECK(p.nozzle_end.von_mises == doctest::Approx(linear).epsilon(tolerance));
            CHECK(p.exit.von_mises == doctest::Approx(axis.peak.von_mises).epsilon(tolerance));
            CHECK(p.exit.stretch[0] == doctest::Approx(axis.peak.axial_stretch).epsilon(tolerance));
            CHECK(p.exit.stretch[1] == doctest::Approx(axis.peak.radial_stretch).epsilon(tolerance));
            CHECK(p.exit.stretch[2] == doctest::Approx(axis.peak.radial_stretch).epsilon(tolerance));
            CHECK(std::abs(p.exit.angle) < 0.03);
            // The top is flat: the tolerance of the stress is one of 0.02 R for its place, over which the ink's stress
            // changes by 4.5 %.
            CHECK(std::abs(p.exit.position - axis.peak.position) < 0.02 * radius);
            CHECK(p.exit.fluid_stress == doctest::Approx(axis.peak.fluid_stress).epsilon(4.5e-2));
            CHECK(p.exit.time == doctest::Approx(axis.peak.time).epsilon(1e-2));
            CHECK(p.exit_exposure == doctest::Approx(axis.end.stress_exposure).epsilon(3e-3));
        }
    }
}
