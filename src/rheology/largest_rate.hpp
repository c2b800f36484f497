#pragma once

#include <string>

#include "bioprint/errors.hpp"
#include "numerics/brief.hpp"

namespace bioprint {

/// No ink is described at a rate past 1e100/s; the bound also keeps every later product finite.
/// @throws NoSteadyFlow
inline double within_largest_rate(double rate, double stress) {
    if (rate <= 1e100) return rate;
    throw NoSteadyFlow(
        "no steady flow: a stress of " + brief(stress) +
        " Pa shears this ink faster than any number of use; check the units of load, consistency and "
        "flow index");
}

}  // namespace bioprint
