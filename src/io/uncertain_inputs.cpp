#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bioprint/io/presets.hpp"
#include "io/ink_settings.hpp"
#include "io/uncertainty.hpp"
#include "numerics/quasi_random.hpp"

namespace bioprint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Spread between preparations of one and the same alginate, over the mean.
struct Scatter {
    Key key;
    double variation;
};
constexpr std::array<Scatter, 3> preparations = {
    {{Key::eta0, 0.15}, {Key::time_constant, 0.26}, {Key::alpha, 0.06}}};
constexpr const char* preparations_source =
    "between preparations of one alginate: Gerum et al. 2022, eLife 11:e78823, doi:10.7554/eLife.78823";

UncertainInput spread_about(Key key, double value, double deviation, std::string source) {
    UncertainInput input{.key = key,
                         .value = value,
                         .standard_deviation = deviation,
                         .kind = SpreadKind::log_normal,
                         .low = 0.0,
                         .high = infinity,
                         .source = std::move(source)};
    if (key == Key::poisson_ratio) {
        input.low = -1.0;
        input.high = 0.5;
    } else if (key == Key::alpha && value <= 1.0) {
        input.high = 1.0;
    }
    if (key == Key::alpha || key == Key::poisson_ratio || value == 0.0) input.kind = SpreadKind::normal;
    return input;
}

constexpr std::array<Key, 8> ink_parameters = {Key::eta0,         Key::eta_inf,     Key::time_constant,
                                               Key::alpha,        Key::consistency, Key::flow_index,
                                               Key::yield_stress, Key::transition};

/// How a preset and the answer's ink call it: "eta0".
std::string parameter_name(Key key) {
    return std::string(info_of(key).path.substr(std::string_view("ink.").size()));
}

/// By the preset where it states a spread; a parameter of the Cross law otherwise by what preparations differ.
void add_ink_scatter(std::vector<UncertainInput>& inputs, const Settings& settings, const Json& ink) {
    const InkPreset* const preset = ink_preset(settings);
    const bool cross = ink.at("law") == "cross";
    for (const Key key : ink_parameters) {
        const std::string name = parameter_name(key);
        const bool given = settings.has(key);
        if (!ink.contains(name) || !ink[name].is_number() || (given && settings.at(key).deviation)) continue;
        const double mean = ink[name].get<double>();
        const std::optional<double> sd = given || preset == nullptr ? std::nullopt : preset->sd(name);
        const auto scatter = std::find_if(preparations.begin(), preparations.end(),
                                          [&](const Scatter& s) { return cross && s.key == key; });
        if (sd) {
            inputs.push_back(spread_about(key, mean, *sd, "preset " + preset->name));
        } else if (scatter != preparations.end()) {
            inputs.push_back(spread_about(key, mean, scatter->variation * mean, preparations_source));
        }
    }
}

void add_cell_scatter(std::vector<UncertainInput>& inputs, const Settings& settings) {
    if (settings.has(Key::shear_modulus) || !settings.has(Key::cell)) return;
    const CellPreset& preset = find_cell(settings.at(Key::cell).text);
    if (!preset.shear_modulus || !preset.shear_modulus_sd) return;
    inputs.push_back(spread_about(Key::shear_modulus, *preset.shear_modulus, *preset.shear_modulus_sd,
                                  "preset " + preset.name));
}

void add_needle_tolerance(std::vector<UncertainInput>& inputs, const Settings& settings) {
    if (!settings.has(Key::needle)) return;
    const std::optional<Tip> tip =
        settings.has(Key::tip) ? std::optional(parse_tip(settings.at(Key::tip).text)) : std::nullopt;
    const NozzlePreset nozzle = find_nozzle(settings.at(Key::needle).text, tip).nozzle;
    if (!nozzle.diameter_tolerance) return;
    const double half = 0.5 * *nozzle.diameter_tolerance;
    inputs.push_back({.key = Key::radius,
                      .value = nozzle.radius,
                      .standard_deviation = half / std::sqrt(3.0),
                      .kind = SpreadKind::uniform,
                      .low = nozzle.radius - half,
                      .high = nozzle.radius + half,
                      .source = "tolerance of needle " + nozzle.name});
}

}  // namespace

std::vector<UncertainInput> uncertain_inputs(const Settings& settings, const Json& answer, bool presets) {
    std::vector<UncertainInput> inputs;
    for (const KeyInfo& info : key_table()) {
        if (!settings.has(info.key) || !settings.at(info.key).deviation) continue;
        const SettingValue& value = settings.at(info.key);
        inputs.push_back(spread_about(info.key, value.number, *value.deviation, "given"));
    }
    if (presets) {
        add_needle_tolerance(inputs, settings);
        add_ink_scatter(inputs, settings, answer.at("input").at("ink"));
        add_cell_scatter(inputs, settings);
    }
    // By this law an ink thins, and its stress never falls.
    if (answer.at("input").at("ink").at("law") == "carreau-yasuda") {
        for (UncertainInput& input : inputs) {
            if (input.key != Key::flow_index) continue;
            input.kind = SpreadKind::normal;
            input.high = 1.0;
        }
    }
    // An input given with a spread of nothing is known exactly.
    std::erase_if(inputs, [](const UncertainInput& input) { return input.standard_deviation == 0.0; });
    return inputs;
}

double spread_value(const UncertainInput& input, double z) {
    switch (input.kind) {
        case SpreadKind::log_normal: {
            const double variation = input.standard_deviation / input.value;
            const double sigma2 = std::log1p(variation * variation);
            return input.value * std::exp(std::sqrt(sigma2) * z - 0.5 * sigma2);
        }
        case SpreadKind::normal: {
            const double below = normal_probability((input.low - input.value) / input.standard_deviation);
            const double above = normal_probability((input.high - input.value) / input.standard_deviation);
            const double part = below + (above - below) * normal_probability(z);
            const double value = input.value + input.standard_deviation * normal_quantile(part);
            return std::clamp(value, input.low, input.high);
        }
        case SpreadKind::uniform:
            return input.low + (input.high - input.low) * normal_probability(z);
    }
    return input.value;
}

}  // namespace bioprint
