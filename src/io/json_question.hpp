#pragma once

#include <nlohmann/json.hpp>

#include "io/settings.hpp"

/// A question written as a JSON object: option names or paths of the answer's `input`, nested or dotted.
namespace bioprint {

/// @throws UsageError  every problem: a key that is not known, a value of the wrong kind
Settings settings_of(const nlohmann::json& question);

}  // namespace bioprint
