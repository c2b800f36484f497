#pragma once

#include <array>
#include <cstddef>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/flow/nozzle_flow.hpp"

/// The undisturbed flow on the axis where a nozzle ends and the strand begins, X = x/R counted from the lip:
///
///   u(x) = u_avg + (u_max − u_avg) f(X; n_e, n_w)
///   near the axis u gains (U2) r²,  4 η U2 = −G β(X)          (β: 1 in the nozzle, 0 in the strand)
///
/// f is this project's own simulation of creeping Cross flow (straight strand, no surface tension), tabulated over
/// the kind of nozzle flow (exit_kind.hpp), so that the law of the ink does not matter: data/exit/axis_profiles.csv,
/// made by make_exit_profiles, fitted by make_exit_table.
///
/// Accuracy: f within 8e-4 at half of the inks and 3e-3 at every one, its slope within 0.5 % and 1.25 % of the steepest, α 0 to
/// 0.95 and K u_avg/R 0.01 to 1e4, inks held out of the fit included; 1.5e-3 and 1 % against finite elements.
///                                                                                 tests/validate/exit_passage.cpp
/// β is that of the Newtonian ink for all: on the finite-element solutions of α 0.3 and 0.75 it is off by 0.07 and
/// 0.25, in inks whose nozzle stress hardly matters at the exit.
/// Cost: about 6 µs to build.
namespace bioprint {

class ExitAxis {
  public:
    explicit ExitAxis(const NozzleFlow& flow);

    /// At a distance x [m] from the lip, negative inside the nozzle.
    AxisFlow operator()(double x) const;

    /// f and its derivatives over X.
    struct Shape {
        double value;
        double slope;
        double bend;
    };
    [[nodiscard]] Shape shape(double x_over_radius) const;

    [[nodiscard]] double radius() const { return radius_; }
    /// The flow is of a kind outside the table.
    [[nodiscard]] bool extrapolated() const { return extrapolated_; }

  private:
    /// f and its first two derivatives over X times the grid step's powers.
    struct Knot {
        double value;
        double slope;
        double bend;
    };
    static constexpr double first = -8.0;
    static constexpr double last = 5.0;
    static constexpr double step = 1.0 / 24.0;
    static constexpr std::size_t size = 313;

    double radius_;
    double velocity_average_;
    double velocity_excess_;
    double pressure_gradient_;
    bool extrapolated_ = false;
    std::array<Knot, size> knots_{};
};

}  // namespace bioprint
