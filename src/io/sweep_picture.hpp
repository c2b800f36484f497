#pragma once

#include "io/picture.hpp"
#include "io/sweep.hpp"
#include "io/sweep_values.hpp"

/// A sweep as curves: over its last option with numbers, a line for every combination of the others.
namespace bioprint {

/// @throws UsageError  too many rows, or more lines than can be told apart; the same before the values are there
Picture sweep_picture(const Sweep& sweep, const SweepValues& values);

}  // namespace bioprint
