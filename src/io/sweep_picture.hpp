#pragma once

#include "io/picture.hpp"
#include "io/run.hpp"
#include "io/sweep.hpp"

/// A sweep as curves: over its last option with numbers, a line for every combination of the others.
namespace bioprint {

/// Draws the values of `--get`, or else the stress at the wall and of the cells in nozzle and at exit; with the spread
/// of each when an uncertainty is asked for.
/// @throws UsageError  more lines than can be told apart, a path that is no number, and what predict() throws when
/// no row has an answer
Picture sweep_picture(const Sweep& sweep, const RunOptions& options);

}  // namespace bioprint
