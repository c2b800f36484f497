#include "io/csv_columns.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace bioprint {
namespace {

constexpr std::array<std::string_view, 25> leading_paths = {"input.radius",
                                                            "input.length",
                                                            "input.flow_rate",
                                                            "input.ink.name",
                                                            "input.ink.eta0",
                                                            "input.ink.eta_inf",
                                                            "input.ink.time_constant",
                                                            "input.ink.alpha",
                                                            "input.cell.name",
                                                            "input.cell.radius",
                                                            "input.cell.shear_modulus",
                                                            "input.cell.poisson_ratio",
                                                            "input.cell.viscosity_ratio",
                                                            "nozzle.flow_rate",
                                                            "nozzle.pressure_gradient",
                                                            "nozzle.velocity_average",
                                                            "nozzle.velocity_max",
                                                            "nozzle.shear_rate_max",
                                                            "nozzle.shear_rate_average",
                                                            "nozzle.stress_max",
                                                            "nozzle.stress_average",
                                                            "nozzle.viscosity_wall",
                                                            "nozzle.pressure_drop",
                                                            "nozzle.residence_time",
                                                            "exit.elongation_rate"};
constexpr std::array<std::string_view, 20> cell_paths = {"place",
                                                         "model",
                                                         "offset",
                                                         "offset_in_cell_radii",
                                                         "fluid_stress",
                                                         "stress_ratio",
                                                         "stretch.0",
                                                         "stretch.1",
                                                         "stretch.2",
                                                         "angle",
                                                         "frequency",
                                                         "stress.von_mises",
                                                         "stress.elastic.0",
                                                         "stress.elastic.1",
                                                         "stress.elastic.2",
                                                         "stress.viscous",
                                                         "relaxation_time",
                                                         "applies",
                                                         "error",
                                                         "strain_error"};
constexpr std::array<std::string_view, 17> passage_paths = {"offset",
                                                            "offset_in_cell_radii",
                                                            "peak.von_mises",
                                                            "peak.place",
                                                            "peak.position",
                                                            "nozzle.von_mises_peak",
                                                            "nozzle.von_mises_settled",
                                                            "nozzle.settles",
                                                            "nozzle.settling_time",
                                                            "nozzle.exposure",
                                                            "exit.von_mises_peak",
                                                            "exit.position",
                                                            "exit.exposure",
                                                            "strand_offset",
                                                            "peak.error",
                                                            "nozzle.error",
                                                            "exit.error"};
constexpr std::array<std::string_view, 14> population_paths = {
    "population.peak_stress.mean",          "population.peak_stress.median",
    "population.peak_stress.percentile_90", "population.peak_stress.percentile_95",
    "population.peak_stress.percentile_99", "population.peak_stress.largest",
    "population.share_peaking_at_exit",     "population.exposure.mean",
    "population.exposure.median",           "population.exposure.percentile_90",
    "population.exposure.percentile_95",    "population.exposure.percentile_99",
    "population.exposure.largest",          "population.error"};
constexpr std::array<std::string_view, 2> threshold_paths = {"stress", "share_above"};
// Behind all that an ink by the Cross law has, so that its columns stay where they were.
constexpr std::array<std::string_view, 8> law_paths = {
    "input.ink.law",        "input.ink.consistency", "input.ink.flow_index", "input.ink.yield_stress",
    "input.ink.transition", "nozzle.plug_radius",    "nozzle.error",         "exit.error"};

/// What is known of a model, not a result of the inputs, which can have a spread.
bool is_error(std::string_view path) {
    return path.ends_with("error");
}
constexpr std::array<std::string_view, 4> trailing_paths = {"warnings", "error.code", "error.message",
                                                            "error.option"};

std::string with_unit(std::string_view path) {
    const std::string_view unit = unit_of(path);
    return unit.empty() ? std::string(path) : std::string(path) + " [" + std::string(unit) + "]";
}

bool is_index(std::string_view name) {
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

const Json* find(const Json& answer, const std::vector<CsvColumns::Step>& path) {
    const Json* place = &answer;
    for (const CsvColumns::Step& step : path) {
        if (place->is_object()) {
            const auto found = place->find(step.name);
            if (found == place->end()) return nullptr;
            place = &*found;
        } else if (place->is_array() && step.index && *step.index < place->size()) {
            place = &(*place)[*step.index];
        } else {
            return nullptr;
        }
    }
    return place;
}

std::string warning_codes(const Json& warnings) {
    std::string codes;
    for (const Json& warning : warnings) {
        codes += (codes.empty() ? "" : " ") + warning.at("code").get_ref<const std::string&>();
    }
    return codes;
}

/// The paths of the numbers that can have a spread.
std::vector<std::string> spread_numbers(const AnswerShape& shape) {
    std::vector<std::string> paths;
    for (const std::string_view path : leading_paths) {
        if (!path.starts_with("input.")) paths.emplace_back(path);
    }
    paths.emplace_back("exit.elongational_stress");
    for (std::size_t i = 0; i < shape.cells; ++i) {
        for (const std::string_view path : cell_paths) {
            if (path != "place" && path != "model" && path != "applies" && !is_error(path))
                paths.push_back("cells." + std::to_string(i) + "." + std::string(path));
        }
    }
    for (std::size_t i = 0; i < shape.passages; ++i) {
        for (const std::string_view path : passage_paths) {
            if (path != "peak.place" && path != "nozzle.settles" && !is_error(path))
                paths.push_back("passages." + std::to_string(i) + "." + std::string(path));
        }
    }
    if (!shape.population) return paths;
    for (const std::string_view path : population_paths) {
        if (!is_error(path)) paths.emplace_back(path);
    }
    for (std::size_t i = 0; i < shape.thresholds; ++i)
        paths.push_back("population.thresholds." + std::to_string(i) + ".share_above");
    return paths;
}

/// The header of the number whose spread stands under a header; empty when it is none.
std::string spread_number(std::string_view header) {
    constexpr std::string_view begin = "uncertainty.";
    if (!header.starts_with(begin)) return {};
    const std::string_view path = header.substr(0, header.find(" ["));
    const std::string_view number = path.substr(0, path.rfind('.'));
    const std::vector<std::string> all =
        spread_paths(std::string(number.substr(std::min(begin.size(), number.size()))));
    if (std::find(all.begin(), all.end(), path) == all.end()) return {};
    return std::string(number.substr(begin.size())) + std::string(header.substr(path.size()));
}

}  // namespace

CsvColumns::CsvColumns(const AnswerShape& shape, const Extras& extras) : shape_(shape) {
    for (const std::string_view path : leading_paths) add(std::string(path));
    add("exit.elongational_stress");
    for (std::size_t i = 0; i < shape.cells; ++i) {
        for (const std::string_view path : cell_paths)
            add("cells." + std::to_string(i) + "." + std::string(path));
    }
    for (std::size_t i = 0; i < shape.passages; ++i) {
        for (const std::string_view path : passage_paths)
            add("passages." + std::to_string(i) + "." + std::string(path));
    }
    if (shape.population) {
        for (const std::string_view path : population_paths) add(std::string(path));
        for (std::size_t i = 0; i < shape.thresholds; ++i) {
            for (const std::string_view path : threshold_paths)
                add("population.thresholds." + std::to_string(i) + "." + std::string(path));
        }
    }
    for (const std::string_view path : law_paths) add(std::string(path));
    for (const std::string& path : extra_paths(extras, spread_numbers(shape))) add(path);
    for (const std::string_view path : trailing_paths) add(std::string(path));
}

void CsvColumns::add(const std::string& path) {
    std::vector<Step> steps;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('.', begin), path.size());
        const std::string name = path.substr(begin, end - begin);
        steps.push_back({name, is_index(name) ? std::optional<std::size_t>(std::stoul(name)) : std::nullopt});
        begin = end + 1;
    }
    paths_.push_back(std::move(steps));
    headers_.push_back(with_unit(path));
}

void CsvColumns::write(const Json& answer, CsvWriter& writer) const {
    for (const std::vector<Step>& path : paths_) {
        const Json* value = find(answer, path);
        if (value == nullptr || value->is_null()) {
            writer.add_empty();
        } else if (value->is_array()) {
            writer.add_text(warning_codes(*value));
        } else if (value->is_boolean()) {
            writer.add_text(value->get<bool>() ? "true" : "false");
        } else if (value->is_number()) {
            writer.add_number(value->get<double>());
        } else {
            writer.add_text(value->get_ref<const std::string&>());
        }
    }
}

bool is_answer_header(std::string_view header) {
    std::string_view path = header.substr(0, header.find(" ["));
    bool known =
        std::find(leading_paths.begin(), leading_paths.end(), path) != leading_paths.end() ||
        path == "exit.elongational_stress" ||
        std::find(population_paths.begin(), population_paths.end(), path) != population_paths.end() ||
        std::find(law_paths.begin(), law_paths.end(), path) != law_paths.end() ||
        std::find(trailing_paths.begin(), trailing_paths.end(), path) != trailing_paths.end();
    const auto listed = [&](std::string_view list, const auto& paths) {
        if (!path.starts_with(list)) return false;
        const std::string_view rest = path.substr(list.size());
        const std::size_t dot = rest.find('.');
        return dot != std::string_view::npos && is_index(rest.substr(0, dot)) &&
               std::find(paths.begin(), paths.end(), rest.substr(dot + 1)) != paths.end();
    };
    known = known || listed("cells.", cell_paths) || listed("passages.", passage_paths) ||
            listed("population.thresholds.", threshold_paths);
    if (const std::string number = spread_number(header); !number.empty()) return is_answer_header(number);
    return (known && with_unit(path) == header) || is_extra_header(header);
}

}  // namespace bioprint
