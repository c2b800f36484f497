#include <algorithm>
#include <cmath>

#include "bioprint/io/number_format.hpp"
#include "io/ladder_answer.hpp"

namespace bioprint {
namespace {

/// As in the tables of README and manual: whole per cents from ten on.
std::string percent(double error) {
    return percent_text(error, error < 1.0 ? 2 : 3);
}

std::string duration(const std::optional<double>& time) {
    if (!time) return "not known";
    const LabNumber n = format_lab(*time, Dimension::time, 2);
    return n.number + " " + n.unit;
}

/// The largest error measured, also where it is not that of every question: "5.3 % (4 of 5 judged)".
std::string measured_error(const LadderAnswer& answer, const RungVerdict& v) {
    if (!answer.request.measured || v.record == nullptr) return "not known";
    const RungRecord& r = *v.record;
    const std::string all = std::to_string(r.questions);
    if (r.unanswered > 0)
        return percent(r.error) + " (" + std::to_string(r.unanswered) + " of " + all + " unanswered)";
    if (r.unjudged > 0)
        return percent(r.error) + " (" + std::to_string(r.questions - r.unjudged) + " of " + all + " judged)";
    return percent(r.error);
}

Json number(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::string softness(double load) {
    if (load < 0.1) return "stiff";
    return load < 1.0 ? "moderately soft" : "soft";
}

const RungVerdict& chosen_of(const LadderAnswer& answer) {
    return *std::find_if(answer.choice.ladder.begin(), answer.choice.ladder.end(),
                         [&](const auto& v) { return v.rung == answer.choice.rung; });
}

/// "5 % and 10 s", what was asked for.
std::string wanted(const RungRequest& request) {
    std::string text = request.tolerance ? percent(*request.tolerance) : "";
    if (request.tolerance && request.budget) text += " and ";
    if (request.budget) text += duration(request.budget);
    return text;
}

std::string_view plural(const RungRequest& request) {
    return request.simulated ? "simulation" : "model";
}

std::string of_chosen(const LadderAnswer& answer, const RungVerdict& chosen) {
    const RungRequest& request = answer.request;
    const std::string what(plural(request));
    if (request.budget && !chosen.affordable)
        return ", not within " + duration(request.budget) + " but the cheapest " + what + " there is, " +
               duration(chosen.time);
    if (answer.choice.met && request.tolerance) return ", the cheapest within " + wanted(request);
    if (request.tolerance) {
        const std::string within =
            request.budget ? "within " + duration(request.budget) + " that can follow this question"
                           : "that can follow this question";
        if (chosen.error)
            return ", the least of the " + what + "s " + within + "; it is not within " +
                   percent(*request.tolerance);
        return "; nor is that of any other " + what + " " + within;
    }
    if (!request.budget) return "";
    return chosen.error ? ", the most accurate within " + duration(request.budget)
                        : "; no " + what + " of known error is within " + duration(request.budget);
}

std::string of_next(const LadderAnswer& answer, const RungVerdict& chosen) {
    for (const RungVerdict& v : answer.choice.ladder) {
        if (v.rung <= chosen.rung || !v.refused.empty() || !v.error) continue;
        if (chosen.error && *v.error >= *chosen.error) continue;
        return ". Next: " + std::string(name_of(v.rung)) + ", " + percent(*v.error) + " in " +
               duration(v.time);
    }
    return "";
}

/// Why a run whose own error is within the tolerance is not taken for that.
std::string doubt(const LadderAnswer& answer) {
    const RungVerdict& chosen = chosen_of(answer);
    const double tolerance = answer.request.tolerance.value_or(0.0);
    if (chosen.error && *chosen.error > tolerance)
        return "such runs were off by up to " + percent(*chosen.error) + " on questions like this one";
    return "the cell was still being drawn out, of which no error is known";
}

std::string of_run(const LadderAnswer& answer) {
    const RefinedRun& run = *answer.run;
    const double tolerance = answer.request.tolerance.value_or(0.0);
    const bool within = run.error <= tolerance;
    std::string text = std::string(name_of(answer.choice.rung)) + ": the run's own numerical error " +
                       percent(run.error) +
                       (run.refined ? within ? ", refined until within " : ", refined and still not within "
                        : within    ? ", within "
                                    : ", not within ") +
                       percent(tolerance);
    if (within && !run.within) text += ", but " + doubt(answer);
    return text;
}

std::string reason(const LadderAnswer& answer) {
    const RungVerdict& chosen = chosen_of(answer);
    if (!chosen.refused.empty()) return std::string(name_of(chosen.rung)) + ": cannot follow this question";
    if (answer.run) return of_run(answer) + (answer.run->stop.empty() ? "" : "; " + answer.run->stop);
    return std::string(name_of(chosen.rung)) + ": measured error " +
           (chosen.error ? percent(*chosen.error) : "not known") + of_chosen(answer, chosen) +
           of_next(answer, chosen);
}

constexpr std::string_view outside =
    "The question is outside what was measured: Cross inks, α to 0.75, K u/R to 50, R_c/R to 0.2, no cell "
    "in reach of "
    "the wall, inner viscosity that of the ink";

/// Every refusal once, with the models it stops.
std::vector<std::string> refusals(const LadderAnswer& answer) {
    std::vector<std::pair<std::string, std::string>> found;  // refusal, models
    for (const RungVerdict& v : answer.choice.ladder) {
        if (v.refused.empty()) continue;
        if (!found.empty() && found.back().first == v.refused) {
            found.back().second += ", " + std::string(name_of(v.rung));
        } else {
            found.emplace_back(v.refused, std::string(name_of(v.rung)));
        }
    }
    std::vector<std::string> lines;
    lines.reserve(found.size());
    for (const auto& [why, models] : found)
        lines.push_back(std::string(models).append(" cannot: ").append(why));
    return lines;
}

}  // namespace

std::optional<Warning> shortfall(const LadderAnswer& answer) {
    const RungRequest& request = answer.request;
    if (answer.choice.met || (!request.tolerance && !request.budget)) return std::nullopt;
    const RungVerdict& chosen = chosen_of(answer);
    const std::string name(name_of(chosen.rung));
    if (request.budget && !chosen.affordable) {
        return Warning{.code = "budget_not_met",
                       .message = "--budget: no " + std::string(plural(request)) + " is within " +
                                  duration(request.budget) + "; the cheapest is taken, " + name +
                                  ", which takes up to " + duration(chosen.time)};
    }
    if (answer.run) {
        return Warning{
            .code = "tolerance_not_met",
            .message = "--tolerance: the finest run it tries has a numerical error of " +
                       percent(answer.run->error) +
                       (answer.run->error <= request.tolerance.value_or(0.0)
                            ? " and is not within the " + percent(request.tolerance.value_or(0.0)) +
                                  " asked for, for " + doubt(answer)
                            : ", more than the " + percent(request.tolerance.value_or(0.0)) + " asked for") +
                       "; " + (answer.run->stop.empty() ? "--resolution goes further" : answer.run->stop)};
    }
    return Warning{.code = "tolerance_not_met",
                   .message = "--tolerance: no " + std::string(plural(request)) +
                              " that can follow this question was measured to be within " + wanted(request) +
                              "; the best that is left is taken, " + name + ", measured error " +
                              (chosen.error ? percent(*chosen.error) : "not known")};
}

Json ladder_object(const LadderAnswer& answer) {
    Json rungs = Json::array();
    for (const RungVerdict& v : answer.choice.ladder) {
        const bool known = answer.request.measured && v.record != nullptr;
        rungs.push_back({{"model", name_of(v.rung)},
                         {"error", number(v.error)},
                         {"largest_error", known ? number(v.record->error) : Json(nullptr)},
                         {"questions", known ? v.record->questions : 0},
                         {"answered", known ? v.record->questions - v.record->unanswered : 0},
                         {"judged", known ? v.record->questions - v.record->unjudged : 0},
                         {"time", number(v.time)},
                         {"accurate", v.accurate},
                         {"affordable", v.affordable},
                         {"refused", v.refused.empty() ? Json(nullptr) : Json(v.refused)}});
    }
    return {{"question", name_of(answer.request.kind)},
            {"load", number(answer.request.load)},
            {"measured", answer.request.measured},
            {"tolerance", number(answer.request.tolerance)},
            {"budget", number(answer.request.budget)},
            {"model", name_of(answer.choice.rung)},
            {"met", answer.choice.met},
            {"reason", reason(answer)},
            {"models", std::move(rungs)}};
}

std::string ladder_section(const LadderAnswer& answer, TableStyle style) {
    std::vector<std::vector<std::string>> rows = {{"model", "largest error measured", "time, at most", ""}};
    for (const RungVerdict& v : answer.choice.ladder) {
        rows.push_back({std::string(name_of(v.rung)), measured_error(answer, v), duration(v.time),
                        v.rung == answer.choice.rung ? "← taken"
                        : v.refused.empty()          ? ""
                                                     : "cannot follow it"});
    }
    const std::string question = "Models for " + std::string(name_of(answer.request.kind)) + ", a " +
                                 softness(answer.request.load) + " cell";
    std::string text = "\n" + table_heading(question, style) + table_grid(rows, 1) + "  " +
                       table_wrapped(reason(answer), 2) + "\n";
    if (!answer.request.measured) text += "  " + table_wrapped(outside, 2) + "\n";
    for (const std::string& line : refusals(answer)) text += "  " + table_wrapped(line, 2) + "\n";
    return text;
}

}  // namespace bioprint
