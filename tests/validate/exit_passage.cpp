#include "bioprint/predict/exit_passage.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/cell/bullet.hpp"
#include "predict/exit_axis.hpp"
#include "predict/exit_axis_table.hpp"
#include "support/reference_table.hpp"

namespace {

using namespace bioprint;

constexpr double radius = 50e-6;
constexpr AxisCell reference_cell{.radius = 8e-6, .shear_modulus = 1000.0};
constexpr AxisEffects ellipsoid_alone{
    .volume_average = false, .quadratic_flow = false, .disturbed_viscosity = false};

CrossInk alginate(double alpha) {
    return {.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha};
}

NozzleFlow nozzle(double alpha, double velocity) {
    return NozzleFlow::from_velocity(alginate(alpha), radius, velocity);
}

/// The undisturbed velocity on the axis from the finite-element table, cubic between its points.
class FiniteElementAxis {
  public:
    explicit FiniteElementAxis(const std::string& file) {
        for (const auto& row : test::read_reference(file)) {
            x_.push_back(row.at("x_over_R"));
            u_.push_back(row.at("velocity"));
        }
    }

    AxisFlow operator()(double z) const {
        const double step = x_[1] - x_[0];
        const double place =
            std::fmin(std::fmax((z / radius - x_[0]) / step, 1.0), static_cast<double>(x_.size()) - 3.0);
        const auto i = static_cast<std::size_t>(place);
        const double t = place - static_cast<double>(i);
        const double m = 0.5 * (u_[i + 1] - u_[i - 1]);
        const double n = 0.5 * (u_[i + 2] - u_[i]);
        const double d = u_[i + 1] - u_[i];
        return {.velocity = u_[i] + t * (m + t * (3 * d - 2 * m - n + t * (m + n - 2 * d))),
                .elongation = (m + t * (2 * (3 * d - 2 * m - n) + t * 3 * (m + n - 2 * d))) / (step * radius),
                .axial = 0.0,
                .radial = 0.0};
    }

  private:
    std::vector<double> x_;
    std::vector<double> u_;
};

struct Simulated {
    double alpha;
    double velocity;  ///< average [m/s]
    double peak;      ///< von Mises [Pa]
    double axial_min;
    double radial_max;
};

/// An axisymmetric lattice-Boltzmann simulation with a neo-Hookean cell, R_c 8 µm, μ 1 kPa, R 50 µm, η0 10 Pa
/// s, K 50 ms. α 0 and 0.75 at 5 mm/s converged over four resolutions (stress ±2 %); the rest at one
/// resolution with the radius of the immersed boundary corrected. Where both exist that resolution is 2 (α
/// 0.75) to 4 % (α 0) high in stress and, at α 0, 15 % in radial strain, which is why the bound on the radial
/// strain is wide.
constexpr std::array<Simulated, 10> simulated{{{0.0, 5e-3, 1140.0, 0.664, 1.246},
                                               {0.15, 5e-3, 1047.0, 0.694, 1.230},
                                               {0.30, 5e-3, 921.0, 0.723, 1.190},
                                               {0.45, 5e-3, 791.0, 0.757, 1.154},
                                               {0.60, 5e-3, 657.0, 0.796, 1.122},
                                               {0.75, 5e-3, 512.0, 0.838, 1.094},
                                               {0.75, 1e-2, 566.0, 0.823, 1.103},
                                               {0.75, 2e-2, 609.0, 0.811, 1.113},
                                               {0.75, 5e-2, 666.0, 0.794, 1.127},
                                               {0.75, 1e-1, 699.0, 0.787, 1.136}}};

}  // namespace

TEST_CASE("exit passage: a round point cell on the finite-element axis peaks at the trial figures") {
    // 1078, 921, 582 Pa by an independent integration of the same equations; sphere at the start, no effect
    // of size.
    for (const auto& [file, alpha, peak] : {std::tuple{"exit_axis_alpha0.00.csv", 0.0, 1078.0},
                                            std::tuple{"exit_axis_alpha0.30.csv", 0.3, 921.0},
                                            std::tuple{"exit_axis_alpha0.75.csv", 0.75, 582.0}}) {
        const FiniteElementAxis axis(file);
        const AxisPassage p = carry_along_axis(axis, alginate(alpha), reference_cell,
                                               {.from = -3.5 * radius, .to = 3.5 * radius}, ellipsoid_alone);
        CAPTURE(alpha);
        CHECK(p.peak.von_mises == doctest::Approx(peak).epsilon(6e-3));
    }
}

TEST_CASE("exit axis: the interpolated profile is as close to the finite-element velocity as its fits say") {
    for (const auto& [file, alpha] :
         {std::pair{"exit_axis_alpha0.00.csv", 0.0}, std::pair{"exit_axis_alpha0.30.csv", 0.3},
          std::pair{"exit_axis_alpha0.75.csv", 0.75}}) {
        const FiniteElementAxis exact(file);
        const NozzleFlow flow = nozzle(alpha, 5e-3);
        const ExitAxis axis(flow);
        double worst = 0.0;
        for (double x = -3.9; x < 3.9; x += 0.01) {
            worst = std::fmax(worst, std::abs(axis(x * radius).velocity - exact(x * radius).velocity) /
                                         flow.velocity_excess());
        }
        CAPTURE(alpha);
        CHECK(worst < 0.0085);
        CHECK(!axis.extrapolated());
    }
}

TEST_CASE("exit axis: the compiled table is the one in data") {
    std::size_t row = 0;
    for (const auto& line : test::read_reference("../../data/exit/axis_profile.csv")) {
        const std::size_t i = row / exit_rates.size();
        const std::size_t j = row % exit_rates.size();
        ++row;
        CHECK(line.at("alpha") == exit_alphas.at(i));
        CHECK(line.at("rate") == exit_rates.at(j));
        CHECK(line.at("x0") == exit_shapes.at(i).at(j).x0);
        CHECK(line.at("w") == exit_shapes.at(i).at(j).w);
        CHECK(line.at("c") == exit_shapes.at(i).at(j).c);
        CHECK(line.at("max_error") < 0.023);
    }
    CHECK(row == exit_alphas.size() * exit_rates.size());
}

TEST_CASE("exit axis: its derivatives are those of its velocity") {
    const ExitAxis axis(nozzle(0.55, 5e-3));
    const double h = 1e-9;
    for (double x = -3.03; x < 3.0; x += 0.17) {
        const AxisFlow f = axis(x * radius);
        const AxisFlow a = axis(x * radius + h);
        const AxisFlow b = axis(x * radius - h);
        CHECK(f.elongation == doctest::Approx((a.velocity - b.velocity) / (2 * h)).epsilon(1e-5).scale(1.0));
        CHECK(f.axial == doctest::Approx((a.elongation - b.elongation) / (4 * h)).epsilon(1e-4).scale(1e5));
    }
}

TEST_CASE(
    "exit axis: every ink and speed gives a velocity that falls from the middle of the nozzle to the "
    "strand") {
    for (double alpha = 0.0; alpha < 1.0; alpha += 0.05) {
        for (double k = 1e-8; k < 1e8; k *= 10.0) {
            const NozzleFlow flow = NozzleFlow::from_velocity(
                CrossInk{.eta0 = 10.0, .time_constant = k, .alpha = alpha}, radius, 5e-3);
            const ExitAxis axis(flow);
            double before = flow.velocity_max() * (1.0 + 1e-12);
            for (double x = -9.0; x < 9.0; x += 0.25) {
                const double u = axis(x * radius).velocity;
                CHECK(u <= before);
                CHECK(u >= flow.velocity_average() * (1.0 - 1e-12));
                before = u;
            }
        }
    }
}

TEST_CASE("exit passage: peak stress and strain agree with the simulations of ten prints") {
    // Five per cent is asked of the stress; the strains are counted from 1.
    for (const Simulated& s : simulated) {
        const AxisPassage p = exit_passage(nozzle(s.alpha, s.velocity), {.cell = reference_cell}).passage;
        const double stress = p.peak.von_mises / s.peak - 1.0;
        const double axial = (1.0 - p.axial_stretch_min) / (1.0 - s.axial_min) - 1.0;
        const double radial = (p.radial_stretch_max - 1.0) / (s.radial_max - 1.0) - 1.0;
        MESSAGE("alpha " << s.alpha << ", " << 1000 * s.velocity << " mm/s: " << p.peak.von_mises << " Pa ("
                         << 100 * stress << " %), axial strain " << 100 * axial << " %, radial "
                         << 100 * radial << " %");
        CHECK(std::abs(stress) < 0.025);
        CHECK(std::abs(axial) < 0.025);
        CHECK(std::abs(radial) < 0.12);
    }
}

TEST_CASE("exit passage: a stiff cell bears what a rigid sphere does and agrees with its simulation") {
    // μ 50 kPa, α 0: converging to 3218 Pa over two resolutions, the rigid sphere at the peak rate 3268 Pa.
    const AxisPassage p =
        exit_passage(nozzle(0.0, 5e-3), {.cell = {.radius = 8e-6, .shear_modulus = 5e4}}).passage;
    CHECK(p.peak.von_mises == doctest::Approx(3218.0).epsilon(0.03));
}

TEST_CASE("exit passage: the channel state it starts from is the bullet") {
    const NozzleFlow flow = nozzle(0.0, 5e-3);
    const AxisPassage p = exit_passage(flow, {.cell = reference_cell}).passage;
    const BulletState steady = bullet({.pressure_gradient = flow.pressure_gradient(),
                                       .viscosity = 5.0,
                                       .cell_radius = 8e-6,
                                       .shear_modulus = 1000.0});
    CHECK(p.start.von_mises == doctest::Approx(steady.von_mises).epsilon(3e-3));
}

TEST_CASE("exit passage: peak and strains converge with the tolerance of the integrator") {
    for (const double alpha : {0.0, 0.6}) {
        const NozzleFlow flow = nozzle(alpha, 5e-3);
        const ExitAxis axis(flow);
        const auto peak = [&](double tolerance) {
            return carry_along_axis(axis, flow.ink(), reference_cell,
                                    {.from = -4 * radius, .to = 7.5 * radius, .tolerance = tolerance})
                .peak.von_mises;
        };
        const double exact = peak(1e-9);
        CHECK(std::abs(peak(1e-5) / exact - 1.0) < 3e-4);
        CHECK(std::abs(peak(1e-7) / exact - 1.0) < 2e-5);
    }
}
