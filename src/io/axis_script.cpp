#include "io/axis_script.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/io/number_format.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr int most_numbers = 7;          ///< of decades on a logarithmic axis
constexpr double numbers_between = 2.3;  ///< decades up to which 2 and 5 have a number too
constexpr double room = 1.2;             ///< between a curve and the end of a logarithmic axis
constexpr std::array mantissas = {1.0, 2.0, 5.0};

std::string superscript(int exponent) {
    static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent))) {
        out += digits.at(static_cast<std::size_t>(digit - '0'));
    }
    return out;
}

/// "0.01", "500", "10⁶", "2·10⁶".
std::string decade_label(int mantissa, int exponent) {
    constexpr int longest = 4;  // zeros a reader can count
    if (std::abs(exponent) <= longest) return format_shortest(mantissa * std::pow(10.0, exponent));
    return (mantissa == 1 ? "" : std::to_string(mantissa) + "·") + "10" + superscript(exponent);
}

std::string log_tics(const LogRange& range) {
    const int first = static_cast<int>(std::floor(std::log10(range.low) + 1e-9));
    const int last = static_cast<int>(std::ceil(std::log10(range.high) - 1e-9));
    const double decades = std::log10(range.high / range.low);
    const int step = std::max(1, (last - first + most_numbers - 1) / most_numbers);
    std::string tics;
    const auto add = [&](const std::string& text, double value, int level) {
        tics += (tics.empty() ? "" : ", ") + gnuplot_text(text) + " " + gnuplot_number(value) + " " +
                std::to_string(level);
    };
    for (int exponent = first; exponent <= last; ++exponent) {
        for (int mantissa = 1; mantissa <= 9; ++mantissa) {
            const bool numbered = mantissa == 1
                                      ? (exponent - first) % step == 0
                                      : decades <= numbers_between && (mantissa == 2 || mantissa == 5);
            if (!numbered && step > 1) continue;
            const double value = mantissa * std::pow(10.0, exponent);
            add(numbered ? decade_label(mantissa, exponent) : "", value, numbered ? 0 : 1);
        }
    }
    return "(" + tics + ")";
}

std::string linear_range(const Axis& axis, const Scale& scale, const Extent& extent) {
    const auto bound = [&](const std::optional<double>& value) {
        return value ? gnuplot_number(scale(*value)) : "*";
    };
    std::string low = bound(axis.min);
    // A linear axis shows its zero, so that heights can be compared.
    if (!axis.min && extent.low >= 0.0 && !extent.empty) low = "0";
    std::string high = bound(axis.max);
    if (!axis.max && extent.high <= 0.0 && extent.low >= 0.0) high = "1";
    return "[" + low + ":" + high + "]";
}

}  // namespace

void Extent::add(double value) {
    if (!std::isfinite(value)) return;
    low = empty ? value : std::min(low, value);
    high = empty ? value : std::max(high, value);
    empty = false;
}

double Extent::magnitude() const {
    return std::max(std::abs(low), std::abs(high));
}

Extent extent_of(const Panel& panel, bool of_x) {
    Extent extent;
    for (const Series& series : panel.series) {
        for (const double value : of_x ? series.x : series.y) extent.add(value);
        if (series.mark == Mark::points || series.mark == Mark::line_points) extent.has_points = true;
        if (of_x) continue;
        for (const double value : series.low) extent.add(value);
        for (const double value : series.high) extent.add(value);
    }
    const Axis& axis = of_x ? panel.x : panel.y;
    if (axis.min) extent.add(*axis.min);
    if (axis.max) extent.add(*axis.max);
    return extent;
}

Scale scale_of(const Axis& axis, const Extent& extent) {
    if (!axis.dimension || *axis.dimension == Dimension::dimensionless) return {1.0, axis.title};
    // Over decades the middle one is read, not the highest.
    const bool decades = axis.logarithmic && extent.low > 0.0;
    const double read = decades ? std::sqrt(extent.low * extent.high) : extent.magnitude();
    const LabUnit& unit = choose_lab_unit(read, *axis.dimension);
    return {unit.in_si, axis.title + " [" + std::string(unit.name) + "]"};
}

LogRange log_range(double low, double high) {
    const double decade_low = std::pow(10.0, std::floor(std::log10(low / room)));
    double below = decade_low;
    for (const double m : mantissas) {
        if (m * decade_low <= low / room) below = m * decade_low;
    }
    const double decade_high = std::pow(10.0, std::floor(std::log10(high * room)));
    double above = 10.0 * decade_high;
    for (const double m : {5.0, 2.0, 1.0}) {
        if (m * decade_high >= high * room) above = m * decade_high;
    }
    return {below, above};
}

std::string axis_commands(std::string_view name, const Axis& axis, const Scale& scale, const Extent& extent) {
    const std::string n(name);
    std::string out = "set " + n + "label " + gnuplot_text(scale.title) + "\n";
    const bool logarithmic = axis.logarithmic && extent.low > 0.0;
    out += (logarithmic ? "set logscale " : "unset logscale ") + n + "\n";
    if (logarithmic) {
        LogRange range = log_range(scale(extent.low), scale(extent.high));
        if (axis.min) range.low = scale(*axis.min);
        if (axis.max) range.high = scale(*axis.max);
        return out + "set " + n + "range [" + gnuplot_number(range.low) + ":" + gnuplot_number(range.high) +
               "]\nset " + n + "tics nomirror " + log_tics(range) + "\n";
    }
    out += "set " + n + "range " + linear_range(axis, scale, extent) + "\n";
    if (axis.names.empty()) return out + "set " + n + "tics nomirror autofreq\n";
    std::string tics;
    for (const auto& [value, text] : axis.names) {
        tics += (tics.empty() ? "" : ", ") + gnuplot_text(text) + " " + gnuplot_number(scale(value));
    }
    return out + "set " + n + "tics nomirror (" + tics + ")\n";
}

std::string gnuplot_text(std::string_view text) {
    std::string out = "'";
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const auto byte = static_cast<unsigned char>(text.front());
        if (length == 0 || (length == 1 && (byte < 0x20 || byte == 0x7F))) {
            out += length == 0 ? "\xEF\xBF\xBD" : " ";
        } else {
            out += text.substr(0, length);
            if (byte == '\'') out += '\'';
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out + "'";
}

std::string gnuplot_number(double value) {
    return format_shortest(value);
}

}  // namespace bioprint
