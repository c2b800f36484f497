#pragma once

#include "bioprint/io/presets.hpp"
#include "io/settings.hpp"

/// The ink a user meant: a preset or a law, with single parameters given over it.
namespace bioprint {

/// @throws UsageError  an unknown preset or law, a parameter that the law has not, or one that it misses
/// @throws DataError   a preset file that cannot be read
InkChoice ink_choice(const Settings& settings);

/// The preset behind the ink; none where a law of the user's own starts from nothing.
/// @throws as ink_choice
const InkPreset* ink_preset(const Settings& settings);

}  // namespace bioprint
