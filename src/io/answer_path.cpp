#include "io/answer_path.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "bioprint/errors.hpp"
#include "io/csv_columns.hpp"
#include "io/units.hpp"

namespace bioprint {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 9> population_words = {
    {{"mean", "mean"},
     {"median", "median"},
     {"p50", "median"},
     {"p90", "percentile_90"},
     {"p95", "percentile_95"},
     {"p99", "percentile_99"},
     {"largest", "largest"},
     {"max", "largest"},
     {"p100", "largest"}}};

/// "population.p95" and "population.exposure.p95" in full; empty when it is neither.
std::string population_path(std::string_view path) {
    std::string_view rest = path;
    std::string begin = "population.peak_stress.";
    if (!rest.starts_with("population.")) return {};
    rest.remove_prefix(11);
    for (const std::string_view part : {"peak_stress.", "exposure."}) {
        if (!rest.starts_with(part)) continue;
        begin = "population." + std::string(part);
        rest.remove_prefix(part.size());
        break;
    }
    for (const auto& [word, name] : population_words) {
        if (rest == word) return begin + std::string(name);
    }
    return {};
}

double stress_of(const Json& cell) {
    const Json& value = cell.at("stress").at("von_mises");
    return value.is_number() ? value.get<double>() : -1.0;
}

/// Whether an entry stands before another as what the steady theory says of the same cell at the same place.
bool is_steady_twin(const Json& steady, const Json& carried) {
    return steady["model"] != "ellipsoid" && carried["model"] == "ellipsoid" &&
           steady["place"] == carried["place"] && steady["offset"] == carried["offset"];
}

/// The entry that "nozzle" or "exit" means among the cells; none when there is no such entry.
std::optional<std::size_t> cell_index(const Json& cells, std::string_view place) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i]["place"] != place) continue;
        if (i + 1 < cells.size() && is_steady_twin(cells[i], cells[i + 1])) continue;
        const bool nearer = found && cells[i]["offset"] < cells[*found]["offset"];
        const bool heavier = found && stress_of(cells[i]) > stress_of(cells[*found]);
        if (!found || (place == "exit" ? nearer : heavier)) found = i;
    }
    return found;
}

std::string cells_path(const Json& answer, std::string_view path) {
    for (const std::string_view place : {"nozzle", "exit"}) {
        const std::string begin = "cells." + std::string(place) + ".";
        if (!path.starts_with(begin) || !answer.contains("cells")) continue;
        const std::optional<std::size_t> index = cell_index(answer["cells"], place);
        if (index) return "cells." + std::to_string(*index) + "." + std::string(path.substr(begin.size()));
    }
    return {};
}

/// A path of the same form in any answer: short forms of cells stand for one of the entries.
std::string general_path(std::string_view path) {
    if (std::string full = population_path(path); !full.empty()) return full;
    for (const std::string_view begin : {"cells.nozzle.", "cells.exit."}) {
        if (path.starts_with(begin)) return "cells.0." + std::string(path.substr(begin.size()));
    }
    return std::string(path);
}

std::string_view simulated_unit(std::string_view leaf) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> units = {
        {{"von_mises_channel", "Pa"},
         {"von_mises_peak", "Pa"},
         {"elongational_stress_peak", "Pa"},
         {"elongational_stress_average", "Pa"},
         {"excess_pressure", "Pa"},
         {"radial_velocity_max", "m/s"},
         {"cell_velocity", "m/s"},
         {"migration_velocity", "m/s"},
         {"radial_position", "m"},
         {"peak_position", "m"}}};
    const auto found =
        std::find_if(units.begin(), units.end(), [&](const auto& unit) { return unit.first == leaf; });
    return found == units.end() ? std::string_view{} : found->second;
}

/// Whether a path leads into a part that answers have as they were asked, and this one has not.
bool lacks_section(const Json& answer, std::string_view path) {
    const std::string_view first = path.substr(0, path.find('.'));
    if (first == "warnings") return path.size() > first.size();  // as many as there are
    return (first == "uncertainty" || first == "population" || first == "profile" || first == "passages") &&
           !answer.contains(first);
}

}  // namespace

std::string member_path(std::string path, std::string_view name) {
    path += '.';
    return path.append(name);
}

std::string json_path(const Json& answer, std::string_view path) {
    if (std::string full = population_path(path); !full.empty()) return full;
    if (std::string full = cells_path(answer, path); !full.empty()) return full;
    return std::string(path);
}

const Json& value_meant(const Json& answer, std::string_view path, std::string_view option) {
    const std::string real = json_path(answer, path);
    try {
        return value_at(answer, real, option);
    } catch (const UsageError& e) {
        const auto [own, written] = std::mismatch(real.rbegin(), real.rend(), path.rbegin(), path.rend());
        const std::string begin = "'" + std::string(real.begin(), own.base());
        const std::string short_form = "'" + std::string(path.begin(), written.base());
        std::string text = e.what();
        for (std::size_t at = text.find(begin); at != std::string::npos;
             at = text.find(begin, at + short_form.size())) {
            text.replace(at, begin.size(), short_form);
        }
        throw UsageError(text, std::string(option));
    }
}

const Json* value_if_any(const Json& answer, std::string_view path, std::string_view option) {
    try {
        return &value_meant(answer, path, option);
    } catch (const UsageError&) {
        if (is_known_path(path) || lacks_section(answer, path)) return nullptr;
        throw;
    }
}

std::optional<double> number_at(const Json& answer, std::string_view path, std::string_view option) {
    const Json& value = value_meant(answer, path, option);
    if (value.is_number()) return value.get<double>();
    if (value.is_null()) return std::nullopt;
    const std::string name = std::string(option) + ": '" + std::string(path) + "' is ";
    if (value.is_structured()) {
        throw UsageError(name + "not one value; add what is meant below it, such as '" + std::string(path) +
                             (value.is_array() || value.empty() ? ".0" : "." + value.begin().key()) + "'",
                         std::string(option));
    }
    throw UsageError(name + "a text; a number is needed", std::string(option));
}

bool is_known_path(std::string_view path) {
    const std::string general = general_path(path);
    const std::string_view unit = unit_of(general);
    return is_answer_header(unit.empty() ? general : general + " [" + std::string(unit) + "]");
}

std::string unit_at(std::string_view path) {
    if (path.starts_with("simulation.")) {
        if (path.starts_with("simulation.difference.")) return {};
        const std::string_view unit = simulated_unit(path.substr(path.rfind('.') + 1));
        if (!unit.empty()) return std::string(unit);
    }
    return std::string(unit_of(general_path(path)));
}

Dimension dimension_at(std::string_view path) {
    const std::optional<Unit> unit = parse_unit(unit_at(path));
    if (!unit) return Dimension::dimensionless;
    for (const Dimension dimension :
         {Dimension::length, Dimension::volume_flow, Dimension::velocity, Dimension::pressure,
          Dimension::pressure_gradient, Dimension::viscosity, Dimension::time, Dimension::rate}) {
        if (unit->powers == powers_of(dimension)) return dimension;
    }
    return Dimension::dimensionless;
}

bool needs_population(std::string_view path) {
    return path.starts_with("population.");
}

}  // namespace bioprint
