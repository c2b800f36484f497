#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/arguments.hpp"

/// `--out`, `--resume` and what goes with them.
namespace bioprint {

struct RawLongRun {
    std::optional<std::string> out;
    std::optional<std::string> resume;
    std::optional<std::string> interval;
};

void add_long_run_options(CLI::App& app, RawLongRun& raw);

/// The options of the question in the order typed: all but those about this call alone, such as `--jobs`.
TypedQuestion typed_question(const CLI::App& app);

/// Checks what was typed; leaves it in `arguments.long_run`.
void collect_long_run(const RawLongRun& raw, Arguments& arguments, Problems& problems);

/// The words that ask again what the run in a directory was asked.
/// @param now  options typed beside `--resume`
/// @throws UsageError  one of them differs from what the run was asked
std::vector<std::string> resumed_words(const std::string& directory, const TypedQuestion& now);

/// The resumed question `then`, with what this call says about itself.
Arguments with_call(Arguments then, const Arguments& now);

}  // namespace bioprint
