#pragma once

#include <string>
#include <string_view>

#include "bioprint/predict/prediction.hpp"

/// The answer as JSON, schema "bioprint-predict/1" (data/schema/answer.schema.json).
///
/// SI units only. A number that does not exist is null and a warning says why; there is never a NaN. Numbers
/// are in their shortest form that reads back to the same double.
namespace bioprint {

inline constexpr std::string_view program_name = "bioprint-predict";
inline constexpr std::string_view schema_name = "bioprint-predict/1";

/// The version of this library, "major.minor.patch".
std::string_view program_version();

/// @param indent  spaces a level; negative: one line
std::string answer_json(const Prediction& prediction, int indent = -1);

/// One question in, one answer out, both as JSON; never throws.
///
/// The question is an object as a line of a JSON Lines batch: keys are option names or paths of the answer's
/// `input`, values are SI numbers or strings with a unit, {"radius": "50um", "flowrate": "141uL/h", "alpha":
/// 0.75}. What is left out has the command's defaults. A question that has no answer gives an object with
/// `error`.
std::string answer_json_line(std::string_view question);

}  // namespace bioprint
