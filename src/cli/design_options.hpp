#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.hpp"

/// The subcommand `design`. It takes the options of a prediction too, before or behind its own.
namespace bioprint {

struct RawDesign {
    std::optional<std::string> sought;
    std::vector<std::string> limits;
    std::optional<std::string> range;
};

CLI::App* add_design(CLI::App& app, RawDesign& raw);
void collect_design(const RawDesign& raw, Arguments& arguments, Problems& problems);

}  // namespace bioprint
