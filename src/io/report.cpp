#include "io/report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

#include "bioprint/io/answer.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/answer_path.hpp"
#include "io/html.hpp"
#include "io/path_dimension.hpp"
#include "io/report_extras.hpp"
#include "io/report_sweep.hpp"
#include "io/run_directory.hpp"
#include "io/simulated_answer.hpp"

namespace bioprint {
namespace {

// Printed, the page is white with black rules; nothing is fetched, nothing runs.
constexpr const char* style = R"css(
:root { color-scheme: light; }
body { font: 15px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 920px; margin: 2em auto; padding: 0 1.2em; }
h1 { font-size: 1.5em; margin: 0 0 .2em; } h2 { font-size: 1.15em; margin: 1.8em 0 .5em; border-bottom: 1px solid #bbb; }
h3 { font-size: 1em; margin: 1em 0 .3em; }
p.call code, pre { display: block; background: #f4f4f4; border: 1px solid #ddd; padding: .6em .8em; overflow-x: auto;
  white-space: pre-wrap; overflow-wrap: anywhere; font: 13px/1.45 "DejaVu Sans Mono", Consolas, monospace; }
table { border-collapse: collapse; margin: .4em 0 1em; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .18em .7em; border-bottom: 1px solid #e4e4e4; font-weight: normal; }
th[scope=row] { text-align: left; } thead th { border-bottom: 1.5px solid #555; font-weight: 600; }
table.pairs { display: inline-table; vertical-align: top; margin-right: 2em; }
td { white-space: nowrap; } table.wide td { white-space: normal; }
table.wide { font-size: 12.5px; } table.wide th, table.wide td { padding: .15em .45em; }
p.source { color: #444; font-size: 13px; margin: .2em 0 .8em; overflow-wrap: anywhere; }
figure { margin: 1em 0 1.6em; } figure svg { width: 100%; height: auto; } figcaption { font-size: 13px; color: #333; }
ul.warnings { border-left: 4px solid #c44e00; padding: .3em 0 .3em 1.6em; margin: .6em 0; }
summary { cursor: pointer; } footer { margin-top: 2.5em; font-size: 13px; color: #444; }
@media print { body { margin: 0; max-width: none; font-size: 10pt; } h2, h3 { break-after: avoid; }
  figure, tr, ul.warnings { break-inside: avoid; } details { display: none; } @page { margin: 16mm; } }
)css";

/// "flow_rate" as a person says it.
std::string spoken(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// Rows "name, value" of the plain values of an object; objects and lists inside it have tables of their own.
std::vector<std::vector<std::string>> value_rows(const Json& object, const std::string& path) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [name, value] : object.items()) {
        if (value.is_object() || value.is_array() || name == "source" || value.is_null()) continue;
        rows.push_back({spoken(name), spoken_value(value, member_path(path, name))});
    }
    return rows;
}

std::string heading(const std::string& text) {
    return "<h2>" + html_text(text) + "</h2>\n";
}

std::string source_line(const Json& object) {
    const auto source = object.find("source");
    if (source == object.end() || !source->is_string()) return {};
    return "<p class=\"source\">Source: " + html_text(source->get<std::string>()) + "</p>\n";
}

std::string input_section(const Json& input) {
    std::string out =
        heading("Input") + "<h3>nozzle</h3>\n" + html_table({}, value_rows(input, "input"), "pairs");
    if (const auto needle = input.find("needle"); needle != input.end()) {
        out += "<p>" + html_text(needle->value("name", "")) + "</p>\n" + source_line(*needle);
    }
    for (const auto& [name, value] : input.items()) {
        if (!value.is_object() || name == "needle") continue;
        out += "<h3>" + html_text(spoken(name)) + "</h3>\n" +
               html_table({}, value_rows(value, "input." + name)) + source_line(value);
    }
    return out;
}

/// By place along the way and distance from the axis; the value carried in time before the steady one.
std::vector<const Json*> cells_in_order(const Json& cells) {
    std::vector<const Json*> order;
    for (const Json& cell : cells) order.push_back(&cell);
    const auto key = [](const Json* cell) {
        return std::tuple(cell->at("offset").get<double>(), cell->at("place") == "exit",
                          cell->at("model") != "ellipsoid");
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](const Json* a, const Json* b) { return key(a) < key(b); });
    return order;
}

std::string model_words(const std::string& model) {
    if (model == "ellipsoid") return "ellipsoid, in time";
    return model.starts_with("roscoe") ? "steady (" + model + ")" : model;
}

std::string cells_section(const Json& cells) {
    std::vector<std::vector<std::string>> rows;
    for (const Json* const place : cells_in_order(cells)) {
        const Json& cell = *place;
        const Json& stress = cell.at("stress");
        std::vector<std::string> row = {cell.at("place").get<std::string>(),
                                        model_words(cell.at("model").get<std::string>())};
        for (const char* name : {"offset", "fluid_stress"})
            row.push_back(number_or_dash(cell.at(name), name));
        for (const char* name : {"von_mises", "viscous"})
            row.push_back(number_or_dash(stress.at(name), name));
        for (const Json& stretch : cell.at("stretch")) row.push_back(number_or_dash(stretch, "stretch"));
        const Json& angle = cell.at("angle");
        row.push_back(angle.is_number() ? format_lab(angle.get<double>() * 180.0 / std::numbers::pi,
                                                     Dimension::dimensionless, 3)
                                                  .number +
                                              "°"
                                        : "–");
        rows.push_back(std::move(row));
    }
    return heading("Cells: stress of the ink, stress and stretch of the cell") +
           html_table(
               {"place", "model", "offset", "fluid", "von Mises", "viscous", "α1", "α2", "α3", "angle"},
               rows);
}

std::string simulation_section(const Json& simulation) {
    std::string out = heading("Simulation");
    std::vector<std::vector<std::string>> rows;
    const auto percent = [](const Json& value, double scale) {
        if (!value.is_number() || scale == 0.0) return std::string("–");
        return format_lab(100.0 * value.get<double>() / scale, Dimension::dimensionless, 2).number + " %";
    };
    for (const auto& [key, value] : simulation.at("simulated").items()) {
        if (!value.is_number()) continue;
        const std::string& name = key;
        const auto [label, dimension] = simulated_name(name);
        const auto lab = [&, unit = dimension](const Json& number) {
            if (!number.is_number()) return std::string("–");
            const LabNumber n = format_lab(number.get<double>(), unit);
            return n.unit.empty() ? n.number : n.number + " " + n.unit;
        };
        rows.push_back({std::string(label), lab(simulation.at("predicted").at(name)), lab(value),
                        percent(simulation.at("difference").at(name), 1.0),
                        percent(simulation.at("error").at(name), std::abs(value.get<double>()))});
    }
    out += html_table({"", "predicted", "simulated", "difference", "numerical error"}, rows);
    return out + "<p class=\"source\">Scene " + html_text(simulation.value("scene", "")) + ", fidelity " +
           html_text(simulation.value("fidelity", "")) + ".</p>\n";
}

/// Whatever else an answer holds: its plain values, and those of the objects in it.
std::string other_section(const std::string& name, const Json& object) {
    std::string out = heading(spoken(name));
    const auto rows = value_rows(object, name);
    if (!rows.empty()) out += html_table({}, rows);
    for (const auto& [inner, value] : object.items()) {
        if (!value.is_object()) continue;
        out += "<h3>" + html_text(spoken(inner)) + "</h3>\n" +
               html_table({}, value_rows(value, member_path(name, inner)));
    }
    return out;
}

std::string answer_sections(const Json& answer) {
    std::string out;
    for (const auto& [name, value] : answer.items()) {
        if (name == "cells") {
            out += cells_section(value);
        } else if (name == "simulation") {
            out += simulation_section(value);
        } else if (name == "passages") {
            out += report_passages(answer);
        } else if (name == "uncertainty") {
            out += report_uncertainty(answer);
        } else if (name == "checks") {
            out += report_checks(answer);
        } else if (name == "nozzle" || name == "exit") {
            out += heading(name == "nozzle" ? "In the nozzle" : "At the exit") +
                   html_table({}, value_rows(value, name));
        } else if (value.is_object() && name != "program" && name != "input" && name != "profile") {
            out += other_section(name, value);
        }
    }
    return out;
}

std::string warnings_section(const Json& answers) {
    std::vector<std::string> seen;
    std::string items;
    for (const Json& answer : answers) {
        const auto warnings = answer.find("warnings");
        if (warnings == answer.end()) continue;
        for (const Json& warning : *warnings) {
            const std::string code = warning.at("code").get<std::string>();
            if (std::find(seen.begin(), seen.end(), code) != seen.end()) continue;
            seen.push_back(code);
            items += "<li>" + html_text(warning.at("message").get<std::string>()) + "</li>\n";
        }
    }
    if (items.empty()) return {};
    return heading("Notes") + "<ul class=\"warnings\">\n" + items + "</ul>\n";
}

std::string figures_section(const Report& report) {
    std::string out = heading("Pictures");
    if (!report.no_figures.empty()) return out + "<p>" + html_text(report.no_figures) + "</p>\n";
    for (const ReportFigure& figure : report.figures) {
        // Inside a page an SVG stands without its XML declaration.
        const std::size_t begin = std::min(figure.svg.find("<svg"), figure.svg.size());
        out += "<figure>\n" + figure.svg.substr(begin) + "<figcaption>" + html_text(figure.caption) +
               "</figcaption>\n</figure>\n";
    }
    return out;
}

std::string call_text(const std::vector<std::string>& call) {
    std::string text;
    for (const std::string& word : call) text += (text.empty() ? "" : " ") + shell_word(word);
    return text;
}

}  // namespace

std::string spoken_value(const Json& value, std::string_view path) {
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_number()) return json_text(value);
    const LabNumber n = format_lab(value.get<double>(), dimension_of_path(path));
    return n.unit.empty() ? n.number : n.number + " " + n.unit;
}

std::string report_html(const Report& report) {
    const bool sweep = report.answer.is_array();
    const Json answers = sweep ? report.answer : Json::array({report.answer});
    const std::string title = sweep ? "Sweep of " + std::to_string(answers.size()) + " predictions"
                                    : "Cells in extrusion bioprinting: a prediction";
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<link rel=\"icon\" href=\"data:,\">\n<title>" +
        html_text(title) + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
        html_text(title) + "</h1>\n<p class=\"call\"><code>" + html_text(call_text(report.call)) +
        "</code></p>\n";
    out += warnings_section(answers);
    if (sweep) {
        out += sweep_sections(answers) + figures_section(report);
    } else {
        out += input_section(report.answer.at("input")) + answer_sections(report.answer) +
               figures_section(report);
    }
    out += heading("All numbers") + "<p>In SI units, as JSON of the schema " + html_text(schema_name) +
           ".</p>\n<details>\n<summary>JSON</summary>\n<pre id=\"answer\">" +
           html_text(json_text(report.answer, 1)) + "</pre>\n</details>\n";
    return out + "<footer>" + html_text(program_name) + " " + html_text(program_version()) +
           ". Every model and its range: <code>man bioprint-predict</code>.</footer>\n</body>\n</html>\n";
}

}  // namespace bioprint
