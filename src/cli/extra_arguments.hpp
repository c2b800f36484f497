#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/settings.hpp"

/// What was typed and belongs to no option: named, with the option that was probably meant.
namespace bioprint {

/// @param extras   in the order typed; what follows an unknown option without a dash is taken for its value
/// @param options  the long names there are, "--radius", …
/// @param help     where to read on: "bioprint-predict --help"
void add_extra_arguments(std::span<const std::string> extras, std::span<const std::string> options,
                         const std::string& help, Problems& problems);

}  // namespace bioprint
