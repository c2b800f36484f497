#include "io/fit_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bioprint/io/number_format.hpp"
#include "io/number_columns.hpp"

namespace bioprint {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string line(const char* name, const std::string& text) {
    std::string head = "  " + std::string(name);
    head.resize(13, ' ');
    return head + table_wrapped(text, 13) + "\n";
}

std::string plural(std::size_t count, const std::string& one, const std::string& many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string data_section(const FitAnswer& answer, TableStyle style) {
    const RheometerData& data = answer.data;
    std::string text = table_heading("Data", style);
    std::string form = data.file + " (" + std::string(data.encoding) + ", " +
                       std::string(separator_name(data.separator)) + "-separated, decimal " +
                       (data.decimal_comma ? "comma" : "point") + ")";
    text += line("file", form);
    for (std::size_t i = 0; i < data.intervals.size(); ++i) {
        const RheometerInterval& interval = data.intervals[i];
        if (data.intervals.size() > 1) {
            std::string words = std::to_string(i + 1);
            if (!interval.name.empty()) words += " (" + interval.name + ")";
            words +=
                ", " + plural(interval.rows, "row", "rows") + " from line " + std::to_string(interval.line);
            if (!interval.skipped.empty()) words += ": left out, " + interval.skipped;
            text += line("interval", words);
        }
        const bool same = i > 0 && interval.rate == data.intervals[i - 1].rate &&
                          interval.viscosity == data.intervals[i - 1].viscosity &&
                          data.intervals[i - 1].skipped.empty();
        if (interval.skipped.empty() && !same)
            text += line("columns", interval.rate + ", " + interval.viscosity);
    }
    std::string points = std::to_string(answer.fit.points_used) + " from " + bare_text(answer.rate_low, 3) +
                         " to " + bare_text(answer.rate_high, 3) + " 1/s";
    if (answer.temperature) points += ", at " + bare_text(*answer.temperature, 3) + " °C";
    text += line("points", points);
    std::vector<std::string> dropped;
    std::string outliers;
    std::size_t count = 0;
    for (const FitPoint& p : answer.points) {
        if (p.used) continue;
        if (++count <= 8) outliers += (count == 1 ? "" : ", ") + std::to_string(p.line);
    }
    if (count > 0) {
        dropped.push_back(plural(count, "outlier (line ", "outliers (lines ") + outliers +
                          (count > 8 ? ", ...)" : ")"));
    }
    for (const DroppedRows& rows : data.dropped) {
        dropped.push_back(plural(rows.count, "row, ", "rows, ") + rows.reason + " (" +
                          (rows.count == 1 ? "line " : "first in line ") + std::to_string(rows.first_line) +
                          ")");
    }
    for (std::size_t i = 0; i < dropped.size(); ++i) text += line(i == 0 ? "left out" : "", dropped[i]);
    return text;
}

std::string_view law_formula(const LawFit& fit) {
    const bool floor = fit.eta_inf > 0.0;
    switch (fit.choice.law) {
        case FittedLaw::newtonian:
            return "Newtonian: η = η0";
        case FittedLaw::power_law:
            return "Power law: η = k γ^(n-1)";
        case FittedLaw::cross:
            return floor ? "Cross law: η = η∞ + (η0 - η∞) / (1 + (K γ)^α)"
                         : "Cross law: η = η0 / (1 + (K γ)^α)";
        case FittedLaw::carreau_yasuda:
            return floor ? "Carreau-Yasuda law: η = η∞ + (η0 - η∞) (1 + (K γ)^a)^((n-1)/a)"
                         : "Carreau-Yasuda law: η = η0 (1 + (K γ)^a)^((n-1)/a)";
        case FittedLaw::herschel_bulkley:
            return "Herschel-Bulkley law: η = τ0/γ + k γ^(n-1)";
    }
    return "";
}

std::string symbol(std::string_view parameter) {
    static const std::map<std::string_view, std::string> symbols = {
        {"eta0", "η0"},      {"eta_inf", "η∞"},      {"time_constant", "K"}, {"alpha", "α"},
        {"transition", "a"}, {"yield_stress", "τ0"}, {"consistency", "k"},   {"flow_index", "n"}};
    return symbols.at(parameter);
}

Dimension dimension_of(std::string_view parameter) {
    if (parameter == "eta0" || parameter == "eta_inf") return Dimension::viscosity;
    if (parameter == "time_constant") return Dimension::time;
    if (parameter == "yield_stress") return Dimension::pressure;
    return Dimension::dimensionless;
}

/// As many digits as the error allows: two of its own.
int digits_for(const FittedParameter& p) {
    if (!(p.standard_error > 0.0) || !std::isfinite(p.standard_error) || p.value == 0.0) return 4;
    const auto decade = [](double value) { return static_cast<int>(std::floor(std::log10(value))); };
    return std::clamp(decade(std::abs(p.value)) - decade(p.standard_error) + 2, 2, 7);
}

std::string relative_error(const FittedParameter& p) {
    return p.value == 0.0 ? "" : bare_text(100.0 * p.standard_error / std::abs(p.value), 2) + " %";
}

std::string parameters_section(const LawFit& fit, TableStyle style) {
    std::string text = "\n" + table_heading(law_formula(fit), style);
    Rows rows = {{"", "", "", "error", "", "95 % interval"}};
    for (const FittedParameter& p : fit.parameters) {
        const int digits = digits_for(p);
        const LabUnit& unit = choose_lab_unit(p.value, dimension_of(p.name), digits);
        std::string name(unit.name);
        if (p.name == "consistency") name = "Pa s^n";
        const auto show = [&](double value, int n) { return format_in(value, unit, n); };
        if (p.determined) {
            rows.push_back({symbol(p.name), show(p.value, digits), name, "± " + show(p.standard_error, 2),
                            relative_error(p), show(p.low, digits) + " to " + show(p.high, digits)});
        } else {
            rows.push_back({symbol(p.name), show(p.value, 3), name, "", "", "not determined"});
        }
    }
    text += table_grid(rows, 1);
    text += "  a point scatters by " + percent_text(fit.scatter) + " around the law\n";
    const std::size_t n = fit.parameters.size();
    std::string pairs;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            pairs += (pairs.empty() ? "" : ", ") + symbol(fit.parameters[i].name) + "·" +
                     symbol(fit.parameters[j].name) + " " +
                     bare_text(std::round(fit.correlation[i * n + j] * 1000.0) / 1000.0, 3);
        }
    }
    if (!pairs.empty()) text += "  correlation: " + table_wrapped(pairs, 15) + "\n";
    return text;
}

std::string laws_section(const FitAnswer& answer, TableStyle style) {
    Rows rows = {{"law", "parameters", "scatter", "AICc above best"}};
    const double best = answer.fit.laws.front().aicc.value_or(0.0);
    for (const LawFit& fit : answer.fit.laws) {
        std::string name(law_name(fit.choice.law));
        if (fit.choice.fit_eta_inf) name += ", eta_inf fitted";
        if (fit.choice == answer.chosen.choice) name += " *";
        rows.push_back(
            {name, std::to_string(fit.parameters.size()), percent_text(fit.scatter),
             fit.aicc ? bare_text(std::round(10.0 * (*fit.aicc - best)) / 10.0) : "too few points"});
    }
    return "\n" + table_heading("Laws compared (* shown above; less is better, 10 is decisive)", style) +
           table_grid(rows, 1);
}

/// A call that a shell takes as it is pasted: where it is too long it goes on after a backslash.
std::string call_line(std::string call) {
    constexpr std::size_t width = 76;
    constexpr std::string_view turn = " \\\n    ";
    for (std::size_t begin = 0; call.size() - begin > width;) {
        const std::size_t at = call.rfind(" -", begin + width - turn.size());
        if (at == std::string::npos || at <= begin) break;
        call.replace(at, 1, turn);
        begin = at + turn.size() - 1;
    }
    return call;
}

}  // namespace

std::string fit_table(const FitAnswer& answer, TableStyle style) {
    std::string text =
        data_section(answer, style) + parameters_section(answer.chosen, style) + laws_section(answer, style);
    text += "\n" + table_heading("To predict with it", style);
    if (const std::string problem = not_predicted(answer.chosen); !problem.empty()) {
        text +=
            "  " + table_wrapped("no prediction takes this ink: " + problem + "; fit another law", 2) + "\n";
    } else {
        text += "  " + call_line("bioprint-predict " + fit_options_line(answer)) + "\n" +
                "  or as a preset: --preset ink.json, then bioprint-predict --ink ./ink.json\n";
    }
    if (answer.warnings.empty() || style.quiet) return text;
    text += "\n" + table_heading("Notes", style);
    for (const Warning& warning : answer.warnings)
        text += "  " + table_wrapped("- " + warning.message, 4) + "\n";
    return text;
}

}  // namespace bioprint
