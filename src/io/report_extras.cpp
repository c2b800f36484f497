#include "io/report_extras.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "bioprint/io/number_format.hpp"
#include "io/answer_path.hpp"
#include "io/html.hpp"
#include "io/report_sweep.hpp"
#include "io/settings.hpp"
#include "io/uncertainty.hpp"

namespace bioprint {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::string with_unit(double value, Dimension dimension, int digits) {
    const LabNumber n = format_lab(value, dimension, digits);
    return n.unit.empty() ? n.number : n.number + " " + n.unit;
}

/// The inputs that vary, and below them where each source says so.
std::string inputs_table(const Json& uncertainty) {
    Rows rows;
    std::vector<std::pair<std::string, std::string>> sources;  // source, the inputs with it
    for (const Json& input : uncertainty.at("inputs")) {
        const std::string name = input.at("name").get<std::string>();
        const KeyInfo& info = info_of(find_key(name).value_or(Key::radius));
        const Dimension dimension = info.dimension.value_or(Dimension::dimensionless);
        rows.push_back({name, with_unit(input.at("mean").get<double>(), dimension, 4),
                        with_unit(input.at("standard_deviation").get<double>(), dimension, 2),
                        input.at("distribution").get<std::string>()});
        const std::string source = input.value("source", "");
        const auto same =
            std::find_if(sources.begin(), sources.end(), [&](const auto& s) { return s.first == source; });
        if (same == sources.end()) {
            sources.emplace_back(source, name);
        } else {
            same->second.append(", ").append(name);
        }
    }
    std::string out = html_table({"input", "mean", "±", "distribution"}, rows);
    for (const auto& [source, names] : sources) {
        out += "<p class=\"source\">Spread of " + html_text(names) + ": " + html_text(source) + "</p>\n";
    }
    return out;
}

std::string shares_table(const std::vector<NamedSpread>& spreads, const Json& inputs) {
    if (inputs.size() < 2) return {};
    std::vector<std::string> head = {"share of the variance by"};
    for (const Json& input : inputs) head.push_back(input.at("name").get<std::string>());
    Rows rows;
    for (const NamedSpread& row : spreads) {
        rows.push_back({std::string(row.label)});
        for (const auto& item : row.spread->at("first_order").items()) {
            rows.back().push_back(percent_text(item.value().get<double>()));
        }
    }
    return html_table(head, rows);
}

}  // namespace

std::string report_checks(const Json& answer) {
    const auto checks = answer.find("checks");
    if (checks == answer.end() || checks->empty()) return {};
    Rows rows;
    for (const Json& check : *checks) {
        const std::string path = check.at("path").get<std::string>();
        const Dimension dimension = dimension_at(path);
        const auto number = [&](const char* name) {
            return check.at(name).is_number() ? with_unit(check.at(name).get<double>(), dimension, 4) : "–";
        };
        const Json& margin = check.at("relative_margin");
        rows.push_back({path, check.at("relation").get<std::string>() + " " + number("limit"),
                        number("value"), margin.is_number() ? percent_text(margin.get<double>()) : "–",
                        check.at("holds").get<bool>() ? "holds" : "does not hold"});
    }
    return "<h2>Checks</h2>\n" + html_table({"", "limit", "value", "margin", ""}, rows);
}

std::string report_uncertainty(const Json& answer) {
    const auto uncertainty = answer.find("uncertainty");
    if (uncertainty == answer.end()) return {};
    const std::vector<NamedSpread> spreads = main_spreads(answer);
    Rows rows;
    for (const NamedSpread& row : spreads) {
        const LabUnit& unit = choose_lab_unit(row.spread->at("mean").get<double>(), dimension_at(row.path));
        const auto number = [&](const char* name, int digits) {
            return format_in(row.spread->at(name).get<double>(), unit, digits);
        };
        rows.push_back({std::string(row.label), number("mean", 4), number("standard_deviation", 3),
                        number("percentile_5", 4), number("percentile_50", 4), number("percentile_95", 4),
                        std::string(unit.name)});
    }
    const std::size_t failed = uncertainty->at("failed").get<std::size_t>();
    std::string out = "<h2>Uncertainty</h2>\n<p>" +
                      html_text(std::to_string(uncertainty->at("samples").get<std::size_t>())) +
                      " samples of the inputs" +
                      (failed > 0 ? ", " + std::to_string(failed) + " without an answer" : "") + ".</p>\n";
    out += inputs_table(*uncertainty) + html_table({"", "mean", "±", "5 %", "50 %", "95 %", ""}, rows) +
           shares_table(spreads, uncertainty->at("inputs"));
    const std::string advice = measure_better(answer);
    if (!advice.empty()) out += "<p>" + html_text(advice) + "</p>\n";
    for (const std::string& remark : uncertainty_remarks(answer))
        out += "<p class=\"source\">" + html_text(remark) + "</p>\n";
    return out;
}

std::string report_passages(const Json& answer) {
    const auto passages = answer.find("passages");
    if (passages == answer.end() || passages->empty()) return {};
    Rows rows;
    for (const Json& way : *passages) {
        const Json& peak = way.at("peak");
        rows.push_back({number_or_dash(way.at("offset"), "offset"),
                        number_or_dash(peak.at("von_mises"), "von_mises"),
                        peak.at("place").is_string() ? peak.at("place").get<std::string>() : "–",
                        number_or_dash(peak.at("position"), "position"),
                        number_or_dash(way.at("nozzle").at("von_mises_peak"), "von_mises"),
                        number_or_dash(way.at("exit").at("von_mises_peak"), "von_mises")});
    }
    return "<h2>Way of each cell: its largest von Mises stress, and where</h2>\n" +
           html_table({"offset", "largest", "where", "from lip", "in nozzle", "at exit"}, rows);
}

}  // namespace bioprint
