#include "io/report_sweep.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "io/answer_path.hpp"
#include "io/html.hpp"

namespace bioprint {
namespace {

/// The paths of the plain values of an answer's input: "input.radius", "input.ink.alpha".
void collect_paths(const Json& object, const std::string& path, std::vector<std::string>& paths) {
    for (const auto& [name, value] : object.items()) {
        const std::string here = member_path(path, name);
        if (value.is_object()) {
            collect_paths(value, here, paths);
        } else if (!value.is_array() && name != "source") {
            paths.push_back(here);
        }
    }
}

const Json* find(const Json& answer, const std::string& path) {
    const Json* place = &answer;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const auto found = place->find(path.substr(begin, end - begin));
        if (found == place->end()) return nullptr;
        place = &*found;
        begin = end + 1;
    }
    return place;
}

std::string text_at(const Json& answer, const std::string& path) {
    const Json* const value = find(answer, path);
    return value == nullptr || value->is_null() ? "–" : spoken_value(*value, path);
}

/// The largest von Mises stress of the cells in the nozzle.
std::string nozzle_stress(const Json& answer) {
    std::optional<double> largest;
    for (const Json& cell : answer.value("cells", Json::array())) {
        const Json& stress = cell.at("stress").at("von_mises");
        if (cell.at("place") == "nozzle" && stress.is_number()) {
            largest = std::max(largest.value_or(0.0), stress.get<double>());
        }
    }
    return largest ? spoken_value(*largest, "von_mises") : "–";
}

/// That of the cell nearest to the axis at the exit: carried in time where it was, else steady.
std::string exit_stress(const Json& answer) {
    std::optional<double> offset;
    Json best;
    for (const Json& cell : answer.value("cells", Json::array())) {
        if (cell.at("place") != "exit") continue;
        const double here = cell.at("offset").get<double>();
        const bool better = !offset || here < *offset || (here == *offset && cell.at("model") == "ellipsoid");
        if (!better) continue;
        offset = here;
        best = cell.at("stress").at("von_mises");
    }
    return best.is_number() ? spoken_value(best, "von_mises") : "–";
}

bool differs(const Json& answers, const std::string& path) {
    std::optional<Json> first;
    for (const Json& answer : answers) {
        const Json* const value = find(answer, path);
        if (value == nullptr) continue;
        if (first && *first != *value) return true;
        if (!first) first = *value;
    }
    return false;
}

}  // namespace

std::string sweep_sections(const Json& answers) {
    std::vector<std::string> paths;
    const Json* example = nullptr;
    for (const Json& answer : answers) {
        if (answer.contains("input") && example == nullptr) example = &answer;
    }
    if (example != nullptr) collect_paths(example->at("input"), "input", paths);
    std::vector<std::string> head;
    std::vector<std::string> changing;
    std::vector<std::vector<std::string>> shared;
    for (const std::string& path : paths) {
        if (differs(answers, path)) {
            changing.push_back(path);
            head.push_back(path.substr(std::string_view("input.").size()));
        } else {
            shared.push_back({path.substr(std::string_view("input.").size()), text_at(*example, path)});
        }
    }
    if (head.empty()) head.emplace_back("row");
    const std::vector<std::string> results = {"nozzle.flow_rate", "nozzle.pressure_gradient",
                                              "nozzle.stress_max", "exit.elongational_stress"};
    for (const char* name : {"flow rate", "pressure gradient", "wall stress", "exit stress",
                             "cell stress in nozzle", "cell stress at exit", "refused because"}) {
        head.emplace_back(name);
    }
    std::vector<std::vector<std::string>> rows;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Json& answer = answers[i];
        std::vector<std::string> row;
        row.reserve(changing.size() + results.size() + 1);
        for (const std::string& path : changing) row.push_back(text_at(answer, path));
        if (changing.empty()) row.push_back(std::to_string(i + 1));
        for (const std::string& path : results) row.push_back(text_at(answer, path));
        row.push_back(nozzle_stress(answer));
        row.push_back(exit_stress(answer));
        row.push_back(text_at(answer, "error.message"));
        rows.push_back(std::move(row));
    }
    if (std::all_of(rows.begin(), rows.end(), [](const auto& row) { return row.back() == "–"; })) {
        head.pop_back();
        for (auto& row : rows) row.pop_back();
    }
    return "<h2>Rows</h2>\n" + html_table(head, rows, "wide") + "<h2>The same in every row</h2>\n" +
           html_table({}, shared) +
           (example != nullptr
                ? "<p class=\"source\">Sources: " + html_text(text_at(*example, "input.ink.source")) + "; " +
                      html_text(text_at(*example, "input.cell.source")) + "</p>\n"
                : "");
}

std::string number_or_dash(const Json& value, std::string_view path) {
    return value.is_number() ? spoken_value(value, path) : "–";
}

}  // namespace bioprint
