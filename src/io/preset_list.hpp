#pragma once

#include <string>
#include <string_view>

/// What `--list` shows: a preset a line, its name first.
namespace bioprint {

/// @param kind  "inks", "cells" or "nozzles"
/// @throws UsageError  another kind
std::string preset_list(std::string_view kind);

}  // namespace bioprint
