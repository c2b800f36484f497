#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/arguments.hpp"

/// The options that draw, report, split and fill workbooks.
namespace bioprint {

struct RawPictures {
    std::optional<std::string> plot;
    std::optional<std::string> plot_kind;
    std::optional<std::string> report;
    std::optional<std::string> shard;
};

void add_picture_options(CLI::App& app, RawPictures& raw, const std::string& group);

/// @param arguments  with all other options collected
void collect_pictures(const RawPictures& raw, Arguments& arguments, Problems& problems);

}  // namespace bioprint
