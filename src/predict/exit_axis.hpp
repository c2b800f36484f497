#pragma once

#include <array>
#include <cstddef>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/flow/nozzle_flow.hpp"

/// The undisturbed flow on the axis where a nozzle ends and the strand begins, X = x/R counted from the lip:
///
///   u(x) = u_avg + (u_max − u_avg) f(X; α, K u_avg/R)        f = [1 + e^((X−x0)/w) + c
///   e^((X−x0)/1.2)]^(−0.6) near the axis u gains (U2) r²,  4 η U2 = −G β(X)          (β: 1 in the nozzle, 0
///   in the strand)
///
/// x0, w, c are fits to a finite-element solution of creeping Cross flow (straight strand, no surface
/// tension) for seven α from 0 to 0.9 and five reduced rates K u_avg/R from 0.05 to 500:
/// data/exit/axis_profile.csv, which names the largest error of f, 0.006 to 0.023. Between them cubic
/// interpolation in α and in the logarithm of the rate; below the smallest rate the ink's thinning fades as
/// rate^α; past the ends in α and above the largest rate, the end's values. β is that of the Newtonian ink
/// for all: on the finite-element solutions of α 0.3 and 0.75 it is off by 0.07 and 0.25, in inks whose
/// nozzle stress hardly matters at the exit.
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
    /// The ink is outside the tabulated α or rates.
    [[nodiscard]] bool extrapolated() const { return extrapolated_; }

  private:
    /// f and its first two derivatives over X times the grid step's powers.
    struct Knot {
        double value;
        double slope;
        double bend;
    };
    static constexpr double first = -8.0;
    static constexpr double step = 1.0 / 16.0;
    static constexpr std::size_t size = 257;

    double radius_;
    double velocity_average_;
    double velocity_excess_;
    double pressure_gradient_;
    bool extrapolated_ = false;
    std::array<Knot, size> knots_{};
};

}  // namespace bioprint
