#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bioprint/io/presets.hpp"

/// The JSON of presets. Errors are UsageErrors that name the text and the field: "my-ink.json:
/// inks.0.eta0.unit: …".
namespace bioprint {

InkPreset read_ink_text(std::string_view json, const std::string& what);
CellPreset read_cell_text(std::string_view json, const std::string& what);
NozzlePreset read_nozzle_text(std::string_view json, const std::string& what);

/// One ink: the object itself, or the only one of an `inks` list.
InkPreset read_single_ink(std::string_view json, const std::string& what);

}  // namespace bioprint
