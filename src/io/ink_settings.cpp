#include "io/ink_settings.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>

#include "bioprint/errors.hpp"
#include "bioprint/io/presets.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr std::array<Key, 8> parameters = {Key::eta0,         Key::eta_inf,     Key::time_constant,
                                           Key::alpha,        Key::consistency, Key::flow_index,
                                           Key::yield_stress, Key::transition};

std::string option_of(Key key) {
    return "--" + std::string(info_of(key).option);
}

/// A parameter of a law: how the user calls it, where the law keeps it, and whether it must be given.
template <class Law>
struct Parameter {
    Key key;
    double Law::*member;
    bool required = true;
};

template <class Law>
struct Parameters;

template <>
struct Parameters<CrossInk> {
    static constexpr std::array<Parameter<CrossInk>, 4> all = {
        {{Key::eta0, &CrossInk::eta0},
         {Key::eta_inf, &CrossInk::eta_inf, false},
         {Key::time_constant, &CrossInk::time_constant},
         {Key::alpha, &CrossInk::alpha}}};
};

template <>
struct Parameters<PowerLawInk> {
    static constexpr std::array<Parameter<PowerLawInk>, 2> all = {
        {{Key::consistency, &PowerLawInk::consistency}, {Key::flow_index, &PowerLawInk::flow_index}}};
};

template <>
struct Parameters<CarreauYasudaInk> {
    static constexpr std::array<Parameter<CarreauYasudaInk>, 5> all = {
        {{Key::eta0, &CarreauYasudaInk::eta0},
         {Key::eta_inf, &CarreauYasudaInk::eta_inf, false},
         {Key::time_constant, &CarreauYasudaInk::time_constant},
         {Key::transition, &CarreauYasudaInk::transition, false},
         {Key::flow_index, &CarreauYasudaInk::flow_index}}};
};

template <>
struct Parameters<HerschelBulkleyInk> {
    static constexpr std::array<Parameter<HerschelBulkleyInk>, 3> all = {
        {{Key::yield_stress, &HerschelBulkleyInk::yield_stress},
         {Key::consistency, &HerschelBulkleyInk::consistency},
         {Key::flow_index, &HerschelBulkleyInk::flow_index}}};
};

/// The law of a name with nothing in it.
std::optional<Ink> find_law(std::string_view name) {
    const std::array<Ink, 4> laws = {CrossInk{}, PowerLawInk{}, CarreauYasudaInk{}, HerschelBulkleyInk{}};
    const std::string wanted = lower_case(trimmed(name));
    for (const Ink& law : laws) {
        if (wanted == law_name(law)) return law;
    }
    return std::nullopt;
}

Ink blank_law(std::string_view name) {
    if (const std::optional<Ink> law = find_law(name)) return *law;
    throw UsageError("--law: got '" + std::string(name) +
                         "'; it takes cross, power-law, carreau-yasuda or herschel-bulkley",
                     "--law");
}

/// A preset by name, or from a file (a name with a slash or a dot-json ending); files are read once.
const InkPreset& preset_of(const std::string& name) {
    if (name.find('/') == std::string::npos && !name.ends_with(".json")) return find_ink(name);
    static std::mutex lock;
    static std::map<std::string, InkPreset> files;
    const std::lock_guard guard(lock);
    auto found = files.find(name);
    if (found == files.end()) found = files.emplace(name, load_ink_file(name)).first;
    return found->second;
}

template <class Law>
std::string names_of_parameters() {
    std::string names;
    for (const auto& parameter : Parameters<Law>::all) {
        names += (names.empty() ? "" : ", ") + std::string(info_of(parameter.key).option);
    }
    return names;
}

/// Puts what was given into the law. @param complete  what it holds already is sound: nothing is missing
template <class Law>
void overlay(Law& law, const Settings& settings, bool complete, Problems& problems) {
    const std::string name(law_name(Ink(law)));
    for (const Key key : parameters) {
        const auto& own = Parameters<Law>::all;
        const bool known = std::any_of(own.begin(), own.end(), [&](const auto& p) { return p.key == key; });
        if (settings.has(key) && !known) {
            problems.add(option_of(key) + ": the " + name + " law has no such parameter; it takes " +
                             names_of_parameters<Law>() + (complete ? ", and --law chooses another law" : ""),
                         option_of(key));
        }
    }
    std::string missing;
    for (const auto& parameter : Parameters<Law>::all) {
        if (settings.has(parameter.key)) {
            law.*parameter.member = settings.at(parameter.key).number;
        } else if (!complete && parameter.required) {
            missing += (missing.empty() ? "" : ", ") + option_of(parameter.key);
        }
    }
    if (!missing.empty()) problems.add("--law: the " + name + " law needs " + missing + " too", "--law");
}

/// What to start from: the preset, or for a law of the user's own nothing.
struct Start {
    InkChoice ink;
    const InkPreset* preset;  ///< none: a blank law
};

Start start_of(const Settings& settings) {
    // An answer calls an ink without a preset by its law; taken back as a question it is that law.
    const std::string ink = settings.has(Key::ink) ? settings.at(Key::ink).text : std::string{};
    const bool named = !ink.empty() && !find_law(ink);
    const InkPreset& preset = preset_of(named ? ink : "alginate-2.5");
    InkChoice of_preset{.name = preset.name, .source = preset.source, .law = preset.ink};
    const bool with_law = settings.has(Key::law);
    if (!with_law && (named || ink.empty())) return {.ink = std::move(of_preset), .preset = &preset};
    Ink law = blank_law(with_law ? settings.at(Key::law).text : ink);
    if (law.index() == preset.ink.index()) return {.ink = std::move(of_preset), .preset = &preset};
    const std::string name(law_name(law));
    if (named) {
        throw UsageError("--law: the ink " + preset.name + " follows the " +
                             std::string(law_name(preset.ink)) + " law, not " + name +
                             "; leave out --ink or --law",
                         "--law");
    }
    return {.ink = {.name = name, .source = "law given", .law = law}, .preset = nullptr};
}

}  // namespace

InkChoice ink_choice(const Settings& settings) {
    auto [ink, preset] = start_of(settings);
    Problems problems;
    const bool complete = preset != nullptr;
    std::visit([&](auto& law) { overlay(law, settings, complete, problems); }, ink.law);
    problems.raise();
    for (const Key key : parameters) {
        if (settings.has(key)) ink.source += "; " + std::string(info_of(key).option) + " given";
    }
    return ink;
}

const InkPreset* ink_preset(const Settings& settings) {
    return start_of(settings).preset;
}

}  // namespace bioprint
