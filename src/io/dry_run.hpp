#pragma once

#include <optional>
#include <string>

#include "io/ladder_answer.hpp"
#include "io/simulation_answer.hpp"
#include "io/sweep.hpp"

/// `--dry-run`: what a call would do, without doing it.
namespace bioprint {

struct PlannedWork {
    const Sweep& sweep;
    std::optional<std::string> batch;  ///< its file; "-" is standard input, which is not read
    std::optional<SimulationQuestion> simulation;
    std::optional<LadderAnswer> ladder;
    unsigned jobs = 1;
};

/// Rows, model, expected time and memory, a line each.
/// @throws DataError  the batch cannot be read
std::string dry_run(const PlannedWork& work);

}  // namespace bioprint
