#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/predict/prediction.hpp"

/// The one place that knows the shape of an answer. JSON, CSV, `--get` and the schema's tests all start from
/// it.
namespace bioprint {

using Json = nlohmann::ordered_json;

Json answer_object(const Prediction& prediction);

/// JSON text; bytes of the user's that are no UTF-8 become replacement characters.
std::string json_text(const Json& value, int indent = -1);

/// What stands in place of an answer where a row has none: why, and which option or column is at fault.
struct Refusal {
    std::string code;  ///< "usage", "no_steady_flow", "data", "not_converged" or "internal"
    std::string message;
    std::string option;
};
Json refusal_object(const Refusal& refusal);

/// Sorts the error family into a refusal; call inside a catch block.
Refusal current_refusal();

/// The value at a dotted path such as `cells.0.stress.von_mises`.
/// @throws UsageError  naming `option`, the longest part that exists and what it offers
const Json& value_at(const Json& answer, std::string_view path, std::string_view option = "--get");

/// The SI unit of the number at a dotted path, "Pa/m"; empty for pure numbers and texts.
std::string_view unit_of(std::string_view path);

}  // namespace bioprint
