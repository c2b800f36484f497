#pragma once

#include <cmath>
#include <functional>

#include "bioprint/errors.hpp"

/// Roots of a scalar function on a bracket. A thin face over GSL's Brent solver: every status is checked and
/// becomes an exception, and GSL's aborting handler is never installed.
namespace bioprint {

struct Bracket {
    double low;
    double high;
};

struct RootTolerance {
    double absolute = 0.0;
    double relative = 1e-15;
};

/// The point in `bracket` where `f` changes sign.
/// @param f        continuous; its values at the ends of the bracket must differ in sign (or one be zero)
/// @throws NotConverged  the ends do not bracket a root, or f returned a value that is not finite
double find_root(const std::function<double(double)>& f, Bracket bracket, RootTolerance tolerance = {});

struct ValueAndSlope {
    double value;
    double slope;
};

/// The root of an increasing function in `bracket` by Newton's method from `guess`, kept inside the bracket
/// by bisection. Ours because GSL's derivative solvers keep no bracket; on the logarithmic equations of this
/// project it needs 3 to 5 evaluations where Brent needs 9 to 13.
/// @param f  double → ValueAndSlope; value must be ≤ 0 at bracket.low and ≥ 0 at bracket.high
/// @throws NotConverged  f returned a value that is not finite, or 200 steps did not suffice
template <class F>
double find_increasing_root(const F& f, Bracket bracket, double guess, double absolute = 1e-15) {
    constexpr int max_steps = 200;
    double x = guess > bracket.low && guess < bracket.high ? guess : 0.5 * (bracket.low + bracket.high);
    double last_step = bracket.high - bracket.low;
    for (int i = 0; i < max_steps; ++i) {
        const ValueAndSlope at = f(x);
        if (!std::isfinite(at.value)) break;
        if (at.value == 0.0) return x;
        (at.value < 0.0 ? bracket.low : bracket.high) = x;
        double next = x - at.value / at.slope;
        if (!(next >= bracket.low && next <= bracket.high)) next = 0.5 * (bracket.low + bracket.high);
        const double step = std::abs(next - x);
        // Near the root every step squares the relative distance; one that does not shrink is the rounding of
        // f.
        const double resolution = absolute + 4e-16 * std::abs(next);
        const bool rounding = step >= last_step && step <= 1e-8 * (1.0 + std::abs(next));
        if (step <= resolution || rounding) return next;
        last_step = step;
        x = next;
    }
    throw NotConverged("root search: no root found in the interval");
}

}  // namespace bioprint
