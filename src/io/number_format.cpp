#include "bioprint/io/number_format.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <span>
#include <utility>

namespace bioprint {

namespace {

std::span<const LabUnit> lab_units(Dimension dimension) {
    static constexpr std::array<LabUnit, 1> plain = {{{1.0, ""}}};
    static constexpr std::array<LabUnit, 4> lengths = {
        {{1e-9, "nm"}, {1e-6, "µm"}, {1e-3, "mm"}, {1.0, "m"}}};
    static constexpr std::array<LabUnit, 6> flows = {
        {{1e-15, "pL/s"}, {1e-12, "nL/s"}, {1e-9, "µL/s"}, {1e-6, "mL/s"}, {1e-3, "L/s"}, {1.0, "m³/s"}}};
    static constexpr std::array<LabUnit, 4> velocities = {
        {{1e-9, "nm/s"}, {1e-6, "µm/s"}, {1e-3, "mm/s"}, {1.0, "m/s"}}};
    static constexpr std::array<LabUnit, 5> pressures = {
        {{1e-3, "mPa"}, {1.0, "Pa"}, {1e3, "kPa"}, {1e6, "MPa"}, {1e9, "GPa"}}};
    static constexpr std::array<LabUnit, 4> gradients = {
        {{1.0, "Pa/m"}, {1e3, "kPa/m"}, {1e6, "MPa/m"}, {1e9, "GPa/m"}}};
    static constexpr std::array<LabUnit, 4> viscosities = {
        {{1e-6, "µPa s"}, {1e-3, "mPa s"}, {1.0, "Pa s"}, {1e3, "kPa s"}}};
    static constexpr std::array<LabUnit, 4> times = {{{1e-9, "ns"}, {1e-6, "µs"}, {1e-3, "ms"}, {1.0, "s"}}};
    static constexpr std::array<LabUnit, 1> rates = {{{1.0, "1/s"}}};
    static constexpr std::array<LabUnit, 1> consistencies = {{{1.0, "Pa s^n"}}};
    switch (dimension) {
        case Dimension::dimensionless:
            return plain;
        case Dimension::length:
            return lengths;
        case Dimension::volume_flow:
            return flows;
        case Dimension::velocity:
            return velocities;
        case Dimension::pressure:
            return pressures;
        case Dimension::pressure_gradient:
            return gradients;
        case Dimension::viscosity:
            return viscosities;
        case Dimension::time:
            return times;
        case Dimension::rate:
            return rates;
        case Dimension::consistency:
            return consistencies;
    }
    return plain;
}

/// The unit a zero is written in.
std::string_view usual_name(Dimension dimension) {
    switch (dimension) {
        case Dimension::length:
            return "µm";
        case Dimension::volume_flow:
            return "µL/s";
        case Dimension::velocity:
            return "mm/s";
        case Dimension::pressure:
            return "Pa";
        case Dimension::pressure_gradient:
            return "MPa/m";
        case Dimension::viscosity:
            return "Pa s";
        case Dimension::time:
            return "ms";
        default:
            return {};
    }
}

constexpr int most_digits = 17;

/// Mantissa with `digits` digits and the exponent of ten: 1.740e+07.
struct Scientific {
    std::string digits;  ///< without point and sign, trailing zeros removed
    int exponent;
    bool negative;
};

Scientific to_scientific(double value, int digits) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), std::abs(value),
                                   std::chars_format::scientific, std::clamp(digits, 1, most_digits) - 1)
                         .ptr;
    const std::string_view written(text.data(), static_cast<std::size_t>(end - text.data()));
    const auto e = written.find('e');
    Scientific result{.digits = {}, .exponent = 0, .negative = std::signbit(value)};
    for (const char c : written.substr(0, e)) {
        if (c != '.') result.digits += c;
    }
    while (result.digits.size() > 1 && result.digits.back() == '0') result.digits.pop_back();
    auto exponent = written.substr(e + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), result.exponent);
    return result;
}

}  // namespace

void append_shortest(std::string& out, double value) {
    if (value == 0.0) value = 0.0;  // no minus
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value == 0.0 ? 0.0 : value).ptr;
    out.append(text.data(), end);
}

std::string format_shortest(double value) {
    std::string out;
    append_shortest(out, value);
    return out;
}

const LabUnit& choose_lab_unit(double magnitude, Dimension dimension, int digits) {
    const auto units = lab_units(dimension);
    if (magnitude == 0.0 || !std::isfinite(magnitude)) {
        const auto usual = std::find_if(units.begin(), units.end(), [&](const LabUnit& unit) {
            return unit.name == usual_name(dimension);
        });
        return usual == units.end() ? units.back() : *usual;
    }
    // From the largest: the first unit in which the rounded number is at least 1.
    for (auto unit = units.rbegin(); unit != units.rend(); ++unit) {
        if (to_scientific(magnitude / unit->in_si, digits).exponent >= 0) return *unit;
    }
    return units.front();
}

std::string format_in(double value, const LabUnit& unit, int digits) {
    constexpr int largest_plain = 6;
    constexpr int smallest_plain = -4;
    const double number = value / unit.in_si;
    if (!std::isfinite(number)) return "n/a";
    if (number == 0.0) return "0";
    const auto [mantissa, exponent, negative] = to_scientific(number, digits);
    std::string out;
    if (negative) out += '-';
    if (exponent > largest_plain || exponent < smallest_plain) {
        out += mantissa[0];
        if (mantissa.size() > 1) out.append(".").append(mantissa, 1);
        const int size = std::abs(exponent);
        return out.append(exponent < 0 ? "e-" : "e+")
            .append(size < 10 ? "0" : "")
            .append(std::to_string(size));
    }
    if (exponent < 0) {
        out.append("0.").append(static_cast<std::size_t>(-exponent) - 1, '0').append(mantissa);
        return out;
    }
    const auto whole = static_cast<std::size_t>(exponent) + 1;
    if (mantissa.size() <= whole) {
        out.append(mantissa).append(whole - mantissa.size(), '0');
        return out;
    }
    out.append(mantissa, 0, whole).append(".").append(mantissa, whole);
    return out;
}

LabNumber format_lab(double value, Dimension dimension, int digits) {
    const LabUnit& unit = choose_lab_unit(value, dimension, digits);
    return {.number = format_in(value, unit, digits), .unit = std::string(unit.name)};
}

std::string lab_text(double value, Dimension dimension, int digits) {
    LabNumber n = format_lab(value, dimension, digits);
    return n.unit.empty() ? std::move(n.number) : std::move(n.number).append(" ").append(n.unit);
}

std::string bare_text(double value, int digits) {
    return format_lab(value, Dimension::dimensionless, digits).number;
}

std::string percent_text(double share, int digits) {
    return bare_text(100.0 * share, digits).append(" %");
}

}  // namespace bioprint
