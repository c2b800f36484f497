#include "io/flow_columns.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "io/text.hpp"

namespace bioprint {
namespace {

using Words = std::span<const std::string_view>;

// Parts of names, in lower case (ASCII letters; others as they are mostly written).
constexpr std::array<std::string_view, 26> rate_words = {
    "rate",           "shearrate",    "shear_rate",      "strain rate", "scherrate",       "schergef",
    "schergeschwind", "cisaillement", "gradient de vit", "cizalla",     "velocidad de co", "velocidad de def",
    "taglio",         "gradiente",    "cisalhamento",    "afschuif",    "скорость сдвига", "Скорость сдвига",
    "剪切速率",       "剪切率",       "せん断速度",      "ずり速度",    "전단율",          "전단속도",
    "\u03b3",         "gamma"};
constexpr std::array<std::string_view, 14> viscosity_words = {
    "viscosi", "viskosi", "viscosité", "viscosità", "вязкость", "Вязкость", "粘度",
    "黏度",    "점도",    "lepko",     "eta",       "\u03b7",   "visc",     "visco"};
constexpr std::array<std::string_view, 16> stress_words = {
    "stress",   "schubspann", "scherspann", "contrainte", "esfuerzo", "tensión", "sforzo", "tensão",
    "spanning", "напряжение", "Напряжение", "应力",       "応力",     "응력",    "\u03c4", "tension de c"};
constexpr std::array<std::string_view, 13> not_rate = {
    "freq",        "speed",     "drehzahl", "rotation", "rpm",  "angular", "velocidad angular",
    "vitesse ang", "kreisfreq", "频率",     "回転",     "周波", "elong"};
constexpr std::array<std::string_view, 12> not_viscosity = {"complex", "komplex", "complej", "comples",
                                                            "im(",     "re(",     "extens",  "intrins",
                                                            "|",       "*",       "\u2032",  "复数"};
constexpr std::array<std::string_view, 11> not_stress = {"modul", "normal",   "yield",        "oscill",
                                                         "g'",    "g\u2032",  "flie\u00dfgr", "complex",
                                                         "n1",    "baseline", "模量"};
constexpr std::array<std::string_view, 6> oscillation_words = {"angular freq", "kreisfreq", "frequen",
                                                               "角频率",       "角周波",    "fréquen"};

bool has_any(const std::string& name, Words words) {
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

/// "log viscosity", "lg(eta)", "log10 rate", "ln_rate", "logarithmic"; not "logger".
bool is_logarithm(const std::string& name) {
    if (name.starts_with("logarith")) return true;
    for (const std::string_view word : {"log10", "log", "lg", "ln"}) {
        if (!name.starts_with(word)) continue;
        const char next = name.size() > word.size() ? name[word.size()] : ' ';
        if (word == "log10" || !((next >= 'a' && next <= 'z') || (next >= '0' && next <= '9'))) return true;
    }
    return false;
}

std::string label_of(const ColumnHead& head) {
    if (head.unit.empty()) return head.name;
    return head.name.empty() ? "[" + head.unit + "]" : head.name + " [" + head.unit + "]";
}

struct Kind {
    Dimension dimension;
    Words words;
    Words exclusions;
    bool by_unit_alone;  ///< a unit that nothing else has, so that a column needs no known name
};

/// The column of a kind: of those with its unit the one with its name, else the first; without such a unit, one with
/// its name and no unit at all, taken as SI.
std::optional<FlowColumn> find_kind(const std::vector<ColumnHead>& heads, const Kind& kind,
                                    std::vector<std::string>& remarks) {
    struct Found {
        FlowColumn column;
        int rank;
    };
    std::vector<Found> found;
    for (std::size_t i = 0; i < heads.size(); ++i) {
        const std::string name = lower_case(heads[i].name);
        if (has_any(name, kind.exclusions) || is_logarithm(name)) continue;
        const bool named = has_any(name, kind.words);
        const std::optional<Unit> unit = parse_unit(heads[i].unit);
        const bool right_unit = unit && unit->powers == powers_of(kind.dimension);
        FlowColumn column{.index = i, .factor = 1.0, .label = label_of(heads[i])};
        if (right_unit) {
            column.factor =
                static_cast<double>(unit->factor.numerator) / static_cast<double>(unit->factor.denominator);
            for (int k = 0; k < unit->factor.power; ++k) column.factor *= 10.0;
            double divisor = 1.0;
            for (int k = 0; k > unit->factor.power; --k) divisor *= 10.0;
            column.factor /= divisor;
            if (named || kind.by_unit_alone) found.push_back({column, named ? 0 : 1});
        } else if (heads[i].unit.empty() && named) {
            column.unit_assumed = true;
            found.push_back({column, 2});
        }
    }
    if (found.empty()) return {};
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.rank < b.rank; });
    if (found.size() > 1 && found[1].rank == found[0].rank) {
        remarks.push_back("of the columns " + in_quotes(found[0].column.label) + " and " +
                          in_quotes(found[1].column.label) + " the first is used");
    }
    return found.front().column;
}

/// "°C" in its spellings.
bool is_celsius(std::string_view unit) {
    return unit == "\u00b0C" || unit == "\u2103" || unit == "degC" || unit == "C" || unit == "\u00baC";
}

}  // namespace

std::optional<std::string> unit_text(std::string_view field) {
    const std::string_view text = trimmed(field);
    if (text.size() >= 2 &&
        ((text.front() == '[' && text.back() == ']') || (text.front() == '(' && text.back() == ')'))) {
        return std::string(trimmed(text.substr(1, text.size() - 2)));
    }
    static constexpr std::array<std::string_view, 8> others = {"\u00b0C", "rad/s", "rad", "\u00b0F",
                                                               "K",       "%",     "deg", "1"};
    if (std::find(others.begin(), others.end(), text) != others.end() || is_celsius(text) ||
        parse_unit(text)) {
        return std::string(text);
    }
    return {};
}

ColumnHead split_head(std::string_view field) {
    const std::string_view text = trimmed(field);
    for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
        if (text.empty() || text.back() != close) continue;
        const std::size_t at = text.rfind(open);
        if (at == std::string_view::npos || at == 0) continue;
        const std::string_view inside = trimmed(text.substr(at + 1, text.size() - at - 2));
        // "Viscosity (corrected)": only a unit is cut off, or what stands in square brackets.
        if (open == '[' || unit_text(inside)) {
            std::string_view name = trimmed(text.substr(0, at));
            if (name.ends_with('/')) name = trimmed(name.substr(0, name.size() - 1));  // Scherrate/(1/s)
            return {std::string(name), std::string(inside)};
        }
    }
    for (const std::string_view link : {" in ", ", ", "/", "_"}) {
        const std::size_t at = text.find(link);
        if (at == std::string_view::npos || at == 0) continue;
        const std::string_view behind = trimmed(text.substr(at + link.size()));
        if (behind != "1" && unit_text(behind)) {
            return {std::string(trimmed(text.substr(0, at))), std::string(behind)};
        }
    }
    return {std::string(text), {}};
}

FlowColumns find_flow_columns(const std::vector<ColumnHead>& heads) {
    FlowColumns columns;
    // The names of stress hold those of rate in many languages ("contrainte de cisaillement"), so units decide first.
    std::vector<std::string_view> rate_exclusions(not_rate.begin(), not_rate.end());
    rate_exclusions.insert(rate_exclusions.end(), stress_words.begin(), stress_words.end());
    rate_exclusions.insert(rate_exclusions.end(),
                           {"modul", "viscosi", "viskosi", "déformation", "time", "zeit"});
    columns.viscosity =
        find_kind(heads, {Dimension::viscosity, viscosity_words, not_viscosity, true}, columns.remarks);
    columns.rate = find_kind(heads, {Dimension::rate, rate_words, rate_exclusions, true}, columns.remarks);
    columns.stress =
        find_kind(heads, {Dimension::pressure, stress_words, not_stress, false}, columns.remarks);
    for (const auto& column : {columns.viscosity, columns.rate, columns.stress}) {
        if (column && column->unit_assumed) {
            columns.remarks.push_back("the column " + in_quotes(column->label) + " has no unit: taken as SI");
        }
    }
    for (std::size_t i = 0; i < heads.size(); ++i) {
        if (is_celsius(heads[i].unit) && !columns.temperature) columns.temperature = i;
        if (has_any(lower_case(heads[i].name), oscillation_words) && !columns.rate)
            columns.oscillation = true;
    }
    return columns;
}

std::string unknown_units(const std::vector<ColumnHead>& heads) {
    for (const ColumnHead& head : heads) {
        const std::string name = lower_case(head.name);
        const bool meant =
            has_any(name, rate_words) || has_any(name, viscosity_words) || has_any(name, stress_words);
        if (!meant || head.unit.empty() || unit_text(head.unit)) continue;
        return "; the unit " + in_quotes(head.unit) + std::string(unit_not_known);
    }
    return {};
}

std::string logarithms(const std::vector<ColumnHead>& heads) {
    std::vector<ColumnHead> found;
    for (const ColumnHead& head : heads) {
        const std::string name = lower_case(head.name);
        const bool meant =
            has_any(name, rate_words) || has_any(name, viscosity_words) || has_any(name, stress_words);
        if (meant && is_logarithm(name)) found.push_back(head);
    }
    return found.empty() ? std::string{} : "; " + list_of_heads(found) + std::string(log_not_read);
}

std::string list_of_heads(const std::vector<ColumnHead>& heads) {
    std::string list;
    for (const ColumnHead& head : heads) {
        if (head.name.empty() && head.unit.empty()) continue;
        list += (list.empty() ? "" : ", ") + in_quotes(label_of(head));
    }
    return list;
}

}  // namespace bioprint
