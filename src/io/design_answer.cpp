#include "io/design_answer.hpp"

#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/answer_checks.hpp"
#include "io/answer_path.hpp"
#include "io/row_answer.hpp"

namespace bioprint {
namespace {

std::string_view outcome_name(DesignOutcome outcome) {
    switch (outcome) {
        case DesignOutcome::found:
            return "found";
        case DesignOutcome::unlimited:
            return "every value";
        case DesignOutcome::impossible:
            return "no value";
    }
    return "";
}

Json limits_array(const DesignQuestion& question, const Design& design) {
    std::vector<CheckResult> results;
    for (const LimitStand& stand : design.limits) results.push_back(stand.result);
    Json list = checks_array(question.limits, results);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i]["binds"] = design.limits[i].binds;
        list[i]["direction"] = design.limits[i].by_theory ? "theory" : "measured";
        list[i]["monotone"] = design.limits[i].monotone;
    }
    return list;
}

Json design_object(const DesignQuestion& question, const Design& design) {
    Json object;
    object["solve"] = info_of(question.sought).option;
    object["outcome"] = outcome_name(design.outcome);
    object["value"] = design.value;
    object["side"] = design.largest ? "largest" : "smallest";
    object["kept"] = design.kept ? Json::array({design.kept->first, design.kept->second}) : Json(nullptr);
    object["range"] = Json::array({design.range.first, design.range.second});
    object["beyond"] = design.beyond ? Json(*design.beyond) : Json(nullptr);
    object["steady_flow_binds"] = design.steady_flow_binds;
    object["limits"] = limits_array(question, design);
    object["evaluations"] = design.evaluations;
    return object;
}

std::string headline(const DesignQuestion& question, const Design& design) {
    const KeyInfo& info = info_of(question.sought);
    const std::string name(info.option);
    const auto text = [&](double value) { return lab_text(value, *info.dimension); };
    const std::string range = text(design.range.first) + " to " + text(design.range.second);
    const std::string side = design.largest ? "largest" : "smallest";
    const bool monotone = std::all_of(design.limits.begin(), design.limits.end(),
                                      [](const LimitStand& limit) { return limit.monotone; });
    switch (design.outcome) {
        case DesignOutcome::found:
            return "the " + side + " " + name + (monotone ? "" : " of an interval") +
                   " that keeps the limits is " + text(design.value);
        case DesignOutcome::unlimited:
            return "every " + name + " from " + range + " keeps the limits; the " + side + " is " +
                   text(design.value);
        case DesignOutcome::impossible:
            return "no " + name + (monotone ? "" : " that was tried") + " from " + range +
                   " keeps the limits; the closest is " + text(design.value);
    }
    return "";
}

std::string design_section(const DesignQuestion& question, const Design& design, TableStyle style) {
    std::vector<std::vector<std::string>> rows = {{"", "limit", "value", "margin", ""}};
    for (std::size_t i = 0; i < question.limits.size(); ++i) {
        const Check& limit = question.limits[i];
        const LimitStand& stand = design.limits[i];
        std::string margin = "–";
        if (stand.result.margin && limit.limit != 0.0) {
            margin =
                format_lab(100.0 * *stand.result.margin / std::abs(limit.limit), Dimension::dimensionless, 2)
                    .number +
                " %";
        }
        rows.push_back({limit.path,
                        std::string(symbol(limit.relation)) + " " + lab_text(limit.limit, limit.dimension),
                        stand.result.value ? lab_text(*stand.result.value, limit.dimension) : "no value",
                        margin, !stand.result.holds ? "BROKEN" : (stand.binds ? "binds" : "")});
        // At the limit but for the last digits, the margin is that of the search.
        constexpr double search = 1e-3;
        const bool at_limit = stand.result.margin && *stand.result.margin <= search * std::abs(limit.limit);
        if (stand.binds && stand.result.holds && at_limit) rows.back()[3] = "0";
    }
    std::string text = table_heading("Design: " + headline(question, design), style) + table_grid(rows, 1);
    if (design.kept && design.outcome == DesignOutcome::found) {
        const Dimension dimension = *info_of(question.sought).dimension;
        text += "  kept from " + lab_text(design.kept->first, dimension) + " to " +
                lab_text(design.kept->second, dimension) +
                (design.steady_flow_binds ? "; past it there is no steady flow" : "") + "\n";
    }
    if (!style.quiet) {
        for (const std::string& remark : design.remarks) text += "  - " + remark + "\n";
    }
    return text + "\n";
}

}  // namespace

RunResult answer_design(const DesignQuestion& question, const Settings& base, const RunOptions& options,
                        const Sink& sink, const Sink& notice) {
    if (options.format == Format::csv && options.paths.empty()) {
        throw UsageError("--format: a design is answered as table, json or jsonl", "--format");
    }
    const Design design = solve_design(question, base, options.jobs);
    Case asked = with_value(base, question.sought, design.value).make_case();
    asked.population = asked.population || needs_population(question.limits);
    Prediction prediction = predict(asked, options.jobs);
    for (const std::string& remark : design.remarks) {
        prediction.warnings.push_back({"design_not_monotone", remark});
    }
    Json answer = answer_object(prediction);
    answer["design"] = design_object(question, design);
    const ExtraResults results = add_extras(answer, with_value(base, question.sought, design.value),
                                            options.extras, options.jobs, true);
    if (!options.paths.empty()) {
        for (const std::string& path : options.paths) {
            sink(value_text(value_meant(answer, path)) + "\n");
        }
        for (const Warning& warning : prediction.warnings) notice(warning.message);
    } else if (options.format == Format::table) {
        for (std::size_t i = 0; i < design.remarks.size(); ++i) prediction.warnings.pop_back();
        sink(design_section(question, design, options.style) + answer_table(prediction, options.style) +
             extras_sections(answer, options.extras, results, options.style));
    } else {
        sink(json_text(answer, options.format == Format::json ? 2 : -1) + "\n");
    }
    CheckTally tally(options.extras.checks);
    tally.add(results.checks);
    RunResult result{.rows = 1, .refused = 0, .interrupted = false, .failed_checks = tally.lines()};
    if (design.outcome == DesignOutcome::impossible) {
        result.failed_checks.insert(result.failed_checks.begin(), "design: " + headline(question, design));
        for (std::size_t i = 0; i < question.limits.size(); ++i) {
            if (design.limits[i].result.holds) continue;
            result.failed_checks.push_back("design: " +
                                           sentence(question.limits[i], design.limits[i].result));
        }
    }
    return result;
}

}  // namespace bioprint
