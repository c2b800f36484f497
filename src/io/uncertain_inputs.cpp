#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bioprint/io/presets.hpp"
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

/// The standard deviation a preset states for one of its values.
std::optional<double> stated(const InkPreset& preset, Key key) {
    switch (key) {
        case Key::eta0:
            return preset.eta0_sd;
        case Key::eta_inf:
            return preset.eta_inf_sd;
        case Key::time_constant:
            return preset.time_constant_sd;
        case Key::alpha:
            return preset.alpha_sd;
        default:
            return std::nullopt;
    }
}

InkPreset ink_preset(const Settings& settings) {
    const std::string name = settings.has(Key::ink) ? settings.at(Key::ink).text : "alginate-2.5";
    const bool file = name.find('/') != std::string::npos || name.ends_with(".json");
    return file ? load_ink_file(name) : find_ink(name);
}

void add_ink_scatter(std::vector<UncertainInput>& inputs, const Settings& settings, const Json& ink) {
    const bool cross = ink.contains("eta0") && ink.contains("time_constant") && ink.contains("alpha") &&
                       (!ink.contains("law") || ink["law"] == "cross");
    if (!cross) return;
    const InkPreset preset = ink_preset(settings);
    const auto value = [&](Key key) {
        return ink.at(std::string(info_of(key).path.substr(4))).get<double>();
    };
    for (const Scatter& scatter : preparations) {
        const bool given = settings.has(scatter.key);
        if (given && settings.at(scatter.key).deviation) continue;
        const std::optional<double> sd = given ? std::nullopt : stated(preset, scatter.key);
        const double mean = value(scatter.key);
        inputs.push_back(spread_about(scatter.key, mean, sd.value_or(scatter.variation * mean),
                                      sd ? "preset " + preset.name : preparations_source));
    }
    const std::optional<double> sd = stated(preset, Key::eta_inf);
    if (sd && !settings.has(Key::eta_inf))
        inputs.push_back(spread_about(Key::eta_inf, value(Key::eta_inf), *sd, "preset " + preset.name));
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
