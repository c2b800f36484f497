#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/settings.hpp"

namespace CLI {
class App;
}

/// What is wrong with a call, beyond what a single option knows.
namespace bioprint {

/// What was typed and belongs to no option: named, with the option that was probably meant.
/// @param extras   in the order typed; what follows an unknown option without a dash is taken for its value
/// @param options  the long names there are, "--radius", …
/// @param help     where to read on: "bioprint-predict --help"
void add_extra_arguments(std::span<const std::string> extras, std::span<const std::string> options,
                         const std::string& help, Problems& problems);

/// Of an option that takes one value and is given twice the last is read, so that the rest of the call is judged too.
/// Before the options are added.
void take_last_of_repeated(CLI::App& app);
/// Then says which ones were.
void add_repeated_options(const CLI::App& app, Problems& problems);

/// For a call that is refused anyway: values that could be read and are out of their range, so that all is told at once.
/// What only other options make wrong waits until those can be read.
void add_range_problems(const Settings& settings, Problems& problems);

}  // namespace bioprint
