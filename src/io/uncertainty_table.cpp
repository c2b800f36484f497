#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/io/number_format.hpp"
#include "io/answer_path.hpp"
#include "io/table.hpp"
#include "io/uncertainty.hpp"

namespace bioprint {
namespace {

struct Shown {
    const char* path;
    const char* label;
};
constexpr std::array<Shown, 9> shown = {{{"nozzle.flow_rate", "flow rate"},
                                         {"nozzle.pressure_gradient", "pressure gradient"},
                                         {"nozzle.pressure_drop", "pressure drop"},
                                         {"nozzle.stress_max", "stress at the wall"},
                                         {"nozzle.residence_time", "residence time"},
                                         {"exit.elongational_stress", "elongational stress"},
                                         {"cells.nozzle.stress.von_mises", "cell, in the nozzle"},
                                         {"cells.exit.stress.von_mises", "cell, at the exit"},
                                         {"population.p95", "95 % of all cells"}}};

std::string percent(double part) {
    if (part < 0.005) return "0 %";
    return format_lab(100.0 * part, Dimension::dimensionless, part < 0.0995 ? 1 : 2).number + " %";
}

std::string inputs_line(const Json& input) {
    const KeyInfo& info =
        info_of(find_key(input.at("name").get_ref<const std::string&>()).value_or(Key::radius));
    const LabUnit& unit = choose_lab_unit(input.at("mean").get<double>(), *info.dimension);
    std::string text = "  " + input.at("name").get<std::string>() + " " +
                       format_in(input.at("mean").get<double>(), unit, 4) + " ± " +
                       format_in(input.at("standard_deviation").get<double>(), unit, 2);
    if (!unit.name.empty()) text += " " + std::string(unit.name);
    return text + " (" + input.at("distribution").get<std::string>() + ")\n";
}

/// "eta0, time-constant and alpha".
std::string joined(const Json& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i].get<std::string>();
    }
    return list;
}

}  // namespace

const Json* spread_of(const Json& answer, std::string_view path) {
    const Json* place = &answer.at("uncertainty");
    const std::string real = json_path(answer, path);
    for (std::size_t begin = 0; begin <= real.size();) {
        const std::size_t end = std::min(real.find('.', begin), real.size());
        const std::string name = real.substr(begin, end - begin);
        if (place->is_array()) {
            const bool digits = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
            const std::size_t index = digits ? std::stoul(name) : place->size();
            if (index >= place->size()) return nullptr;
            place = &(*place)[index];
        } else if (place->is_object() && place->contains(name)) {
            place = &(*place)[name];
        } else {
            return nullptr;
        }
        begin = end + 1;
    }
    const bool spread = place->is_object() && place->at("standard_deviation").get<double>() > 0.0;
    return spread ? place : nullptr;
}

std::vector<NamedSpread> main_spreads(const Json& answer) {
    std::vector<NamedSpread> rows;
    for (const Shown& row : shown) {
        if (const Json* const spread = spread_of(answer, row.path)) {
            rows.push_back({.label = row.label, .path = row.path, .spread = spread});
        }
    }
    return rows;
}

std::string measure_better(const Json& answer) {
    const Json& correlation = answer.at("uncertainty").at("correlation");
    const Json together = correlation.is_null() ? Json::array() : correlation.at("names");
    // For the cell's stress at the exit, or what comes nearest to it.
    for (const Shown& row : {shown[8], shown[7], shown[6], shown[3]}) {
        const Json* const spread = spread_of(answer, row.path);
        if (spread == nullptr) continue;
        const Json& shares = spread->at("first_order");
        std::string best;
        double largest = 0.0;
        double left = 1.0;
        std::size_t others = 0;
        for (const auto& item : shares.items()) {
            if (std::find(together.begin(), together.end(), item.key()) != together.end()) continue;
            ++others;
            left -= item.value().get<double>();
            if (item.value().get<double>() <= largest) continue;
            largest = item.value().get<double>();
            best = item.key();
        }
        const std::string of = "spread of '" + std::string(row.label) + "'";
        if (!together.empty() && others > 0 && left > largest) {
            return "The flow curve of the ink (" + joined(together) +
                   ") makes what the other inputs leave of the " + of + ": " + percent(left);
        }
        if (shares.size() < 2 || best.empty()) return {};
        return ("Most of the " + of)
            .append(" is that of ")
            .append(best)
            .append(": ")
            .append(percent(largest));
    }
    return {};
}

std::vector<std::string> uncertainty_remarks(const Json& answer) {
    std::vector<std::string> remarks;
    for (const Json& warning : answer.at("warnings")) {
        if (warning.at("code") == "undetermined_ink")
            remarks.push_back(warning.at("message").get<std::string>());
    }
    const Json& correlation = answer.at("uncertainty").at("correlation");
    if (correlation.is_null()) return remarks;
    const Json& names = correlation.at("names");
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i].get<std::string>();
    }
    remarks.push_back(
        list +
        " were fitted together and vary together: a share of theirs is what goes when that input is "
        "known, with what it then says of the others, so that these shares overlap");
    return remarks;
}

std::string uncertainty_section(const Json& answer, TableStyle style) {
    const Json& uncertainty = answer.at("uncertainty");
    const std::size_t failed = uncertainty.at("failed").get<std::size_t>();
    std::string text =
        "\n" + table_heading("Uncertainty: " + std::to_string(uncertainty.at("samples").get<std::size_t>()) +
                                 " samples" +
                                 (failed > 0 ? ", " + std::to_string(failed) + " without an answer" : ""),
                             style);
    for (const Json& input : uncertainty.at("inputs")) text += inputs_line(input);
    std::vector<std::vector<std::string>> spreads = {{"", "mean", "±", "5 %", "50 %", "95 %", ""}};
    std::vector<std::vector<std::string>> shares = {{"share of the variance by"}};
    for (const Json& input : uncertainty.at("inputs"))
        shares[0].push_back(input.at("name").get<std::string>());
    for (const NamedSpread& row : main_spreads(answer)) {
        const Json* const spread = row.spread;
        const auto number = [&](const char* name) { return spread->at(name).get<double>(); };
        const LabUnit& unit = choose_lab_unit(number("mean"), dimension_at(row.path));
        spreads.push_back({std::string(row.label), format_in(number("mean"), unit, 4),
                           format_in(number("standard_deviation"), unit, 3),
                           format_in(number("percentile_5"), unit, 4),
                           format_in(number("percentile_50"), unit, 4),
                           format_in(number("percentile_95"), unit, 4), std::string(unit.name)});
        shares.push_back({std::string(row.label)});
        for (const auto& item : spread->at("first_order").items())
            shares.back().push_back(percent(item.value().get<double>()));
    }
    text += table_grid(spreads, 1);
    if (shares[0].size() > 2) {
        text += "\n" + table_grid(shares, 1);
        if (const std::string advice = measure_better(answer); !advice.empty()) text += "  " + advice + "\n";
    }
    for (const std::string& remark : uncertainty_remarks(answer))
        text += "  " + table_wrapped("- " + remark, 4) + "\n";
    return text;
}

}  // namespace bioprint
