#pragma once

#include <functional>

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

}  // namespace bioprint
