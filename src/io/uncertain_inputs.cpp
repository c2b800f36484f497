#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bioprint/io/number_format.hpp"
#include "bioprint/io/presets.hpp"
#include "io/ink_settings.hpp"
#include "io/uncertainty.hpp"
#include "numerics/correlation.hpp"
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

/// A parameter fitted with others: its logarithm is normal about the value, as the fit's own error is. The flow index
/// of Carreau-Yasuda may be 0 and is normal itself.
UncertainInput fitted(Key key, double value, double deviation, bool carreau, std::string source) {
    UncertainInput input = spread_about(key, value, deviation, std::move(source));
    if (value == 0.0 || (carreau && key == Key::flow_index)) return input;
    const double variance = deviation * deviation / (value * value);
    input.kind = SpreadKind::log_normal;
    input.value = value * std::exp(0.5 * variance);
    input.standard_deviation = input.value * std::sqrt(std::expm1(variance));
    return input;
}

/// The ink of a question while its inputs are collected.
struct InkScatter {
    const Settings& settings;
    const Json& ink;
    const InkPreset* preset;
    UncertainInputs& all;

    [[nodiscard]] bool has(Key key) const {
        const std::string name = parameter_name(key);
        return ink.contains(name) && ink[name].is_number();
    }
    [[nodiscard]] double value(Key key) const { return ink[parameter_name(key)].get<double>(); }
    /// Whether the data behind the preset leave it open.
    [[nodiscard]] bool is_open(Key key) const {
        if (preset == nullptr || !has(key)) return false;
        const auto& open = preset->undetermined;
        return std::find(open.begin(), open.end(), parameter_name(key)) != open.end();
    }
    [[nodiscard]] bool is(std::string_view law) const { return ink.at("law") == law; }
};

/// The parameters of an ink that were fitted together, as far as nobody gave them.
struct FittedTogether {
    std::vector<Key> keys;
    std::vector<double> sd;  ///< infinite where the data say nothing
    std::vector<double> matrix;
};

FittedTogether fitted_together(const InkScatter& ink) {
    FittedTogether fit;
    if (ink.preset == nullptr || !ink.preset->correlation) return fit;
    const ParameterCorrelation& whole = *ink.preset->correlation;
    std::vector<std::size_t> rows;
    for (const Key key : ink_parameters) {
        const auto row = std::find(whole.parameters.begin(), whole.parameters.end(), parameter_name(key));
        if (row == whole.parameters.end() || !ink.has(key) || ink.settings.has(key)) continue;
        const double sd = ink.preset->sd(parameter_name(key)).value_or(ink.is_open(key) ? infinity : 0.0);
        if (sd == 0.0) continue;
        rows.push_back(static_cast<std::size_t>(row - whole.parameters.begin()));
        fit.keys.push_back(key);
        fit.sd.push_back(sd);
    }
    for (const std::size_t i : rows) {
        for (const std::size_t j : rows) fit.matrix.push_back(whole.matrix[i * whole.parameters.size() + j]);
    }
    return fit;
}

/// Which parameters to hold so that the others are determined beside them: of those left open the least known first,
/// until the rest has 95 % intervals within a factor of 7, as the fit asks of a parameter that it calls determined.
std::vector<bool> held_of(const FittedTogether& fit, const InkScatter& ink) {
    constexpr double largest = 0.5;
    std::vector<bool> held(fit.keys.size(), false);
    for (;;) {
        const ConditionalNormals left = conditional_normals(fit.matrix, held);
        std::size_t worst = fit.keys.size();
        double most = largest;
        for (std::size_t i = 0, k = 0; i < fit.keys.size(); ++i) {
            if (held[i]) continue;
            const double open =
                fit.sd[i] * (std::isfinite(fit.sd[i]) ? left.spread[k] : 1.0) / ink.value(fit.keys[i]);
            ++k;
            if (!ink.is_open(fit.keys[i]) || !(open > most)) continue;
            most = open;
            worst = i;
        }
        if (worst == fit.keys.size()) return held;
        held[worst] = true;
    }
}

/// Parameters that were fitted together, by what is open of them beside those that are held.
void add_correlated(const InkScatter& ink) {
    const FittedTogether fit = fitted_together(ink);
    const std::vector<bool> held = held_of(fit, ink);
    const ConditionalNormals left = conditional_normals(fit.matrix, held);
    const std::size_t before = ink.all.inputs.size();
    const std::size_t count = left.spread.size();
    const std::size_t n = before + count;
    std::vector<double> mixing(n * n, 0.0);
    for (std::size_t i = 0; i < before; ++i) mixing[i * n + i] = 1.0;
    for (std::size_t i = 0, k = 0; i < fit.keys.size(); ++i) {
        const Key key = fit.keys[i];
        if (held[i]) {
            ink.all.held.push_back(key);
            continue;
        }
        ink.all.inputs.push_back(fitted(key, ink.value(key), fit.sd[i] * left.spread[k],
                                        ink.is("carreau-yasuda"), "preset " + ink.preset->name));
        for (std::size_t j = 0; j < count; ++j)
            mixing[(before + k) * n + before + j] = left.mixing[k * count + j];
        ++k;
    }
    if (count > 1) ink.all.mixing = std::move(mixing);
}

/// Parameters left open of which no correlation says what is known beside them.
void hold_others(const InkScatter& ink) {
    for (const Key key : ink_parameters) {
        const auto is_key = [&](const UncertainInput& input) { return input.key == key; };
        auto& held = ink.all.held;
        const auto& inputs = ink.all.inputs;
        const bool done = std::find(held.begin(), held.end(), key) != held.end() ||
                          std::any_of(inputs.begin(), inputs.end(), is_key);
        if (ink.is_open(key) && !ink.settings.has(key) && !done) held.push_back(key);
    }
}

std::string why_held(const InkScatter& ink) {
    if (ink.all.held.empty()) return {};
    std::string names;
    for (const Key key : ink.all.held)
        names += (names.empty() ? "" : ", ") + std::string(info_of(key).option);
    std::string rates = "the shear rates measured";
    if (const auto& range = ink.preset->shear_rate_range) {
        rates += ", " + bare_text(range->min, 3) + " to " + bare_text(range->max, 3) + " 1/s";
    }
    return "the data behind the ink " + ink.preset->name + " do not determine " + names +
           ": held at the value fitted, while the others vary by what is open beside it. That is the "
           "spread at " +
           rates + "; at others it is larger and not known";
}

/// By the preset where it states a spread; a parameter of the Cross law otherwise by what preparations differ.
void add_independent(const InkScatter& ink) {
    for (const Key key : ink_parameters) {
        const std::string name = parameter_name(key);
        const bool given = ink.settings.has(key);
        const auto is_key = [&](const UncertainInput& input) { return input.key == key; };
        const auto& inputs = ink.all.inputs;
        const auto& held = ink.all.held;
        if (!ink.has(key) || std::any_of(inputs.begin(), inputs.end(), is_key) ||
            (given && ink.settings.at(key).deviation) ||
            std::find(held.begin(), held.end(), key) != held.end()) {
            continue;
        }
        const double mean = ink.value(key);
        const std::optional<double> sd = given || ink.preset == nullptr ? std::nullopt : ink.preset->sd(name);
        const auto scatter = std::find_if(preparations.begin(), preparations.end(),
                                          [&](const Scatter& s) { return ink.is("cross") && s.key == key; });
        if (sd) {
            ink.all.inputs.push_back(spread_about(key, mean, *sd, "preset " + ink.preset->name));
        } else if (scatter != preparations.end()) {
            ink.all.inputs.push_back(spread_about(key, mean, scatter->variation * mean, preparations_source));
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

/// An input given with a spread of nothing is known exactly. The mixing knows the first inputs only; those behind them
/// are independent.
void drop_exact(UncertainInputs& all) {
    const auto known =
        static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(all.mixing.size()))));
    std::vector<UncertainInput> inputs;
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < all.inputs.size(); ++i) {
        if (all.inputs[i].standard_deviation == 0.0) continue;
        kept.push_back(i);
        inputs.push_back(std::move(all.inputs[i]));
    }
    all.inputs = std::move(inputs);
    if (known == 0) return;
    std::vector<double> mixing;
    for (const std::size_t i : kept) {
        for (const std::size_t j : kept) {
            mixing.push_back(i < known && j < known ? all.mixing[i * known + j] : (i == j ? 1.0 : 0.0));
        }
    }
    all.mixing = std::move(mixing);
}

}  // namespace

double UncertainInputs::correlation(std::size_t i, std::size_t j) const {
    const std::size_t n = inputs.size();
    if (mixing.empty()) return i == j ? 1.0 : 0.0;
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) sum += mixing[i * n + k] * mixing[j * n + k];
    return std::clamp(sum, -1.0, 1.0);
}

UncertainInputs uncertain_inputs(const Settings& settings, const Json& answer, bool presets) {
    UncertainInputs all;
    std::vector<UncertainInput>& inputs = all.inputs;
    for (const KeyInfo& info : key_table()) {
        if (!settings.has(info.key) || !settings.at(info.key).deviation) continue;
        const SettingValue& value = settings.at(info.key);
        inputs.push_back(spread_about(info.key, value.number, *value.deviation, "given"));
    }
    const Json& ink = answer.at("input").at("ink");
    if (presets) {
        add_needle_tolerance(inputs, settings);
        const InkScatter scatter{
            .settings = settings, .ink = ink, .preset = ink_preset(settings), .all = all};
        add_correlated(scatter);
        hold_others(scatter);
        all.held_why = why_held(scatter);
        add_independent(scatter);
        add_cell_scatter(inputs, settings);
    }
    // By this law an ink thins, and its stress never falls.
    if (ink.at("law") == "carreau-yasuda") {
        for (UncertainInput& input : inputs) {
            if (input.key != Key::flow_index) continue;
            input.kind = SpreadKind::normal;
            input.high = 1.0;
        }
    }
    drop_exact(all);
    return all;
}

double spread_value(const UncertainInput& input, double z) {
    switch (input.kind) {
        case SpreadKind::log_normal: {
            const double variation = input.standard_deviation / input.value;
            const double sigma2 = std::log1p(variation * variation);
            return std::min(input.high, input.value * std::exp(std::sqrt(sigma2) * z - 0.5 * sigma2));
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
