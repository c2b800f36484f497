#pragma once

#include <string>
#include <vector>

#include "io/picture.hpp"
#include "io/sweep.hpp"

/// A sweep as curves: over its last option with numbers, a line for every combination of the others.
namespace bioprint {

/// @param paths  of `--get`: what is drawn; empty: the stress at the wall and of the cells in nozzle and at exit
/// @throws UsageError  more lines than can be told apart, a path that is no number, and what predict() throws when
/// no row has an answer
Picture sweep_picture(const Sweep& sweep, const std::vector<std::string>& paths, unsigned jobs);

}  // namespace bioprint
