#include "io/preset_list.hpp"

#include <algorithm>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "bioprint/io/presets.hpp"
#include "io/ink_text.hpp"

namespace bioprint {
namespace {

using Row = std::vector<std::string>;

std::string lab(const std::optional<double>& value, Dimension dimension) {
    return value ? lab_text(*value, dimension) : "-";
}

std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

/// Left-aligned columns; the last one may be of any length.
std::string aligned(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    }
    std::string out;
    for (const Row& row : rows) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) {
            out += row[i] + std::string(widths[i] - width_of(row[i]) + 2, ' ');
        }
        out += row.back() + "\n";
    }
    return out;
}

std::string ink_list() {
    std::vector<Row> rows = {{"name", "law", "parameters", "at", "grade", "source"}};
    for (const InkPreset& p : ink_presets()) {
        rows.push_back({p.name, std::string(law_name(p.ink)), ink_text(p.ink),
                        p.temperature ? lab(*p.temperature, Dimension::dimensionless) + " °C" : "-", p.grade,
                        p.source});
    }
    return aligned(rows);
}

std::string cell_list() {
    std::vector<Row> rows = {{"name", "radius", "shear modulus", "grade", "what", "source"}};
    for (const CellPreset& p : cell_presets()) {
        rows.push_back({p.name, lab(p.radius, Dimension::length), lab(p.shear_modulus, Dimension::pressure),
                        p.grade, p.cell, p.source});
    }
    return aligned(rows);
}

std::string nozzle_list() {
    std::vector<Row> rows = {{"name", "radius", "grade", "source"}};
    for (const NozzlePreset& p : nozzle_presets()) {
        rows.push_back({p.name, lab(p.radius, Dimension::length), p.grade, p.source});
    }
    return aligned(rows);
}

}  // namespace

std::string preset_list(std::string_view kind) {
    if (kind == "inks") return ink_list();
    if (kind == "cells") return cell_list();
    if (kind == "nozzles") return nozzle_list();
    throw UsageError("--list: takes inks, cells or nozzles", "--list");
}

}  // namespace bioprint
