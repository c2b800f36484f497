#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/answer_object.hpp"
#include "io/fit_answer.hpp"
#include "io/number_columns.hpp"
#include "io/row_answer.hpp"

namespace bioprint {
namespace {

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

std::string law_title(const LawChoice& choice) {
    return std::string(law_name(choice.law));
}

Json parameter_object(const FittedParameter& p) {
    return {{"value", number(p.value)},
            {"unit", fit_unit(p.name)},
            {"standard_error", number(p.standard_error)},
            {"low", p.determined ? number(p.low) : Json(nullptr)},
            {"high", p.determined ? number(p.high) : Json(nullptr)},
            {"determined", p.determined}};
}

Json correlation_rows(const LawFit& fit) {
    Json matrix = Json::array();
    const std::size_t n = fit.parameters.size();
    for (std::size_t i = 0; i < n; ++i) {
        Json row = Json::array();
        for (std::size_t j = 0; j < n; ++j) row.push_back(number(fit.correlation[i * n + j]));
        matrix.push_back(std::move(row));
    }
    return matrix;
}

Json law_object(const LawFit& fit, double best_aicc) {
    Json parameters = Json::object();
    Json names = Json::array();
    for (const FittedParameter& p : fit.parameters) {
        parameters[std::string(p.name)] = parameter_object(p);
        names.push_back(p.name);
    }
    return {{"law", law_title(fit.choice)},
            {"eta_inf", number(fit.eta_inf)},
            {"eta_inf_fitted", fit.choice.fit_eta_inf},
            {"parameters", std::move(parameters)},
            {"correlation", {{"names", std::move(names)}, {"matrix", correlation_rows(fit)}}},
            {"scatter", number(fit.scatter)},
            {"aic", number(fit.aic)},
            {"aicc", fit.aicc ? number(*fit.aicc) : Json(nullptr)},
            {"delta_aicc", fit.aicc ? number(*fit.aicc - best_aicc) : Json(nullptr)},
            {"neighbour_correlation", number(fit.neighbour_correlation)},
            {"converged", fit.converged}};
}

Json data_object(const FitAnswer& answer) {
    const RheometerData& data = answer.data;
    Json intervals = Json::array();
    for (const RheometerInterval& interval : data.intervals) {
        intervals.push_back({{"name", interval.name},
                             {"line", interval.line},
                             {"rows", interval.rows},
                             {"points", interval.points},
                             {"rate_column", interval.rate},
                             {"viscosity_column", interval.viscosity},
                             {"used", interval.skipped.empty()},
                             {"skipped", interval.skipped.empty() ? Json(nullptr) : Json(interval.skipped)}});
    }
    Json dropped = Json::array();
    for (const DroppedRows& rows : data.dropped) {
        dropped.push_back({{"reason", rows.reason}, {"count", rows.count}, {"first_line", rows.first_line}});
    }
    const auto outliers = static_cast<std::size_t>(
        std::count_if(answer.points.begin(), answer.points.end(), [](const FitPoint& p) { return !p.used; }));
    return {{"file", data.file},
            {"encoding", data.encoding},
            {"separator", separator_name(data.separator)},
            {"decimal_mark", data.decimal_comma ? "," : "."},
            {"intervals", std::move(intervals)},
            {"dropped", std::move(dropped)},
            {"points", answer.points.size()},
            {"points_used", answer.fit.points_used},
            {"outliers", outliers},
            {"shear_rate_min", number(answer.rate_low)},
            {"shear_rate_max", number(answer.rate_high)},
            {"temperature", answer.temperature ? number(*answer.temperature) : Json(nullptr)}};
}

Json points_object(const FitAnswer& answer) {
    Json columns = {{"shear_rate", Json::array()}, {"viscosity", Json::array()}, {"fitted", Json::array()},
                    {"residual", Json::array()},   {"used", Json::array()},      {"line", Json::array()},
                    {"interval", Json::array()}};
    for (const FitPoint& p : answer.points) {
        columns["shear_rate"].push_back(number(p.rate));
        columns["viscosity"].push_back(number(p.measured));
        columns["fitted"].push_back(number(p.fitted));
        columns["residual"].push_back(number(p.residual()));
        columns["used"].push_back(p.used);
        columns["line"].push_back(p.line);
        columns["interval"].push_back(p.interval);
    }
    return columns;
}

Json preset_value(double value, const std::optional<double>& error, std::string_view unit) {
    Json entry = {{"value", fit_rounded(value)}, {"unit", unit}};
    if (error && std::isfinite(*error)) entry["sd"] = fit_rounded(*error);
    return entry;
}

/// A Newtonian fluid as the Cross law has it: alpha 0, whose viscosity is half of eta0.
Json newtonian_parameters(const FittedParameter& eta) {
    return {{"eta0", preset_value(2.0 * eta.value, 2.0 * eta.standard_error, "Pa.s")},
            {"time_constant", preset_value(1.0, 0.0, "s")},
            {"alpha", preset_value(0.0, 0.0, "1")}};
}

Json preset_parameters(const LawFit& fit) {
    if (fit.choice.law == FittedLaw::newtonian) return newtonian_parameters(fit.parameters.front());
    Json parameters = Json::object();
    for (const FittedParameter& p : fit.parameters) {
        Json& entry = parameters[std::string(p.name)];
        entry = preset_value(p.value, p.standard_error, fit_unit(p.name));
        if (!p.determined) entry["determined"] = false;
    }
    if (!fit.choice.fit_eta_inf && fit.eta_inf > 0.0) {
        parameters["eta_inf"] = preset_value(fit.eta_inf, {}, "Pa.s");
    }
    return parameters;
}

std::string preset_note(const FitAnswer& answer) {
    std::string note = "relative scatter of the points " +
                       format_lab(100.0 * answer.chosen.scatter, Dimension::dimensionless, 2).number + " %";
    if (answer.chosen.choice.law == FittedLaw::newtonian) note += "; Newtonian: alpha 0 gives half of eta0";
    for (const Warning& warning : answer.warnings) {
        if (warning.code != "data") note += ". " + warning.message;
    }
    return note;
}

Json fit_preset(const FitAnswer& answer) {
    Json preset = {{"name", answer.name},
                   {"aliases", Json::array()},
                   {"material", answer.name},
                   {"composition", "not given"},
                   {"temperature", nullptr}};
    if (answer.temperature)
        preset["temperature"] = {{"value", fit_rounded(*answer.temperature, 4)}, {"unit", "degC"}};
    const FittedLaw law = answer.chosen.choice.law;
    if (law != FittedLaw::cross && law != FittedLaw::newtonian) preset["law"] = law_name(law);
    preset["parameters"] = preset_parameters(answer.chosen);
    if (const LawFit& fit = answer.chosen; fit.parameters.size() > 1) {
        Json names = Json::array();
        for (const FittedParameter& p : fit.parameters) names.push_back(p.name);
        // Every digit: of parameters that hardly differ in what they do, the last ones count.
        preset["correlation"] = {{"parameters", std::move(names)}, {"matrix", correlation_rows(fit)}};
    }
    preset["shear_rate_range"] = {
        {"min", fit_rounded(answer.rate_low)}, {"max", fit_rounded(answer.rate_high)}, {"unit", "1/s"}};
    const bool all = std::all_of(answer.chosen.parameters.begin(), answer.chosen.parameters.end(),
                                 [](const FittedParameter& p) { return p.determined; });
    preset["grade"] = all ? "A" : "B";
    preset["source"] = answer.source;
    preset["note"] = preset_note(answer);
    return preset;
}

Json fit_object(const FitAnswer& answer) {
    const LawFit& best = answer.fit.laws.front();
    const double best_aicc = best.aicc.value_or(0.0);
    Json laws = Json::array();
    for (const LawFit& law : answer.fit.laws) laws.push_back(law_object(law, best_aicc));
    Json warnings = Json::array();
    for (const Warning& warning : answer.warnings) {
        warnings.push_back({{"code", warning.code}, {"message", warning.message}});
    }
    return {{"schema", fit_schema_name},
            {"program", {{"name", program_name}, {"version", program_version()}}},
            {"data", data_object(answer)},
            {"fit", law_object(answer.chosen, best_aicc)},
            {"laws", std::move(laws)},
            {"points", points_object(answer)},
            {"options", fit_options_line(answer)},
            {"preset", fit_preset(answer)},
            {"warnings", std::move(warnings)}};
}

}  // namespace

std::string fit_json_text(const FitAnswer& answer) {
    return json_text(fit_object(answer), 2) + "\n";
}

std::string fit_preset_text(const FitAnswer& answer) {
    return json_text(fit_preset(answer), 2) + "\n";
}

std::string fit_values_text(const FitAnswer& answer, const std::vector<std::string>& paths) {
    const Json object = fit_object(answer);
    std::string text;
    for (const std::string& path : paths) text += value_text(value_at(object, path)) + "\n";
    return text;
}

}  // namespace bioprint
