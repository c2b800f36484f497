#include "io/settings.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <mutex>

#include "bioprint/io/presets.hpp"

namespace bioprint {
namespace {

constexpr std::array<Key, 3> size_group = {Key::radius, Key::diameter, Key::needle};
constexpr std::array<Key, 4> drive_group = {Key::flow_rate, Key::velocity, Key::pressure_gradient,
                                            Key::pressure};

template <std::size_t N>
bool contains(const std::array<Key, N>& group, Key key) {
    return std::find(group.begin(), group.end(), key) != group.end();
}

std::size_t index(Key key) {
    return static_cast<std::size_t>(key);
}

/// "Flow_Rate" and "flow-rate" are one name; so are "input.radius" and "radius".
std::string normalised(std::string_view name) {
    while (name.starts_with('-')) name.remove_prefix(1);
    std::string result;
    for (const char c : name) {
        if (c != '-' && c != '_' && c != ' ') {
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        }
    }
    return result.starts_with("input.") ? result.substr(6) : result;
}

CellChoice cell_choice(const Settings& settings) {
    const CellPreset& preset = find_cell(settings.has(Key::cell) ? settings.at(Key::cell).text : "reference");
    const CellPreset& reference = find_cell("reference");
    const auto pick = [&](Key key, const std::optional<double>& preset_value,
                          const std::optional<double>& fallback) {
        if (settings.has(key)) return settings.at(key).number;
        return preset_value ? *preset_value : fallback.value();
    };
    CellChoice cell{
        .name = preset.name,
        .source = preset.source,
        .radius = pick(Key::cell_radius, preset.radius, reference.radius),
        .shear_modulus = pick(Key::shear_modulus, preset.shear_modulus, reference.shear_modulus),
        .poisson_ratio = pick(Key::poisson_ratio, preset.poisson_ratio, reference.poisson_ratio),
        .viscosity_ratio = pick(Key::viscosity_ratio, preset.viscosity_ratio, reference.viscosity_ratio)};
    std::string missing;
    if (!settings.has(Key::cell_radius) && !preset.radius) missing = "radius";
    if (!settings.has(Key::shear_modulus) && !preset.shear_modulus) {
        missing += missing.empty() ? "shear modulus" : " and no shear modulus";
    }
    if (!missing.empty()) {
        cell.remark = "the cell preset " + preset.name + " has no " + missing +
                      ": the reference cell's is used; give --cell-radius or --shear-modulus";
        cell.source += "; " + missing + " of the reference cell";
    }
    for (const Key key : {Key::cell_radius, Key::shear_modulus, Key::poisson_ratio, Key::viscosity_ratio}) {
        if (settings.has(key)) cell.source += "; " + std::string(info_of(key).option) + " given";
    }
    return cell;
}

/// A preset by name, or from a file (a name with a slash or a dot-json ending); files are read once.
const InkPreset& ink_of(const std::string& name) {
    if (name.find('/') == std::string::npos && !name.ends_with(".json")) return find_ink(name);
    static std::mutex lock;
    static std::map<std::string, InkPreset> files;
    const std::lock_guard guard(lock);
    auto found = files.find(name);
    if (found == files.end()) found = files.emplace(name, load_ink_file(name)).first;
    return found->second;
}

InkChoice ink_choice(const Settings& settings) {
    const std::string name = settings.has(Key::ink) ? settings.at(Key::ink).text : "alginate-2.5";
    const InkPreset& preset = ink_of(name);
    const auto pick = [&](Key key, double fallback) {
        return settings.has(key) ? settings.at(key).number : fallback;
    };
    InkChoice ink{.name = preset.name,
                  .source = preset.source,
                  .law = {.eta0 = pick(Key::eta0, preset.ink.eta0),
                          .eta_inf = pick(Key::eta_inf, preset.ink.eta_inf),
                          .time_constant = pick(Key::time_constant, preset.ink.time_constant),
                          .alpha = pick(Key::alpha, preset.ink.alpha)}};
    for (const Key key : {Key::eta0, Key::eta_inf, Key::time_constant, Key::alpha}) {
        if (settings.has(key)) ink.source += "; " + std::string(info_of(key).option) + " given";
    }
    return ink;
}

}  // namespace

const std::array<KeyInfo, key_count>& key_table() {
    using enum Dimension;
    static constexpr std::array<KeyInfo, key_count> table = {{
        {Key::radius, "radius", "R", "radius", length, true, "nozzle inner radius (default 50um)"},
        {Key::diameter, "diameter", "", "", length, true, "nozzle inner diameter"},
        {Key::needle, "needle", "", "", std::nullopt, true, "needle gauge such as 25G; with --tip"},
        {Key::tip, "tip", "", "", std::nullopt, true, "steel, tapered or hypodermic"},
        {Key::flow_rate, "flowrate", "Q", "flow_rate", volume_flow, true, "volume flow, such as 141uL/h"},
        {Key::velocity, "velocity", "", "velocity_average", Dimension::velocity, true,
         "average velocity in the nozzle (default 5mm/s)"},
        {Key::pressure_gradient, "pressure-gradient", "", "pressure_gradient", Dimension::pressure_gradient,
         true, "pressure gradient in the nozzle, such as 17MPa/m"},
        {Key::pressure, "pressure", "", "pressure_drop", Dimension::pressure, true,
         "pressure over the nozzle, with --length"},
        {Key::length, "length", "", "length", length, true,
         "nozzle length: adds pressure drop and residence time"},
        {Key::ink, "ink", "", "ink.name", std::nullopt, true,
         "ink preset or preset FILE (default alginate-2.5)"},
        {Key::eta0, "eta0", "", "ink.eta0", viscosity, true, "zero-shear viscosity"},
        {Key::eta_inf, "eta-inf", "", "ink.eta_inf", viscosity, true, "infinite-shear viscosity (default 0)"},
        {Key::time_constant, "time-constant", "K", "ink.time_constant", time, true, "Cross time constant K"},
        {Key::alpha, "alpha", "a", "ink.alpha", dimensionless, true,
         "Cross exponent, 0: Newtonian of eta0/2"},
        {Key::cell, "cell", "", "cell.name", std::nullopt, true,
         "cell preset (default reference: 8um, 1kPa)"},
        {Key::cell_radius, "cell-radius", "", "cell.radius", length, true, "undeformed cell radius"},
        {Key::shear_modulus, "shear-modulus", "", "cell.shear_modulus", Dimension::pressure, true,
         "shear modulus of the cell"},
        {Key::poisson_ratio, "poisson-ratio", "", "cell.poisson_ratio", dimensionless, true,
         "Poisson ratio of the cell (recorded; every model takes the cell as incompressible)"},
        {Key::viscosity_ratio, "viscosity-ratio", "", "cell.viscosity_ratio", dimensionless, true,
         "viscosity inside the cell over that of the ink"},
        {Key::offset, "offset", "", "offsets", std::nullopt, false,
         "radial positions of cells: lengths or cell radii, 0,1.5Rc,20um"},
        {Key::profile, "profile", "", "", dimensionless, false, "add a radial profile of N points"},
        {Key::model, "model", "", "", std::nullopt, false,
         "ellipsoid: follow the cells through nozzle and exit in time (default); steady: the paper's theory "
         "alone"},
        {Key::population, "population", "", "", std::nullopt, false,
         "the distribution of the peak stress over all cells of a print"},
        {Key::threshold, "threshold", "", "", Dimension::pressure, false,
         "with --population: the share of cells above this stress; may be repeated"},
    }};
    return table;
}

const KeyInfo& info_of(Key key) {
    return key_table()[index(key)];
}

std::optional<Key> find_key(std::string_view name) {
    const std::string wanted = normalised(name);
    if (wanted.empty()) return std::nullopt;
    for (const KeyInfo& info : key_table()) {
        if (wanted == normalised(info.option) || (!info.path.empty() && wanted == normalised(info.path))) {
            return info.key;
        }
    }
    // Lower-cased, the short names K and a would be any column's: only K is common enough to take.
    if (wanted == "k") return Key::time_constant;
    return std::nullopt;
}

SettingValue& Settings::claim(Key key, std::string_view origin) {
    const auto conflict = [&](const auto& group) {
        if (!contains(group, key)) return;
        for (const Key other : group) {
            if (other != key && has(other)) {
                throw UsageError(std::string(origin) + ": cannot be combined with " + origins_[index(other)] +
                                     "; give one of the two",
                                 std::string(origin));
            }
        }
    };
    conflict(size_group);
    conflict(drive_group);
    if (has(key)) throw UsageError(std::string(origin) + ": given twice; give it once", std::string(origin));
    origins_[index(key)] = origin;
    return values_[index(key)].emplace();
}

void Settings::set(Key key, std::string_view text, std::string_view origin, NumberStyle style) {
    const KeyInfo& info = info_of(key);
    if (key == Key::threshold) {
        std::vector<double> numbers = parse_quantity_list(text, *info.dimension, origin, style);
        claim(key, origin).numbers = std::move(numbers);
    } else if (info.dimension) {
        const double value = parse_quantity(text, *info.dimension, origin, style);
        claim(key, origin).number = value;
    } else if (key == Key::offset) {
        std::vector<CellPosition> positions;
        for (const Offset& o : parse_offsets(text, origin, style))
            positions.push_back({o.value, o.in_cell_radii});
        claim(key, origin).positions = std::move(positions);
    } else {
        claim(key, origin).text = text;
    }
}

void Settings::set_number(Key key, double value, std::string_view origin) {
    if (key == Key::offset) {
        claim(key, origin).positions = {{value, false}};
    } else if (key == Key::threshold) {
        claim(key, origin).numbers = {value};
    } else if (info_of(key).dimension) {
        claim(key, origin).number = value;
    } else if (key == Key::needle) {
        if (value != std::floor(value) || value < 1.0 || value > 99.0) {
            throw UsageError(std::string(origin) + ": takes a gauge such as 25", std::string(origin));
        }
        claim(key, origin).text = std::to_string(static_cast<int>(value));
    } else {
        throw UsageError(std::string(origin) + ": takes a name, got a number", std::string(origin));
    }
}

bool Settings::empty() const {
    return std::none_of(values_.begin(), values_.end(), [](const auto& value) { return value.has_value(); });
}

Settings Settings::over(const Settings& defaults) const {
    Settings result = *this;
    const auto given = [&](const auto& group) {
        return std::any_of(group.begin(), group.end(), [&](Key key) { return has(key); });
    };
    const bool own_size = given(size_group);
    const bool own_drive = given(drive_group);
    for (std::size_t i = 0; i < key_count; ++i) {
        const Key key = static_cast<Key>(i);
        if (result.values_[i] || !defaults.values_[i]) continue;
        if ((own_size && (contains(size_group, key) || (key == Key::tip && !has(Key::needle)))) ||
            (own_drive && contains(drive_group, key)))
            continue;
        result.values_[i] = defaults.values_[i];
        result.origins_[i] = defaults.origins_[i];
    }
    return result;
}

Case Settings::make_case() const {
    Problems problems;
    Case question{.radius = 50e-6,
                  .length = std::nullopt,
                  .drive = Drive::velocity,
                  .drive_value = 5e-3,
                  .ink = {},
                  .cell = {},
                  .positions = {},
                  .needle = std::nullopt};
    if (has(Key::radius)) question.radius = at(Key::radius).number;
    if (has(Key::diameter)) question.radius = 0.5 * at(Key::diameter).number;
    if (has(Key::needle)) {
        problems.collect([&] {
            const std::optional<Tip> tip =
                has(Key::tip) ? std::optional(parse_tip(at(Key::tip).text, origins_[index(Key::tip)]))
                              : std::nullopt;
            const NozzleChoice choice = find_nozzle(at(Key::needle).text, tip, origins_[index(Key::needle)]);
            question.radius = choice.nozzle.radius;
            question.needle = NeedleChoice{.name = choice.nozzle.name,
                                           .source = choice.nozzle.source,
                                           .remark = choice.tip_assumed ? describe(choice) : std::string{},
                                           .tapered = choice.nozzle.tapered};
        });
    } else if (has(Key::tip)) {
        problems.add(origins_[index(Key::tip)] + ": says the kind of a needle; add --needle, such as 25G");
    }
    if (has(Key::length)) question.length = at(Key::length).number;

    constexpr std::array<std::pair<Key, Drive>, 4> drives = {
        {{Key::flow_rate, Drive::flow_rate},
         {Key::velocity, Drive::velocity},
         {Key::pressure_gradient, Drive::pressure_gradient},
         {Key::pressure, Drive::pressure}}};
    for (const auto& [key, drive] : drives) {
        if (!has(key)) continue;
        question.drive = drive;
        question.drive_value = at(key).number;
    }
    problems.collect([&] { question.ink = ink_choice(*this); });
    problems.collect([&] { question.cell = cell_choice(*this); });
    if (has(Key::offset)) question.positions = at(Key::offset).positions;
    if (has(Key::population)) {
        const std::string& text = at(Key::population).text;
        question.population = text == "yes" || text == "true" || text == "1";
        if (!question.population && text != "no" && text != "false" && text != "0") {
            problems.add(origins_[index(Key::population)] + ": got '" + text + "'; it takes yes or no",
                         origins_[index(Key::population)]);
        }
    }
    if (has(Key::threshold)) {
        question.thresholds = at(Key::threshold).numbers;
        if (!question.population) {
            problems.add(origins_[index(Key::threshold)] + ": belongs to a population; add --population",
                         origins_[index(Key::threshold)]);
        }
    }
    if (has(Key::model)) {
        const std::string& model = at(Key::model).text;
        question.transient = model == "ellipsoid";
        if (model != "ellipsoid" && model != "steady") {
            problems.add(origins_[index(Key::model)] + ": got '" + model + "'; it takes ellipsoid or steady",
                         origins_[index(Key::model)]);
        }
    }
    if (has(Key::profile)) {
        const double points = at(Key::profile).number;
        if (points != std::floor(points) || points < 2.0 || points > 1e6) {
            problems.add(origins_[index(Key::profile)] +
                         ": takes a whole number of points from 2 to 1000000");
        } else {
            question.profile_points = static_cast<int>(points);
        }
    }
    if (problems.empty()) {
        for (const std::string& problem : problems_of(question)) {
            // A problem names the quantity; the user knows it by what he called it.
            const std::string name = problem.substr(0, problem.find(':'));
            std::optional<Key> key = find_key(name);
            if (key == Key::radius && has(Key::diameter)) key = Key::diameter;
            const bool known = key && has(*key);
            problems.add(known ? origins_[index(*key)] + problem.substr(name.size()) : "--" + problem,
                         known ? origins_[index(*key)] : "--" + name);
        }
    }
    problems.raise();
    return question;
}

void Problems::add(std::string message, std::string option) {
    messages_.push_back(std::move(message));
    if (option_.empty()) option_ = std::move(option);
}

void Problems::raise() const {
    if (messages_.empty()) return;
    std::string all = messages_.front();
    for (std::size_t i = 1; i < messages_.size(); ++i) all += "\n" + messages_[i];
    throw UsageError(all, option_);
}

}  // namespace bioprint
