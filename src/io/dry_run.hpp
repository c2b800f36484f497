#pragma once

#include <optional>
#include <string>

#include "io/ladder_answer.hpp"
#include "io/run.hpp"
#include "io/simulation_answer.hpp"
#include "io/sweep.hpp"

/// `--dry-run`: what a call would do, without doing it.
namespace bioprint {

struct PlannedWork {
    const Sweep& sweep;
    std::optional<std::string> batch;  ///< its file; "-" is standard input, which is not read
    std::optional<SimulationQuestion> simulation;
    std::optional<Format> format;  ///< as asked for
    const RunOptions& options;
};

struct Plan {
    std::string text;      ///< a line each for rows, model, time and memory; or JSON
    std::string short_of;  ///< what --tolerance or --budget asks for and is not to be had
};

/// Everything that would refuse the call is checked. The time of rows is that of some of them, answered and thrown away;
/// that of a simulation follows from its lattice and steps.
/// @throws DataError, UsageError, NoSteadyFlow  as the call would
Plan dry_run(const PlannedWork& work);

}  // namespace bioprint
