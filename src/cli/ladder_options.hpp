#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/arguments.hpp"

/// `--tolerance`, `--budget`, `--explain` and `--dry-run`.
namespace bioprint {

struct RawLadder {
    std::optional<std::string> tolerance;
    std::optional<std::string> budget;
    bool explain = false;
    bool dry_run = false;
};

void add_ladder_options(CLI::App& app, RawLadder& raw);

/// Checks what was typed; leaves it in `arguments.ladder` and `arguments.dry_run`.
void collect_ladder(const RawLadder& raw, Arguments& arguments, Problems& problems);

/// Climbs the ladder for a question: its model and simulation become those that were chosen.
LadderAnswer take_rung(Arguments& arguments);

}  // namespace bioprint
