#include "io/preset_reader.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "bioprint/io/quantity.hpp"
#include "io/json_lines.hpp"
#include "io/text.hpp"
#include "numerics/correlation.hpp"

namespace bioprint {

namespace {

using PlainJson = nlohmann::json;

struct Value {
    double value;
    std::optional<double> sd;
    bool determined = true;
};

enum class Sign { positive, not_negative };

/// An object of the file with the path that leads to it.
class Node {
  public:
    Node(const PlainJson& json, std::string path) : json_(json), path_(std::move(path)) {
        if (!json_.is_object()) fail("", "is not an object");
    }

    [[noreturn]] void fail(std::string_view key, const std::string& problem) const {
        throw UsageError(name_of(key) + ": " + problem);
    }

    [[nodiscard]] bool has(const char* key) const { return json_.contains(key) && !json_[key].is_null(); }

    void allow_only(std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, value] : json_.items()) {
            if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
            const auto near = nearest(key, std::span(keys.begin(), keys.size()));
            fail(key,
                 "is not known here" + (near.empty() ? "" : " (did you mean '" + std::string(near) + "'?)"));
        }
    }

    [[nodiscard]] Node object(const char* key) const {
        if (!has(key)) fail(key, "is missing");
        return {json_[key], name_of(key)};
    }

    [[nodiscard]] std::vector<Node> objects(const char* key) const {
        std::vector<Node> nodes;
        if (!has(key)) return nodes;
        if (!json_[key].is_array()) fail(key, "is not a list");
        for (std::size_t i = 0; i < json_[key].size(); ++i) {
            nodes.emplace_back(json_[key][i], name_of(key) + "." + std::to_string(i));
        }
        return nodes;
    }

    [[nodiscard]] std::string text(const char* key) const {
        if (!has(key)) return {};
        if (!json_[key].is_string()) fail(key, "is not a text");
        return json_[key].get<std::string>();
    }

    [[nodiscard]] std::vector<std::string> texts(const char* key) const {
        std::vector<std::string> all;
        if (!has(key)) return all;
        if (!json_[key].is_array()) fail(key, "is not a list of texts");
        for (const auto& item : json_[key]) {
            if (!item.is_string()) fail(key, "is not a list of texts");
            all.push_back(item.get<std::string>());
        }
        return all;
    }

    [[nodiscard]] double number(const char* key) const {
        if (!has(key) || !json_[key].is_number()) fail(key, "is not a number");
        return json_[key].get<double>();
    }

    [[nodiscard]] bool truth(const char* key, bool otherwise) const {
        if (!has(key)) return otherwise;
        if (!json_[key].is_boolean()) fail(key, "is neither true nor false");
        return json_[key].get<bool>();
    }

    /// A square matrix by rows.
    [[nodiscard]] std::vector<double> matrix(const char* key, std::size_t size) const {
        const std::string shape =
            "is not a list of " + std::to_string(size) + " rows of " + std::to_string(size) + " numbers";
        std::vector<double> numbers;
        if (!has(key) || !json_[key].is_array() || json_[key].size() != size) fail(key, shape);
        for (const PlainJson& row : json_[key]) {
            if (!row.is_array() || row.size() != size) fail(key, shape);
            for (const PlainJson& entry : row) {
                if (!entry.is_number()) fail(key, shape);
                numbers.push_back(entry.get<double>());
            }
        }
        return numbers;
    }

    /// {"value": …, "unit": …, "sd": …}, a text with a unit, or a number in SI.
    [[nodiscard]] std::optional<Value> quantity(const char* key, Dimension dimension, Sign sign) const {
        if (!has(key)) return {};
        const PlainJson& json = json_[key];
        Value result{.value = 0.0, .sd = {}};
        if (json.is_string()) {
            result.value = parse_quantity(json.get_ref<const std::string&>(), dimension, name_of(key));
        } else if (json.is_number()) {
            result.value = json.get<double>();
        } else {
            const Node node = object(key);
            node.allow_only({"value", "unit", "sd", "tolerance", "determined"});
            result.value = node.with_unit("value", dimension);
            const char* spread = node.has("tolerance") ? "tolerance" : "sd";
            if (node.has(spread)) result.sd = node.with_unit(spread, dimension);
            if (result.sd && *result.sd < 0.0) node.fail(spread, "is negative");
            result.determined = node.truth("determined", true);
        }
        if (result.value < 0.0 || (sign == Sign::positive && result.value == 0.0)) {
            fail(key, sign == Sign::positive ? "must be greater than 0" : "must not be negative");
        }
        return result;
    }

    [[nodiscard]] double with_unit(const char* key, Dimension dimension) const {
        std::string written = format_shortest(number(key));
        const std::string unit = text("unit");
        if (!unit.empty() && unit != "1") written.append(" ").append(unit);
        return parse_quantity(written, dimension, name_of(key));
    }

    [[nodiscard]] std::optional<double> temperature() const {
        if (!has("temperature")) return {};
        const Node node = object("temperature");
        node.allow_only({"value", "unit"});
        if (node.text("unit") != "degC") node.fail("unit", "must be degC");
        return node.number("value");
    }

  private:
    [[nodiscard]] std::string name_of(std::string_view key) const {
        if (key.empty()) return path_.ends_with(": ") ? path_.substr(0, path_.size() - 2) : path_;
        return path_ + (path_.ends_with(": ") ? "" : ".") + std::string(key);
    }

    const PlainJson& json_;
    std::string path_;
};

Value required(const Node& node, const char* key, Dimension dimension, Sign sign) {
    const auto value = node.quantity(key, dimension, sign);
    if (!value) node.fail(key, "is missing");
    return *value;
}

/// Reads the parameters of a law, one after the other, and keeps the spreads they state.
class LawReader {
  public:
    LawReader(const Node& parameters, InkPreset& preset) : parameters_(parameters), preset_(preset) {}

    double required(const char* key, Dimension dimension, Sign sign) {
        return kept(key, bioprint::required(parameters_, key, dimension, sign));
    }
    double optional(const char* key, Dimension dimension, Sign sign, double otherwise) {
        const auto value = parameters_.quantity(key, dimension, sign);
        return value ? kept(key, *value) : otherwise;
    }

  private:
    double kept(const char* key, const Value& value) {
        if (value.sd) preset_.spreads.push_back({.name = key, .sd = *value.sd});
        if (!value.determined) preset_.undetermined.emplace_back(key);
        return value.value;
    }

    const Node& parameters_;
    InkPreset& preset_;
};

CrossInk read_cross(const Node& parameters, LawReader read) {
    parameters.allow_only({"eta0", "eta_inf", "time_constant", "alpha"});
    const CrossInk law{.eta0 = read.required("eta0", Dimension::viscosity, Sign::positive),
                       .eta_inf = read.optional("eta_inf", Dimension::viscosity, Sign::not_negative, 0.0),
                       .time_constant = read.required("time_constant", Dimension::time, Sign::positive),
                       .alpha = read.required("alpha", Dimension::dimensionless, Sign::not_negative)};
    if (law.eta_inf > law.eta0) parameters.fail("eta_inf", "is larger than eta0");
    return law;
}

PowerLawInk read_power_law(const Node& parameters, LawReader read) {
    parameters.allow_only({"consistency", "flow_index"});
    return {.consistency = read.required("consistency", Dimension::consistency, Sign::positive),
            .flow_index = read.required("flow_index", Dimension::dimensionless, Sign::positive)};
}

CarreauYasudaInk read_carreau_yasuda(const Node& parameters, LawReader read) {
    parameters.allow_only({"eta0", "eta_inf", "time_constant", "transition", "flow_index"});
    const CarreauYasudaInk law{
        .eta0 = read.required("eta0", Dimension::viscosity, Sign::positive),
        .eta_inf = read.optional("eta_inf", Dimension::viscosity, Sign::not_negative, 0.0),
        .time_constant = read.required("time_constant", Dimension::time, Sign::positive),
        .transition = read.optional("transition", Dimension::dimensionless, Sign::positive, 2.0),
        .flow_index = read.required("flow_index", Dimension::dimensionless, Sign::not_negative)};
    if (law.eta_inf > law.eta0) parameters.fail("eta_inf", "is larger than eta0");
    return law;
}

HerschelBulkleyInk read_herschel_bulkley(const Node& parameters, LawReader read) {
    parameters.allow_only({"yield_stress", "consistency", "flow_index"});
    return {.yield_stress = read.required("yield_stress", Dimension::pressure, Sign::not_negative),
            .consistency = read.required("consistency", Dimension::consistency, Sign::positive),
            .flow_index = read.required("flow_index", Dimension::dimensionless, Sign::positive)};
}

Ink read_law(const Node& node, const Node& parameters, LawReader read) {
    const std::string law = node.text("law");
    if (law.empty() || law == "cross") return read_cross(parameters, read);
    if (law == "power-law") return read_power_law(parameters, read);
    if (law == "carreau-yasuda") return read_carreau_yasuda(parameters, read);
    if (law == "herschel-bulkley") return read_herschel_bulkley(parameters, read);
    node.fail("law", "must be cross, power-law, carreau-yasuda or herschel-bulkley");
}

std::optional<ParameterCorrelation> read_correlation(const Node& ink, const Node& parameters) {
    if (!ink.has("correlation")) return std::nullopt;
    const Node node = ink.object("correlation");
    node.allow_only({"parameters", "matrix"});
    ParameterCorrelation correlation{.parameters = node.texts("parameters"), .matrix = {}};
    std::vector<std::string>& names = correlation.parameters;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!parameters.has(names[i].c_str()))
            node.fail("parameters", "'" + names[i] + "' is none of this ink");
        if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
            names.begin() + static_cast<std::ptrdiff_t>(i)) {
            node.fail("parameters", "'" + names[i] + "' stands there twice");
        }
    }
    correlation.matrix = node.matrix("matrix", names.size());
    if (!is_correlation(correlation.matrix, names.size())) {
        node.fail("matrix",
                  "is no correlation: it must be symmetric, with 1 on its diagonal and no combination of "
                  "parameters of negative variance");
    }
    return correlation;
}

InkPreset read_ink(const Node& node) {
    node.allow_only({"name", "aliases", "material", "composition", "temperature", "law", "parameters",
                     "correlation", "shear_rate_range", "grade", "source", "note", "schema", "$schema"});
    InkPreset preset{.name = node.text("name"),
                     .aliases = node.texts("aliases"),
                     .material = node.text("material"),
                     .composition = node.text("composition"),
                     .temperature = node.temperature(),
                     .ink = {},
                     .spreads = {},
                     .undetermined = {},
                     .correlation = {},
                     .shear_rate_range = {},
                     .grade = node.text("grade"),
                     .source = node.text("source"),
                     .note = node.text("note")};
    const Node parameters = node.object("parameters");
    preset.ink = read_law(node, parameters, LawReader(parameters, preset));
    preset.correlation = read_correlation(node, parameters);
    if (preset.name.empty()) node.fail("name", "is missing");
    if (node.has("shear_rate_range")) {
        const Node range = node.object("shear_rate_range");
        range.allow_only({"min", "max", "unit"});
        preset.shear_rate_range = RateRange{.min = range.with_unit("min", Dimension::rate),
                                            .max = range.with_unit("max", Dimension::rate)};
    }
    return preset;
}

CellPreset read_cell(const Node& node) {
    node.allow_only({"name", "aliases", "cell", "temperature", "parameters", "viability_thresholds", "grade",
                     "source", "note"});
    const Node parameters = node.object("parameters");
    parameters.allow_only({"radius", "shear_modulus", "poisson_ratio", "viscosity_ratio"});
    const auto value = [](const std::optional<Value>& v) {
        return v ? std::optional(v->value) : std::nullopt;
    };
    const auto modulus = parameters.quantity("shear_modulus", Dimension::pressure, Sign::positive);
    CellPreset preset{
        .name = node.text("name"),
        .aliases = node.texts("aliases"),
        .cell = node.text("cell"),
        .temperature = node.temperature(),
        .radius = value(parameters.quantity("radius", Dimension::length, Sign::positive)),
        .shear_modulus = value(modulus),
        .shear_modulus_sd = modulus ? modulus->sd : std::nullopt,
        .poisson_ratio =
            value(parameters.quantity("poisson_ratio", Dimension::dimensionless, Sign::not_negative)),
        .viscosity_ratio =
            value(parameters.quantity("viscosity_ratio", Dimension::dimensionless, Sign::not_negative)),
        .viability_thresholds = {},
        .grade = node.text("grade"),
        .source = node.text("source"),
        .note = node.text("note")};
    for (const auto& threshold : node.objects("viability_thresholds")) {
        threshold.allow_only({"exposure", "wall_stress", "viability"});
        preset.viability_thresholds.push_back(
            {.exposure = required(threshold, "exposure", Dimension::time, Sign::positive).value,
             .wall_stress = required(threshold, "wall_stress", Dimension::pressure, Sign::positive).value,
             .viability = threshold.number("viability")});
    }
    return preset;
}

NozzlePreset read_nozzle(const Node& node) {
    node.allow_only(
        {"name", "gauge", "tip", "inner_diameter", "outer_diameter", "color", "part", "grade", "source"});
    const Value bore = required(node, "inner_diameter", Dimension::length, Sign::positive);
    const Tip tip = parse_tip(node.text("tip"));
    return {.name = node.text("name"),
            .gauge = static_cast<int>(node.number("gauge")),
            .tip = tip,
            .radius = bore.value / 2.0,
            .diameter_tolerance = bore.sd,
            .tapered = tip == Tip::tapered,
            .part = node.text("part"),
            .grade = node.text("grade"),
            .source = node.text("source")};
}

template <typename Preset>
Preset read_text(std::string_view text, const std::string& what, Preset (*read)(const Node&)) {
    const PlainJson json = parse_json(text, what);
    return read(Node(json, what + ": "));
}

}  // namespace

InkPreset read_ink_text(std::string_view json, const std::string& what) {
    return read_text(json, what, read_ink);
}

CellPreset read_cell_text(std::string_view json, const std::string& what) {
    return read_text(json, what, read_cell);
}

NozzlePreset read_nozzle_text(std::string_view json, const std::string& what) {
    return read_text(json, what, read_nozzle);
}

InkPreset read_single_ink(std::string_view text, const std::string& what) {
    const PlainJson json = parse_json(text, what);
    const Node root(json, what + ": ");
    if (!root.has("inks")) return read_ink(root);
    const auto inks = root.objects("inks");
    if (inks.size() != 1) root.fail("inks", "must hold one ink, holds " + std::to_string(inks.size()));
    return read_ink(inks.front());
}

}  // namespace bioprint
