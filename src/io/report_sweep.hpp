#pragma once

#include <string>
#include <string_view>

#include "io/answer_object.hpp"

/// The tables of a report on many rows.
namespace bioprint {

/// The input all rows share, and a table of what changes and what comes of it.
std::string sweep_sections(const Json& answers);

/// A value for a person: numbers in lab units.
std::string spoken_value(const Json& value, std::string_view path);

/// The same for what may be no number, which is a dash.
std::string number_or_dash(const Json& value, std::string_view path);

}  // namespace bioprint
