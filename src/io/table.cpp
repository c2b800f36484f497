#include "io/table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "bioprint/io/number_format.hpp"
#include "io/ink_text.hpp"
#include "io/published_limits.hpp"

namespace bioprint {
namespace {

constexpr std::size_t page_width = 80;

/// Columns a UTF-8 text takes: bytes that do not continue a character.
std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool left) {
    const std::size_t own = width_of(text);
    const std::string space(width > own ? width - own : 0, ' ');
    return left ? text + space : space + text;
}

std::string heading(std::string_view text, TableStyle style) {
    return style.color ? "\033[1m" + std::string(text) + "\033[0m\n" : std::string(text) + "\n";
}

/// Breaks at spaces so that no line passes the page; following lines are indented by `indent`.
std::string wrapped(std::string_view text, std::size_t indent) {
    std::string out;
    std::size_t column = indent;
    std::size_t begin = 0;
    while (begin < text.size()) {
        std::size_t end = text.find(' ', begin);
        if (end == std::string_view::npos) end = text.size();
        const std::string_view word = text.substr(begin, end - begin);
        if (column > indent && column + 1 + width_of(word) > page_width) {
            out += "\n" + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            out += ' ';
            ++column;
        }
        out += word;
        column += width_of(word);
        begin = end + 1;
    }
    return out;
}

using Entry = std::pair<std::string, std::string>;

/// Names and values in two columns, read down the page by rows.
std::string two_columns(const std::vector<Entry>& entries) {
    std::string out;
    for (std::size_t i = 0; i < entries.size(); i += 2) {
        std::string line = "  " + padded(entries[i].first, 20, true) + padded(entries[i].second, 16, false);
        if (i + 1 < entries.size()) {
            line +=
                "    " + padded(entries[i + 1].first, 21, true) + padded(entries[i + 1].second, 15, false);
        }
        out += line + "\n";
    }
    return out;
}

/// Right-aligned columns under their headings, the first `left` ones left-aligned.
std::string grid(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    // Two spaces between columns where the page allows, else one.
    std::size_t total = 1;
    for (const std::size_t width : widths) total += width + 2;
    const std::size_t gap = total > page_width ? 1 : 2;
    std::string out;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            line += std::string(i == 0 ? 2 : gap, ' ') + padded(row[i], widths[i], i < left);
        }
        out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return out;
}

std::string input_section(const Prediction& prediction, TableStyle style) {
    const Case& question = prediction.question;
    const std::string ink = question.ink.name + ": " + ink_text(question.ink.law);
    std::string cell = question.cell.name + ": radius " + lab_text(question.cell.radius, Dimension::length) +
                       ", shear modulus " + lab_text(question.cell.shear_modulus, Dimension::pressure);
    if (question.cell.viscosity_ratio != 1.0)
        cell += ", viscosity ratio " + bare_text(question.cell.viscosity_ratio);
    std::string nozzle = "radius " + lab_text(question.radius, Dimension::length);
    if (question.length) nozzle += ", length " + lab_text(*question.length, Dimension::length);
    if (question.needle) nozzle += " (" + question.needle->name + ")";
    const auto line = [](const char* name, const std::string& text) {
        return "  " + padded(name, 8, true) + wrapped(text, 10) + "\n";
    };
    return heading("Input", style) + line("nozzle", nozzle) + line("ink", ink) + line("cell", cell);
}

std::string nozzle_section(const NozzleAnswer& nozzle, TableStyle style) {
    std::vector<Entry> entries = {
        {"flow rate", lab_text(nozzle.flow_rate, Dimension::volume_flow)},
        {"pressure gradient", lab_text(nozzle.pressure_gradient, Dimension::pressure_gradient)},
        {"average velocity", lab_text(nozzle.velocity_average, Dimension::velocity)},
        {"largest velocity", lab_text(nozzle.velocity_max, Dimension::velocity)},
        {"average stress", lab_text(nozzle.stress_average, Dimension::pressure)},
        {"stress at the wall", lab_text(nozzle.stress_max, Dimension::pressure)},
        {"average shear rate", lab_text(nozzle.shear_rate_average, Dimension::rate)},
        {"shear rate at wall", lab_text(nozzle.shear_rate_max, Dimension::rate)},
        {"viscosity at wall", lab_text(nozzle.viscosity_wall, Dimension::viscosity)}};
    if (nozzle.pressure_drop)
        entries.emplace_back("pressure drop", lab_text(*nozzle.pressure_drop, Dimension::pressure));
    if (nozzle.residence_time)
        entries.emplace_back("residence time", lab_text(*nozzle.residence_time, Dimension::time));
    if (nozzle.plug_radius)
        entries.emplace_back("radius of the plug", lab_text(*nozzle.plug_radius, Dimension::length));
    return "\n" + heading("In the nozzle", style) + two_columns(entries);
}

/// "±12%", never less than it is, or a dash where nothing was measured.
std::string error_text(const std::optional<double>& error) {
    if (!error) return "–";
    const double percent = 100.0 * *error;
    const double digit =
        percent >= 1.0 || percent == 0.0 ? 1.0 : std::pow(10.0, std::floor(std::log10(percent)));
    return "±" + bare_text(std::ceil(percent / digit * (1.0 - 1e-12)) * digit, 3) + "%";
}

/// A value with its error, which stand below each other in a column.
std::string with_error(const std::string& value, const std::optional<double>& error) {
    return value + " " + padded(error_text(error), 4, false);
}

std::string exit_section(const ExitAnswer& exit, TableStyle style) {
    const auto text = [&](double value, Dimension dimension) {
        return lab_text(value, dimension) + (exit.error ? " " + error_text(exit.error) : "");
    };
    return "\n" + heading("At the exit", style) +
           two_columns({{"elongation rate", text(exit.elongation_rate, Dimension::rate)},
                        {"elongational stress", text(exit.elongational_stress, Dimension::pressure)}});
}

std::string_view model_label(Model model) {
    switch (model) {
        case Model::bullet:
            return "bullet";
        case Model::roscoe_shear:
            return "shear";
        case Model::roscoe_elongation:
            return "elongation";
        case Model::ellipsoid:
            return "ellipsoid";
    }
    return "";
}

/// Whether an entry is what the steady theory says of the same cell at the same place.
bool is_steady_twin(const CellAnswer& steady, const CellAnswer& carried) {
    return carried.model == Model::ellipsoid && steady.model != Model::ellipsoid &&
           steady.place == carried.place && steady.offset == carried.offset;
}

/// A value of a column whose largest is given: a billionth of that is nothing to a person, as at rest in a plug.
std::string in_column(double value, const LabUnit& unit, double largest) {
    return std::abs(value) < 1e-9 * largest ? "0" : format_in(value, unit, 4);
}

std::string cells_section(const Prediction& prediction, TableStyle style) {
    double largest = 0.0;
    for (const CellAnswer& cell : prediction.cells) {
        largest = std::max({largest, cell.fluid_stress, cell.stress ? cell.stress->von_mises : 0.0});
    }
    const LabUnit& unit = choose_lab_unit(largest, Dimension::pressure);
    const std::string unit_name(unit.name);
    std::vector<std::vector<std::string>> rows = {
        {"place", "offset", "fluid", "von Mises", "viscous", "stretch", "", "", "angle", "model"},
        {"", "µm", unit_name, unit_name, unit_name, "α1", "α2", "α3", "°", ""}};
    // The cell carried in time leads; the steady theory stands in brackets below it.
    std::vector<const CellAnswer*> order;
    for (const CellAnswer& cell : prediction.cells) {
        order.push_back(&cell);
        if (order.size() > 1 && cell.model == Model::ellipsoid && is_steady_twin(**(order.end() - 2), cell))
            std::iter_swap(order.end() - 1, order.end() - 2);
    }
    for (auto entry = order.begin(); entry != order.end(); ++entry) {
        const CellAnswer& cell = **entry;
        const bool second = entry != order.begin() && is_steady_twin(cell, **(entry - 1));
        const auto stress = [&](double value) { return in_column(value, unit, largest); };
        const auto stretch = [&](std::size_t i) {
            return cell.stretch ? bare_text((*cell.stretch)[i]) : "–";
        };
        rows.push_back({cell.place == Place::nozzle ? "nozzle" : "exit", bare_text(cell.offset * 1e6),
                        stress(cell.fluid_stress),
                        cell.stress ? with_error(stress(cell.stress->von_mises), cell.error) : "–",
                        cell.stress ? stress(cell.stress->viscous) : "–", stretch(0), stretch(1), stretch(2),
                        cell.angle ? bare_text(*cell.angle * 180.0 / std::numbers::pi, 3) : "–",
                        second ? "(steady)" : std::string(model_label(cell.model))});
    }
    return "\n" + heading("Cells: stress of the ink; stress, ± as measured, and stretch of the cell", style) +
           grid(rows, 1);
}

/// Where each carried cell bears its largest stress, and whether the nozzle is long enough for it to settle.
std::string passages_section(const Prediction& prediction, TableStyle style) {
    if (prediction.passages.empty()) return {};
    double largest = 0.0;
    for (const PassageAnswer& p : prediction.passages) largest = std::max(largest, p.von_mises);
    const LabUnit& unit = choose_lab_unit(largest, Dimension::pressure);
    const bool has_length = prediction.question.length.has_value();
    std::vector<std::vector<std::string>> rows = {
        {"offset", "largest", "where", "from lip", "in nozzle", "settled", "at exit"},
        {"µm", std::string(unit.name), "", "µm", std::string(unit.name), std::string(unit.name),
         std::string(unit.name)}};
    if (has_length) {
        rows[0].insert(rows[0].end(), {"settles in", "exposure"});
        rows[1].insert(rows[1].end(), {"", "Pa s"});
    }
    for (const PassageAnswer& p : prediction.passages) {
        const auto stress = [&](double value) { return in_column(value, unit, largest); };
        rows.push_back({bare_text(p.offset * 1e6), with_error(stress(p.von_mises), p.error),
                        p.place == Place::nozzle ? "nozzle" : "exit",
                        p.position ? bare_text(*p.position * 1e6) : "–", stress(p.nozzle_peak),
                        stress(p.nozzle_steady), stress(p.exit_peak)});
        if (!has_length) continue;
        rows.back().push_back(p.settling_time ? lab_text(*p.settling_time, Dimension::time) : "not");
        rows.back().push_back(bare_text(p.nozzle_exposure.value_or(0.0) + p.exit_exposure));
    }
    return "\n" + heading("Way of each cell: its largest von Mises stress, and where", style) + grid(rows, 0);
}

/// What is known of these cells elsewhere, and the same two quantities of this print beside it.
std::string published_text(const Prediction& prediction) {
    const std::vector<PublishedLimit> limits = published_limits(prediction.question.cell.name);
    if (limits.empty()) return {};
    std::string text = "published for " + prediction.question.cell.name + ", as context:";
    for (const PublishedLimit& limit : limits) {
        text += " " + bare_text(100.0 * limit.viability, 3) + " % survive a wall stress of " +
                lab_text(limit.wall_stress, Dimension::pressure) + " for " +
                lab_text(limit.duration, Dimension::time) + ";";
    }
    const NozzleAnswer& nozzle = prediction.nozzle;
    text += " here the wall stress is " + lab_text(nozzle.stress_max, Dimension::pressure);
    if (nozzle.residence_time)
        text += ", the mean residence " + lab_text(*nozzle.residence_time, Dimension::time);
    return "  " + wrapped(text + " (" + limits.front().source + ")", 2) + "\n";
}

std::string population_section(const Prediction& prediction, TableStyle style) {
    const Population& population = *prediction.population;
    const std::vector<double>& thresholds = prediction.question.thresholds;
    std::vector<std::vector<std::string>> rows = {{"", "mean", "median", "90 %", "95 %", "99 %", "largest"}};
    const auto row = [&](const char* name, const Distribution& d, const auto& show) {
        rows.push_back({name, show(d.mean), show(d.median), show(d.percentile_90), show(d.percentile_95),
                        show(d.percentile_99), show(d.largest)});
    };
    const std::string name =
        "peak stress" +
        (prediction.population_error ? " " + error_text(prediction.population_error) : std::string());
    row(name.c_str(), population.peak_stress,
        [](double value) { return lab_text(value, Dimension::pressure); });
    if (population.exposure) {
        row("exposure [Pa s]", *population.exposure, [](double value) { return bare_text(value); });
    }
    std::string text = "\n" + heading("Population: all cells of the print", style) + grid(rows, 1);
    for (std::size_t i = 0; i < thresholds.size(); ++i) {
        text += "  above " + lab_text(thresholds[i], Dimension::pressure) + ": " +
                bare_text(100.0 * population.share_above.at(i), 3) + " % of the cells\n";
    }
    return text + "  " + bare_text(100.0 * population.share_peaking_at_exit, 3) +
           " % of the cells bear their largest stress at the exit\n" + published_text(prediction);
}

std::string profile_section(const RadialProfile& profile, TableStyle style) {
    std::vector<std::vector<std::string>> rows = {{"r", "velocity", "shear rate", "viscosity", "stress"},
                                                  {"µm", "mm/s", "1/s", "Pa.s", "Pa"}};
    for (std::size_t i = 0; i < profile.r.size(); ++i) {
        rows.push_back({bare_text(profile.r[i] * 1e6), bare_text(profile.velocity[i] * 1e3),
                        bare_text(profile.shear_rate[i]), bare_text(profile.viscosity[i]),
                        bare_text(profile.stress[i])});
    }
    return "\n" + heading("Profile", style) + grid(rows, 0);
}

std::string notes_section(const std::vector<Warning>& warnings, TableStyle style) {
    if (warnings.empty() || style.quiet) return {};
    std::string out = "\n" + heading("Notes", style);
    for (const Warning& warning : warnings) out += "  " + wrapped("- " + warning.message, 4) + "\n";
    return out;
}

}  // namespace

double nozzle_stress(const Prediction& prediction) {
    double largest = 0.0;
    for (const PassageAnswer& passage : prediction.passages) largest = std::max(largest, passage.nozzle_peak);
    if (!prediction.passages.empty()) return largest;
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.place == Place::nozzle && cell.stress) largest = std::max(largest, cell.stress->von_mises);
    }
    return largest;
}

std::optional<double> exit_stress(const Prediction& prediction) {
    const CellAnswer* best = nullptr;
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.place != Place::exit) continue;
        if (best == nullptr || cell.offset < best->offset ||
            (cell.offset == best->offset && cell.model == Model::ellipsoid)) {
            best = &cell;
        }
    }
    if (best == nullptr || !best->stress) return std::nullopt;
    return best->stress->von_mises;
}

std::string table_heading(std::string_view text, TableStyle style) {
    return heading(text, style);
}

std::string table_grid(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
    return grid(rows, left);
}

std::string table_wrapped(std::string_view text, std::size_t indent) {
    return wrapped(text, indent);
}

std::string answer_table(const Prediction& prediction, TableStyle style) {
    std::string out = input_section(prediction, style) + nozzle_section(prediction.nozzle, style) +
                      exit_section(prediction.exit, style) + cells_section(prediction, style) +
                      passages_section(prediction, style);
    if (prediction.population) {
        out += population_section(prediction, style);
    }
    if (prediction.profile) out += profile_section(*prediction.profile, style);
    return out + notes_section(prediction.warnings, style);
}

std::vector<std::string> SweepTable::label_cells(const Settings& row) const {
    std::vector<std::string> cells;
    for (const Key key : swept_) {
        const KeyInfo& info = info_of(key);
        cells.push_back(info.dimension ? lab_text(row.at(key).number, *info.dimension) : row.at(key).text);
    }
    return cells;
}

void SweepTable::add(const Settings& row, const Prediction& prediction, const std::string& verdict) {
    std::vector<std::string> cells = label_cells(row);
    const double in_nozzle = nozzle_stress(prediction);
    const std::optional<double> at_exit = exit_stress(prediction);
    cells.push_back(lab_text(prediction.nozzle.flow_rate, Dimension::volume_flow));
    cells.push_back(lab_text(prediction.nozzle.pressure_gradient, Dimension::pressure_gradient));
    cells.push_back(lab_text(prediction.nozzle.stress_max, Dimension::pressure));
    cells.push_back(lab_text(prediction.exit.elongational_stress, Dimension::pressure));
    cells.push_back(lab_text(in_nozzle, Dimension::pressure));
    cells.push_back(at_exit ? lab_text(*at_exit, Dimension::pressure) : "–");
    if (checks_) cells.push_back(verdict);
    rows_.push_back(std::move(cells));
    for (const Warning& warning : prediction.warnings) {
        if (std::find(notes_.begin(), notes_.end(), warning.code) == notes_.end())
            notes_.push_back(warning.code);
    }
}

void SweepTable::add_refusal(const Settings& row, const std::string& message) {
    std::vector<std::string> cells = label_cells(row);
    cells.resize(swept_.size() + 6 + (checks_ ? 1 : 0), "–");
    rows_.push_back(std::move(cells));
    notes_.push_back(message);
}

std::string SweepTable::text(TableStyle style) const {
    std::vector<std::vector<std::string>> rows(2);
    for (const Key key : swept_) {
        rows[0].emplace_back(info_of(key).option);
        rows[1].emplace_back();
    }
    for (const auto& [top, bottom] : {Entry{"flow", "rate"},
                                      {"pressure", "gradient"},
                                      {"wall", "stress"},
                                      {"exit", "stress"},
                                      {"cell stress", "in nozzle"},
                                      {"cell stress", "at exit"}}) {
        rows[0].push_back(top);
        rows[1].push_back(bottom);
    }
    if (checks_) {
        rows[0].emplace_back("checks");
        rows[1].emplace_back();
    }
    rows.insert(rows.end(), rows_.begin(), rows_.end());
    std::string out = grid(rows, 0);
    if (!notes_.empty() && !style.quiet) {
        std::string list;
        for (const std::string& note : notes_) list += (list.empty() ? "" : ", ") + note;
        out += "\n  " + wrapped("Notes (in full with --format json): " + list, 2) + "\n";
    }
    return out;
}

}  // namespace bioprint
