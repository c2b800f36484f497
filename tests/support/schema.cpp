#include "support/schema.hpp"

#include <fstream>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace bioprint::testing {

std::string schema_violations(const nlohmann::json& document, const std::string& name) {
    using Adapter = valijson::adapters::NlohmannJsonAdapter;
    const std::string path = std::string(BIOPRINT_SOURCE_DIR) + "/data/schema/" + name + ".schema.json";
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    const auto schema_json = nlohmann::json::parse(file);
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(Adapter(schema_json), schema);
    valijson::ValidationResults results;
    valijson::Validator validator;
    if (validator.validate(schema, Adapter(document), &results)) return {};
    std::string violations;
    for (valijson::ValidationResults::Error error; results.popError(error);) {
        for (const auto& step : error.context) violations += step;
        violations += ": " + error.description + "\n";
    }
    return violations.empty() ? "invalid" : violations;
}

}  // namespace bioprint::testing
