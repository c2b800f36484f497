#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/answer_object.hpp"
#include "io/extras.hpp"
#include "io/settings.hpp"

/// Checks and an answer brought together.
namespace bioprint {

/// @param option  whose check it is, for messages
/// @param strict  a place this answer does not have is a mistake of the call, not a missing value
/// @throws UsageError  no such place, or no number there
CheckResult evaluate(const Check& check, const Json& answer, std::string_view option, bool strict);

/// The answer's `checks`.
Json checks_array(const std::vector<Check>& checks, const std::vector<CheckResult>& results);

/// Adds `uncertainty` to an answer where it is wanted or an input was given with its spread.
/// @param settings  what the answer was asked with
/// @param jobs      threads
/// @throws UsageError  nothing is uncertain
void add_spread(Json& answer, const Settings& settings, const Extras& extras, unsigned jobs);

/// Adds `checks` to an answer.
/// @param strict  as evaluate()
/// @throws UsageError  a check at a place that the answer does not have
ExtraResults add_checks(Json& answer, const Extras& extras, bool strict);

/// Both.
ExtraResults add_extras(Json& answer, const Settings& settings, const Extras& extras, unsigned jobs,
                        bool strict);

/// Sections of a table.
std::string extras_sections(const Json& answer, const Extras& extras, const ExtraResults& results,
                            TableStyle style);

}  // namespace bioprint
