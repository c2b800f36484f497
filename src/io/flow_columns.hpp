#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/units.hpp"

/// Which columns of a rheometer's table are shear rate, viscosity and shear stress: by the unit first, by the name
/// among those of one unit, in the languages instruments speak. A column of logarithms is none of them.
namespace bioprint {

struct ColumnHead {
    std::string name;
    std::string unit;  ///< as written, without brackets; empty where none is
};

struct FlowColumn {
    std::size_t index = 0;
    double factor = 1.0;  ///< to SI
    std::string label;    ///< "Shear Rate [1/s]"
    bool unit_assumed = false;
};

/// Viscosity is measured, or stress over rate; a rate may be stress over viscosity.
struct FlowColumns {
    std::optional<FlowColumn> rate;
    std::optional<FlowColumn> viscosity;
    std::optional<FlowColumn> stress;
    std::optional<std::size_t> temperature;  ///< in °C
    bool oscillation =
        false;  ///< the table is of an oscillatory test: it has an angular frequency and no rate
    std::vector<std::string> remarks;
    [[nodiscard]] bool complete() const { return (rate && (viscosity || stress)) || (viscosity && stress); }
};

FlowColumns find_flow_columns(const std::vector<ColumnHead>& heads);

/// A unit in brackets, or bare where it is one: "[1/s]", "(Pa s)", "Pa.s", "°C", "[]". Without its brackets.
std::optional<std::string> unit_text(std::string_view field);

/// "Shear rate [1/s]", "Viscosity (Pa.s)", "Schubspannung in Pa" into name and unit.
ColumnHead split_head(std::string_view field);

/// "'Time [s]', 'Torque [mN·m]'".
std::string list_of_heads(const std::vector<ColumnHead>& heads);

/// "; the unit 'dyn/cm2' is not known" for the first column that has one; else empty.
std::string unknown_units(const std::vector<ColumnHead>& heads);
inline constexpr std::string_view unit_not_known = " is not known here";

/// "; 'log viscosity [Pa.s]' …" of the columns left alone because they hold logarithms; else empty.
std::string logarithms(const std::vector<ColumnHead>& heads);
inline constexpr std::string_view log_not_read = ": logarithms are not read";

}  // namespace bioprint
