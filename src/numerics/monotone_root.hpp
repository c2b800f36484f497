#pragma once

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"

/// Root of an increasing function whose slope is about 1, for equations that were first put in such a form
/// (logarithm against logarithm). Inlined: these equations are solved a million times in a sweep.
namespace bioprint {

struct MonotoneBracket {
    double low;    ///< f < 0 here, or the root itself
    double high;   ///< f > 0 here, or the root itself
    double guess;  ///< where to start
};

/// Secant steps from the guess, each kept inside the shrinking bracket, halving it where a step fails.
/// @param f     increasing; may be infinite, not NaN
/// @param done  done(x_new, x_old): true when the step no longer matters
/// @throws NotConverged  after 200 steps
template <typename F, typename Done>
double increasing_root(F&& f, const MonotoneBracket& bracket, Done&& done) {
    double low = bracket.low;
    double high = bracket.high;
    double before = std::clamp(bracket.guess, low, high);
    double f_before = f(before);
    double x = std::clamp(before - f_before, low, high);
    (f_before > 0.0 ? high : low) = before;
    for (int i = 0; i < 200; ++i) {
        if (f_before == 0.0 || done(x, before)) return x;
        const double value = f(x);
        if (value == 0.0) return x;
        (value > 0.0 ? high : low) = x;
        double next = x - value * (x - before) / (value - f_before);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        before = x;
        f_before = value;
        x = next;
    }
    throw NotConverged("root of an increasing function: no convergence in 200 steps");
}

}  // namespace bioprint
