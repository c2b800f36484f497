#pragma once

#include "bioprint/simulate/simulation.hpp"

/// What a simulation takes, known before it runs: the lattice nodes and steps it plans, over the updates a second that were
/// measured. How many of its steps a run needs is known only when its cell has settled, so that a time is a range.
namespace bioprint {

struct SimulationWork {
    double least;  ///< processor time [s] of a cell that settles at once
    double
        most;  ///< [s]: every stage as long as it may be or, without such a limit, as long as any measured one took
    double memory;  ///< largest resident set [B]
};

/// Of both resolutions. Processor times are those of one core of the machine named in data/trade.json.
/// Accuracy: every run in data/trade.json lies within it (tests/verify/simulation_work.cpp).
/// @throws UsageError, NoSteadyFlow  as check_scene()
SimulationWork expected_work(const Scene& scene, const SimulationOptions& options = {});

}  // namespace bioprint
