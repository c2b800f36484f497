#pragma once

#include <span>
#include <string_view>

/// The presets of data/, put into the library when it is built: one text each, so that a call which names a
/// preset parses that one alone (parsing them all was 70 % of a query).
namespace bioprint::preset_texts {

struct PresetText {
    std::string_view names;  ///< name and aliases in lower case, each between newlines
    std::string_view json;
};

extern const std::span<const PresetText> inks;
extern const std::span<const PresetText> cells;
extern const std::span<const PresetText> nozzles;

}  // namespace bioprint::preset_texts
