#pragma once

#include <string_view>
#include <vector>

#include "io/answer_object.hpp"
#include "io/extras.hpp"

/// Checks and an answer brought together.
namespace bioprint {

/// @param option  whose check it is, for messages
/// @param strict  a place this answer does not have is a mistake of the call, not a missing value
/// @throws UsageError  no such place, or no number there
CheckResult evaluate(const Check& check, const Json& answer, std::string_view option, bool strict);

/// The answer's `checks`.
Json checks_array(const std::vector<Check>& checks, const std::vector<CheckResult>& results);

/// Adds to an answer what was asked beyond the prediction.
/// @param strict  as evaluate()
/// @throws UsageError  a check at a place that the answer does not have
ExtraResults add_extras(Json& answer, const Extras& extras, bool strict);

}  // namespace bioprint
