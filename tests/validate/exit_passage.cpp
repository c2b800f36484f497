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
#include "predict/exit_simulated.hpp"
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

/// What the table leaves of u_max − u_avg and of the steepest slope, at common inks and at the worst of all.
constexpr double fitted_velocity = 1.5e-3;
constexpr double fitted_slope = 0.01;
constexpr double fitted_velocity_anywhere = 3e-3;
constexpr double fitted_slope_anywhere = 0.0125;

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

TEST_CASE(
    "exit axis: the table is as close to the finite-element velocity as to the simulations it was made "
    "from") {
    for (const auto& [file, alpha] :
         {std::pair{"exit_axis_alpha0.00.csv", 0.0}, std::pair{"exit_axis_alpha0.30.csv", 0.3},
          std::pair{"exit_axis_alpha0.75.csv", 0.75}}) {
        const FiniteElementAxis exact(file);
        const NozzleFlow flow = nozzle(alpha, 5e-3);
        const ExitAxis axis(flow);
        double velocity = 0.0;
        double slope = 0.0;
        double steepest = 0.0;
        for (double x = -3.9; x < 2.9; x += 0.01) {
            const AxisFlow ours = axis(x * radius);
            const AxisFlow theirs = exact(x * radius);
            velocity =
                std::fmax(velocity, std::abs(ours.velocity - theirs.velocity) / flow.velocity_excess());
            slope = std::fmax(slope, std::abs(ours.elongation - theirs.elongation));
            steepest = std::fmax(steepest, std::abs(theirs.elongation));
        }
        CAPTURE(alpha);
        MESSAGE("alpha " << alpha << ": velocity " << velocity << ", slope " << slope / steepest);
        CHECK(velocity < fitted_velocity);
        CHECK(slope < fitted_slope * steepest);
        CHECK(!axis.extrapolated());
    }
}

TEST_CASE("exit axis: the table gives the simulated exit flows and those held out of its fit") {
    const auto [places, inks] = read_simulated_exits(BIOPRINT_SOURCE_DIR "/data/exit/axis_profiles.csv");
    std::size_t held_out = 0;
    for (const SimulatedExit& ink : inks) {
        if (ink.remainder > 0.0) continue;
        const NozzleFlow flow = NozzleFlow::from_velocity(
            CrossInk{.eta0 = 10.0, .time_constant = ink.rate * radius / 5e-3, .alpha = ink.alpha}, radius,
            5e-3);
        const ExitAxis axis(flow);
        double velocity = 0.0;
        double slope = 0.0;
        double steepest = 0.0;
        for (std::size_t k = 1; k + 1 < places.size(); ++k) {
            const double step = places[k + 1] - places[k - 1];
            const double theirs = (ink.exact[k + 1] - ink.exact[k - 1]) / step;
            const double ours = (axis.shape(places[k + 1]).value - axis.shape(places[k - 1]).value) / step;
            velocity = std::fmax(velocity, std::abs(axis.shape(places[k]).value - ink.exact[k]));
            slope = std::fmax(slope, std::abs(ours - theirs));
            steepest = std::fmax(steepest, std::abs(theirs));
        }
        CAPTURE(ink.name);
        CHECK(velocity < fitted_velocity_anywhere);
        CHECK(slope < fitted_slope_anywhere * steepest);
        CHECK(ink.wall_index == doctest::Approx(flow_index(flow.ink(), flow.shear_rate_max())).epsilon(1e-4));
        held_out += ink.held_out ? 1 : 0;
    }
    CHECK(inks.size() > 60);
    CHECK(held_out > 10);
}

TEST_CASE("exit axis: nine of ten simulated inks with a remaining viscosity are within 0.025") {
    const auto [places, inks] = read_simulated_exits(BIOPRINT_SOURCE_DIR "/data/exit/axis_profiles.csv");
    int close = 0;
    int all = 0;
    for (const SimulatedExit& ink : inks) {
        if (ink.remainder == 0.0) continue;
        const ExitAxis axis(NozzleFlow::from_velocity(CrossInk{.eta0 = 10.0,
                                                               .eta_inf = 10.0 * ink.remainder,
                                                               .time_constant = ink.rate * radius / 5e-3,
                                                               .alpha = ink.alpha},
                                                      radius, 5e-3));
        double velocity = 0.0;
        for (std::size_t k = 0; k < places.size(); ++k) {
            velocity = std::fmax(velocity, std::abs(axis.shape(places[k]).value - ink.exact[k]));
        }
        CAPTURE(ink.name);
        CHECK(velocity < 0.09);
        close += velocity < 0.025 ? 1 : 0;
        ++all;
    }
    CHECK(all == 10);
    CHECK(close == 9);
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
            // The Newtonian ink runs 1.3e-4 faster at X = −1.7 than far upstream, in finite elements too.
            const double allowed = 4e-4 * flow.velocity_excess();
            double before = flow.velocity_max() + allowed;
            for (double x = -9.0; x < 9.0; x += 0.25) {
                const double u = axis(x * radius).velocity;
                CHECK(u <= before + allowed);
                CHECK(u >= flow.velocity_average() * (1.0 - 1e-12));
                before = u;
            }
        }
    }
}

TEST_CASE(
    "exit passage: peak stress and strains agree with the simulations of every load a nozzle leaves steady") {
    // Five per cent is asked, beside what the simulation itself is uncertain by; the strains are counted from 1. Above
    // the smaller load the second order that the model has of the shape in the nozzle no longer suffices; a nearly
    // rigid cell in a thinning ink comes out up to 9 % low in stress and 11 % in its small strains.
    constexpr double small_load = 0.641;  // G R_c/μ
    constexpr double stiff_load = 0.03;
    constexpr double asked = 0.05;
    constexpr double asked_of_stiff_cells = 0.09;
    constexpr double asked_of_stiff_strains = 0.11;
    constexpr double asked_of_large_loads = 0.15;
    int compared = 0;
    for (const auto& s : test::read_reference("exit_cell_simulated.csv")) {
        const AxisCell cell{.radius = s.at("cell_radius [m]"), .shear_modulus = s.at("shear_modulus [Pa]")};
        const NozzleFlow flow = nozzle(s.at("alpha"), s.at("velocity [m/s]"));
        const double load = flow.pressure_gradient() * cell.radius / cell.shear_modulus;
        const AxisPassage p = exit_passage(flow, exit_passage_request(flow, cell)).passage;
        const auto off = [&](const char* name, double ours, double zero) {
            const double simulated = s.at(zero == 0.0 ? std::string(name) + " [Pa]" : name) - zero;
            return std::pair{(ours - zero) / simulated - 1.0,
                             std::abs(s.at(std::string(name) + " error") / simulated)};
        };
        const auto stress = off("von_mises_peak", p.peak.von_mises, 0.0);
        const auto axial = off("stretch_axial_min", p.axial_stretch_min, 1.0);
        const auto radial = off("stretch_radial_max", p.radial_stretch_max, 1.0);
        MESSAGE("alpha " << s.at("alpha") << ", " << 1000 * s.at("velocity [m/s]") << " mm/s, "
                         << cell.shear_modulus << " Pa, load " << load << ": peak " << 100 * stress.first
                         << " %, axial strain " << 100 * axial.first << " %, radial " << 100 * radial.first
                         << " %; simulation " << 100 * stress.second << ", " << 100 * axial.second << ", "
                         << 100 * radial.second << " %");
        if (s.at("steady channel") == 0.0 || load > softest_bullet) continue;
        const bool rigid = load < stiff_load && s.at("alpha") > 0.0;
        const double bound = load > small_load ? asked_of_large_loads : rigid ? asked_of_stiff_cells : asked;
        CHECK(std::abs(stress.first) < bound + stress.second);
        const double strains = rigid ? asked_of_stiff_strains : bound;
        CHECK(std::abs(axial.first) < strains + axial.second);
        CHECK(std::abs(radial.first) < strains + radial.second);
        ++compared;
    }
    CHECK(compared > 20);
}

TEST_CASE("exit passage: the answer changes smoothly where the cell becomes too soft for the nozzle") {
    // G R_c/μ passes 1.3 between 10 and 11 mm/s.
    double before = 0.0;
    for (double velocity = 9e-3; velocity < 12e-3; velocity += 1e-4) {
        const NozzleFlow flow = nozzle(0.0, velocity);
        const double peak =
            exit_passage(flow, exit_passage_request(flow, reference_cell)).passage.peak.von_mises;
        if (before > 0.0) CHECK(std::abs(peak / before - 1.0) < 0.02);
        before = peak;
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
