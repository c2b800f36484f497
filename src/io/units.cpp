#include "io/units.hpp"

#include <array>
#include <cstdlib>
#include <utility>

namespace bioprint {

namespace {

constexpr std::size_t longest_unit = 40;

struct NamedUnit {
    std::string_view name;
    std::string_view prefixes;  ///< the SI prefixes it is used with
    ExactFactor factor;
    Powers powers;
};

constexpr Powers none{};
constexpr Powers length{.metre = 1};
constexpr Powers volume{.metre = 3};
constexpr Powers mass{.kilogram = 1};
constexpr Powers duration{.second = 1};
constexpr Powers frequency{.second = -1};
constexpr Powers force{.kilogram = 1, .metre = 1, .second = -2};
constexpr Powers pressure{.kilogram = 1, .metre = -1, .second = -2};
constexpr Powers dynamic_viscosity{.kilogram = 1, .metre = -1, .second = -1};
constexpr Powers consistency{.kilogram = 1, .metre = -1, .second = -2, .second_to_n = 1};

/// Factors to SI, exact by definition: the inch is 25.4 mm, the pound-force 4.4482216152605 N, the standard
/// atmosphere 101325 Pa (BIPM, SI brochure, 9th ed.; NIST SP 811, appendix B.8).
constexpr std::array<NamedUnit, 28> table = {{
    {"m", "numc", {.power = 0}, length},
    {"in", "", {.numerator = 254, .power = -4}, length},
    {"inch", "", {.numerator = 254, .power = -4}, length},
    {"mil", "", {.numerator = 254, .power = -7}, length},
    {"thou", "", {.numerator = 254, .power = -7}, length},
    {"micron", "", {.power = -6}, length},
    {"L", "pnumcd", {.power = -3}, volume},
    {"l", "pnumcd", {.power = -3}, volume},
    {"cc", "", {.power = -6}, volume},
    {"g", "num", {.power = -3}, mass},
    {"kg", "", {.power = 0}, mass},
    {"s", "num", {.power = 0}, duration},
    {"sec", "", {.power = 0}, duration},
    {"min", "", {.numerator = 60}, duration},
    {"h", "", {.numerator = 3600}, duration},
    {"hr", "", {.numerator = 3600}, duration},
    {"Hz", "mkM", {.power = 0}, frequency},
    {"N", "num", {.power = 0}, force},
    {"Pa", "umhkMG", {.power = 0}, pressure},
    {"bar", "um", {.power = 5}, pressure},
    {"psi", "", {.numerator = 44482216152605, .denominator = 64516, .power = -5}, pressure},
    {"atm", "", {.numerator = 101325}, pressure},
    {"P", "mc", {.power = -1}, dynamic_viscosity},
    {"Pas", "umk", {.power = 0}, dynamic_viscosity},
    {"sn", "", {.power = 0}, {.second_to_n = 1}},
    {"Pasn", "umk", {.power = 0}, consistency},
    {"%", "", {.power = -2}, none},
    {"Rc", "", {.power = 0}, {.cell_radius = 1}},
}};

int prefix_power(char prefix) {
    switch (prefix) {
        case 'p':
            return -12;
        case 'n':
            return -9;
        case 'u':
            return -6;
        case 'm':
            return -3;
        case 'c':
            return -2;
        case 'd':
            return -1;
        case 'h':
            return 2;
        case 'k':
            return 3;
        case 'M':
            return 6;
        default:
            return 9;  // G; the table allows no other
    }
}

std::optional<Unit> find_name(std::string_view name) {
    for (const auto& unit : table) {
        if (unit.name == name) return Unit{.factor = unit.factor, .powers = unit.powers};
    }
    if (name.size() < 2) return {};
    for (const auto& unit : table) {
        if (unit.name == name.substr(1) && unit.prefixes.find(name[0]) != std::string_view::npos) {
            Unit found{.factor = unit.factor, .powers = unit.powers};
            found.factor.power += prefix_power(name[0]);
            return found;
        }
    }
    return {};
}

/// The spellings Unicode offers, in ASCII: both micro signs (and the one byte of Latin-1), superscripts, the
/// product dots, the minus sign, the wide spaces.
constexpr std::array<std::pair<std::string_view, std::string_view>, 19> ascii_forms = {{
    {"\u00B5", "u"}, {"\u03BC", "u"}, {"\u00B7", "."}, {"\u22C5", "."}, {"\u00D7", "."},
    {"\u2212", "-"}, {"\u207B", "-"}, {"s^n", "sn"},   {"\u207F", "n"}, {"\u00B9", "1"},
    {"\u00B2", "2"}, {"\u00B3", "3"}, {"\u2044", "/"}, {"\u2215", "/"}, {"\u00A0", " "},
    {"\u202F", " "}, {"\u2009", " "}, {"\t", " "},     {"\xB5", "u"},
}};

std::string to_ascii(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        std::size_t used = 0;
        for (const auto& [from, to] : ascii_forms) {
            if (text.starts_with(from)) {
                out += to;
                used = from.size();
                break;
            }
        }
        if (used == 0) {
            out += text[0];
            used = 1;
        }
        text.remove_prefix(used);
    }
    return out;
}

bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%';
}

/// Reads a unit from left to right.
class UnitReader {
  public:
    explicit UnitReader(std::string_view text) : text_(text) {}

    std::optional<Unit> read() {
        Unit unit;
        char separator = '.';
        if (text_.starts_with("1/")) ++at_;
        if (peek() == '/') separator = take_separator();
        while (separator != '\0') {
            if (!factor(unit, separator == '/')) return {};
            if (at_ == text_.size()) return unit;
            separator = take_separator();
        }
        return {};
    }

  private:
    [[nodiscard]] char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    /// Skips spaces around at most one sign of a product or quotient. '/' for a quotient, '.' for a product,
    /// 0 for neither.
    char take_separator() {
        const std::size_t start = at_;
        while (peek() == ' ') ++at_;
        const char c = peek();
        if (c == '.' || c == '*' || c == '/' || c == '-') ++at_;
        while (peek() == ' ') ++at_;
        if (at_ == start) return '\0';
        return c == '/' ? '/' : '.';
    }

    bool factor(Unit& unit, bool divide) {
        const std::size_t start = at_;
        while (is_name(peek())) ++at_;
        const auto found = find_name(text_.substr(start, at_ - start));
        if (!found) return false;
        const auto power = read_power();
        if (!power) return false;
        return raise(unit, *found, divide ? -*power : *power);
    }

    std::optional<int> read_power() {
        std::size_t i = at_;
        const bool caret = i < text_.size() && text_[i] == '^';
        if (caret) ++i;
        const bool negative = i < text_.size() && text_[i] == '-';
        if (negative) ++i;
        if (i >= text_.size() || text_[i] < '0' || text_[i] > '9') return caret ? std::optional<int>{} : 1;
        const int power = text_[i] - '0';
        at_ = i + 1;
        if (power == 0 || (at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9')) return {};
        return negative ? -power : power;
    }

    static bool raise(Unit& unit, const Unit& by, int power) {
        const ExactFactor factor = power < 0 ? inverse(by.factor) : by.factor;
        for (int i = 0; i < std::abs(power); ++i) {
            const auto next = multiply(unit.factor, factor);
            if (!next) return false;
            unit.factor = *next;
        }
        unit.powers.kilogram += power * by.powers.kilogram;
        unit.powers.metre += power * by.powers.metre;
        unit.powers.second += power * by.powers.second;
        unit.powers.cell_radius += power * by.powers.cell_radius;
        unit.powers.second_to_n += power * by.powers.second_to_n;
        return true;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
    if (text.empty() || text.size() > longest_unit) return {};
    const std::string ascii = to_ascii(text);
    return UnitReader(ascii).read();
}

Powers powers_of(Dimension dimension) {
    switch (dimension) {
        case Dimension::dimensionless:
            return none;
        case Dimension::length:
            return length;
        case Dimension::volume_flow:
            return {.metre = 3, .second = -1};
        case Dimension::velocity:
            return {.metre = 1, .second = -1};
        case Dimension::pressure:
            return pressure;
        case Dimension::pressure_gradient:
            return {.kilogram = 1, .metre = -2, .second = -2};
        case Dimension::viscosity:
            return dynamic_viscosity;
        case Dimension::time:
            return duration;
        case Dimension::rate:
            return frequency;
        case Dimension::consistency:
            return consistency;
    }
    return none;
}

std::string_view kind_name(const Powers& powers) {
    for (const auto dimension :
         {Dimension::dimensionless, Dimension::length, Dimension::volume_flow, Dimension::velocity,
          Dimension::pressure, Dimension::pressure_gradient, Dimension::viscosity, Dimension::time,
          Dimension::rate, Dimension::consistency}) {
        if (powers == powers_of(dimension)) return dimension_name(dimension);
    }
    if (powers == Powers{.metre = 2}) return "an area";
    if (powers == volume) return "a volume";
    if (powers == mass) return "a mass";
    if (powers == force) return "a force";
    if (powers == Powers{.kilogram = 1, .second = -1}) return "a mass flow";
    if (powers == Powers{.cell_radius = 1}) return "a length in cell radii";
    return "a quantity of another kind";
}

std::span<const std::string_view> usual_units(Dimension dimension) {
    using Names = std::string_view;
    static constexpr std::array<Names, 2> plain = {"1", "%"};
    static constexpr std::array<Names, 9> lengths = {"um", "mm",  "cm",   "m",     "nm",
                                                     "in", "mil", "inch", "micron"};
    static constexpr std::array<Names, 16> flows = {"uL/s",   "uL/min", "uL/h",    "mL/h", "mL/min", "mL/s",
                                                    "nL/s",   "nL/min", "mm3/s",   "m3/s", "L/s",    "L/min",
                                                    "mm^3/s", "cm3/s",  "mm3/min", "m^3/s"};
    static constexpr std::array<Names, 6> velocities = {"mm/s", "cm/s", "m/s", "um/s", "mm/min", "m/min"};
    static constexpr std::array<Names, 9> pressures = {"kPa", "Pa",   "bar", "psi", "MPa",
                                                       "GPa", "mbar", "hPa", "atm"};
    static constexpr std::array<Names, 7> gradients = {"MPa/m",  "Pa/m",   "kPa/m", "bar/m",
                                                       "bar/mm", "kPa/mm", "psi/in"};
    static constexpr std::array<Names, 6> viscosities = {"Pa.s", "mPa.s", "cP", "P", "Pa s", "mPas"};
    static constexpr std::array<Names, 6> times = {"s", "ms", "us", "ns", "min", "h"};
    static constexpr std::array<Names, 6> rates = {"1/s", "/s", "s^-1", "Hz", "1/min", "s-1"};
    static constexpr std::array<Names, 4> consistencies = {"Pa.s^n", "mPa.s^n", "kPa.s^n", "Pa s^n"};
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

}  // namespace bioprint
