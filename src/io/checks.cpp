#include "io/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/answer_path.hpp"
#include "io/settings.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

/// "310 Pa (15.5 %) above": where a value stands that has no business there, or how much room it leaves.
std::string distance(const Check& check, const CheckResult& result) {
    const double margin = *result.margin;
    std::string text = lab_text(std::abs(margin), check.dimension);
    if (check.limit != 0.0) text += " (" + percent_text(std::abs(margin / check.limit), 3) + ")";
    if (margin == 0.0) return "exactly the limit";
    return text + ((margin < 0.0) == is_upper(check.relation) ? " above" : " below");
}

std::string no_value(const Check& check, const CheckResult& result) {
    if (result.foreign) return "this value does not exist for a cell at that place, by its model";
    if (check.path == "nozzle.pressure_drop" || check.path == "nozzle.residence_time" ||
        check.path.starts_with("population.exposure")) {
        return "there is no value; give the nozzle's --length";
    }
    return "there is no value; the answer's warnings say why";
}

/// Refuses a path that leads nowhere in an answer; parts that only some answers have may hold what it names.
void require_place(std::string_view path, std::string_view option) {
    const std::string_view first = path.substr(0, path.find('.'));
    static constexpr std::array<std::string_view, 6> of_some = {"population",  "profile", "simulation",
                                                                "uncertainty", "checks",  "choice"};
    if (std::find(of_some.begin(), of_some.end(), first) != of_some.end()) return;
    const Json answer = answer_object(predict(Settings{}.make_case()));
    if (value_if_any(answer, path, option) != nullptr) (void)number_at(answer, path, option);
}

}  // namespace

std::string_view symbol(Relation relation) {
    switch (relation) {
        case Relation::less:
            return "<";
        case Relation::at_most:
            return "<=";
        case Relation::greater:
            return ">";
        case Relation::at_least:
            return ">=";
    }
    return "";
}

bool is_upper(Relation relation) {
    return relation == Relation::less || relation == Relation::at_most;
}

Check parse_check(std::string_view text, std::string_view option) {
    const std::string name(option);
    const std::size_t at = text.find_first_of("<>");
    const std::string form = "; it takes a path, <, <=, > or >=, and a limit, such as nozzle.stress_max<2kPa";
    if (at == std::string_view::npos)
        throw UsageError(name + ": got " + in_quotes(text) + ", which compares nothing" + form, name);
    const bool equal = text.substr(at + 1).starts_with('=');
    Check check{.text = std::string(trimmed(text)),
                .path = std::string(trimmed(text.substr(0, at))),
                .relation = text[at] == '<' ? (equal ? Relation::at_most : Relation::less)
                                            : (equal ? Relation::at_least : Relation::greater),
                .limit = 0.0,
                .dimension = Dimension::dimensionless};
    if (check.path.empty())
        throw UsageError(name + ": got " + in_quotes(text) + ", without a path" + form, name);
    check.dimension = dimension_at(check.path);
    const std::string_view quantity = trimmed(text.substr(at + (equal ? 2 : 1)));
    if (is_known_path(quantity) && !is_known_path(check.path)) {
        const std::string turned = text[at] == '<' ? ">" : "<";
        throw UsageError(name + ": got " + in_quotes(text) + "; the path stands on the left: '" +
                             std::string(quantity) + turned + (equal ? "=" : "") + check.path + "'",
                         name);
    }
    try {
        check.limit = parse_quantity(quantity, check.dimension, name + " " + check.path);
    } catch (const UsageError&) {
        // A path that is mistaken has no unit, and it is the path that has to be mended.
        require_place(check.path, name);
        throw;
    }
    return check;
}

bool needs_population(const std::vector<Check>& checks) {
    return std::any_of(checks.begin(), checks.end(),
                       [](const Check& check) { return needs_population(check.path); });
}

std::vector<CheckResult> unanswered(const std::vector<Check>& checks) {
    return std::vector<CheckResult>(checks.size());
}

std::string sentence(const Check& check, const CheckResult& result) {
    const std::string begin = check.text + (result.holds ? " holds: " : " does not hold: ");
    if (!result.value) return begin + no_value(check, result);
    std::string text = begin + lab_text(*result.value, check.dimension);
    if (result.margin) text += ", " + distance(check, result);
    return text;
}

std::string checks_section(const std::vector<Check>& checks, const std::vector<CheckResult>& results,
                           TableStyle style) {
    std::vector<std::vector<std::string>> rows = {{"", "limit", "value", "margin", ""}};
    for (std::size_t i = 0; i < checks.size(); ++i) {
        const Check& check = checks[i];
        const CheckResult& result = results.at(i);
        std::string margin = "–";
        if (result.margin) {
            margin = check.limit != 0.0 ? (*result.margin < 0.0 ? "-" : "") +
                                              percent_text(std::abs(*result.margin / check.limit), 3)
                                        : lab_text(*result.margin, check.dimension);
        }
        rows.push_back({check.path,
                        std::string(symbol(check.relation)) + " " + lab_text(check.limit, check.dimension),
                        result.value ? lab_text(*result.value, check.dimension) : "no value", margin,
                        result.holds ? "holds" : "DOES NOT HOLD"});
    }
    return "\n" + table_heading("Checks", style) + table_grid(rows, 1);
}

std::string verdict(const std::vector<CheckResult>& results) {
    if (results.empty()) return {};
    const bool all =
        std::all_of(results.begin(), results.end(), [](const auto& result) { return result.holds; });
    return all ? "hold" : "FAIL";
}

void CheckTally::add(const std::vector<CheckResult>& results) {
    for (std::size_t i = 0; i < worst_.size(); ++i) {
        const CheckResult& result = results.at(i);
        if (result.holds) continue;
        Worst& worst = worst_[i];
        ++worst.failures;
        worst.valueless += result.value ? 0 : 1;
        const bool first_value = result.margin && !worst.result.margin;
        if (worst.failures == 1 || first_value || (result.margin && *result.margin < *worst.result.margin)) {
            worst.result = result;
            worst.row = rows_;
        }
    }
    ++rows_;
}

bool CheckTally::all_hold() const {
    return std::all_of(worst_.begin(), worst_.end(), [](const Worst& worst) { return worst.failures == 0; });
}

std::vector<std::string> CheckTally::lines() const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < worst_.size(); ++i) {
        const Worst& worst = worst_[i];
        const Check& check = (*checks_)[i];
        if (worst.failures == 0) continue;
        if (rows_ == 1) {
            lines.push_back("--check: " + sentence(check, worst.result));
            continue;
        }
        std::string line = "--check: " + check.text + " does not hold in " + std::to_string(worst.failures) +
                           " of " + std::to_string(rows_) + " rows";
        if (worst.result.value) {
            line += "; the worst is row " + std::to_string(worst.row + 1) + ": " +
                    lab_text(*worst.result.value, check.dimension) + ", " + distance(check, worst.result);
        }
        if (worst.valueless > 0) line += "; no value in " + std::to_string(worst.valueless) + " of them";
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace bioprint
