#include "io/answer_checks.hpp"

#include <cmath>

#include "bioprint/errors.hpp"
#include "io/answer_path.hpp"
#include "io/uncertainty.hpp"

namespace bioprint {

namespace {

/// None where other answers have a number and this one does not.
/// Returned, not assigned inside the `try`: there GCC 12 leaves what it replaces uninitialised when nothing
/// replaces it.
std::optional<double> value_for(const Check& check, const Json& answer, std::string_view option,
                                bool strict) {
    try {
        return number_at(answer, check.path, option);
    } catch (const UsageError&) {
        if (strict || !is_known_path(check.path)) throw;
        return std::nullopt;
    }
}

/// Whether a path without a value leads into a cell that has its stress.
bool of_answered_cell(const Json& answer, std::string_view path) {
    const std::string real = json_path(answer, path);
    if (!real.starts_with("cells.")) return false;
    const std::string cell = real.substr(0, real.find('.', 6));
    const Json* const stress = value_if_any(answer, cell + ".stress.von_mises");
    return stress != nullptr && stress->is_number() && !path.ends_with("error");
}

}  // namespace

CheckResult evaluate(const Check& check, const Json& answer, std::string_view option, bool strict) {
    CheckResult result{.value = value_for(check, answer, option, strict), .margin = std::nullopt};
    if (!result.value) {
        result.foreign = of_answered_cell(answer, check.path);
        return result;
    }
    const double value = *result.value;
    switch (check.relation) {
        case Relation::less:
            result.holds = value < check.limit;
            break;
        case Relation::at_most:
            result.holds = value <= check.limit;
            break;
        case Relation::greater:
            result.holds = value > check.limit;
            break;
        case Relation::at_least:
            result.holds = value >= check.limit;
            break;
    }
    const double margin = is_upper(check.relation) ? check.limit - value : value - check.limit;
    if (std::isfinite(margin)) result.margin = margin;
    return result;
}

Json checks_array(const std::vector<Check>& checks, const std::vector<CheckResult>& results) {
    const auto number = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    Json list = Json::array();
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const CheckResult& result = results.at(i);
        Json entry = Json::object();
        entry["path"] = checks[i].path;
        entry["relation"] = symbol(checks[i].relation);
        entry["limit"] = checks[i].limit;
        entry["value"] = number(result.value);
        entry["margin"] = number(result.margin);
        entry["relative_margin"] = result.margin && checks[i].limit != 0.0
                                       ? Json(*result.margin / std::abs(checks[i].limit))
                                       : Json(nullptr);
        entry["holds"] = result.holds;
        list.push_back(std::move(entry));
    }
    return list;
}

void add_spread(Json& answer, const Settings& settings, const Extras& extras, unsigned jobs) {
    // Among many rows one may have no spread of its own; then it has none, which is no mistake.
    if (extras.uncertainty.presets || settings.has_deviation()) {
        add_uncertainty(answer, settings, extras.uncertainty, jobs);
    }
}

ExtraResults add_checks(Json& answer, const Extras& extras, bool strict) {
    ExtraResults results;
    if (extras.checks.empty()) return results;
    for (const Check& check : extras.checks) {
        results.checks.push_back(evaluate(check, answer, "--check", strict));
    }
    answer["checks"] = checks_array(extras.checks, results.checks);
    return results;
}

ExtraResults add_extras(Json& answer, const Settings& settings, const Extras& extras, unsigned jobs,
                        bool strict) {
    add_spread(answer, settings, extras, jobs);
    return add_checks(answer, extras, strict);
}

std::string extras_sections(const Json& answer, const Extras& extras, const ExtraResults& results,
                            TableStyle style) {
    std::string text;
    if (answer.contains("uncertainty")) text += uncertainty_section(answer, style);
    if (!extras.checks.empty()) text += checks_section(extras.checks, results.checks, style);
    return text;
}

}  // namespace bioprint
