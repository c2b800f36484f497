#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// Validation against the JSON Schemas of data/schema (draft 7).
namespace bioprint::testing {

/// Empty when `document` is valid under the schema `name` ("answer", "inks", …), else every violation with
/// its place.
std::string schema_violations(const nlohmann::json& document, const std::string& name);

}  // namespace bioprint::testing
