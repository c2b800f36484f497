#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/io/quantity.hpp"
#include "bioprint/predict/case.hpp"

/// What a user said about one question, before it is a case: texts by option, from the command line, a CSV
/// row or a JSON object alike. Later levels overlay earlier ones (a row's radius replaces the command line's
/// needle).
namespace bioprint {

enum class Key {
    radius,
    diameter,
    needle,
    tip,
    flow_rate,
    velocity,
    pressure_gradient,
    pressure,
    length,
    ink,
    law,
    eta0,
    eta_inf,
    time_constant,
    alpha,
    consistency,
    flow_index,
    yield_stress,
    transition,
    cell,
    cell_radius,
    shear_modulus,
    poisson_ratio,
    viscosity_ratio,
    offset,
    profile,
    model,
    population,
    threshold,
};
inline constexpr std::size_t key_count = static_cast<std::size_t>(Key::threshold) + 1;

/// How a key is called: on the command line, and in the answer's `input`.
struct KeyInfo {
    Key key;
    std::string_view option;      ///< "radius"
    std::string_view short_name;  ///< "R", or empty
    std::string_view path;        ///< "radius", "ink.eta0", …; empty where the answer has no such input
    std::optional<Dimension> dimension;  ///< none for names and positions
    bool sweeps;                         ///< takes a list or range
    std::string_view help;
};
const std::array<KeyInfo, key_count>& key_table();
const KeyInfo& info_of(Key key);

/// The key of an option name or a path, however spelled: "Radius", "flow_rate", "input.ink.eta0", "--alpha".
std::optional<Key> find_key(std::string_view name);

struct SettingValue {
    double number = 0.0;
    std::optional<double> deviation = {};  ///< standard deviation of the number, where it was given
    std::string text;
    std::vector<CellPosition> positions;
    std::vector<double> numbers;
};

class Settings {
  public:
    /// Parses `text` as the value of `key`; `origin` is what the user called it ("--radius", "column
    /// 'radius'").
    /// @throws UsageError
    void set(Key key, std::string_view text, std::string_view origin, NumberStyle style = {});
    /// A number in SI units.
    void set_number(Key key, double value, std::string_view origin);
    [[nodiscard]] bool has(Key key) const { return values_[static_cast<std::size_t>(key)].has_value(); }
    [[nodiscard]] const SettingValue& at(Key key) const { return *values_[static_cast<std::size_t>(key)]; }
    [[nodiscard]] bool empty() const;
    /// Whether a value was given with its standard deviation.
    [[nodiscard]] bool has_deviation() const;

    /// These settings where given, `defaults` elsewhere.
    /// One of radius, diameter and needle replaces the others, as does one of the four that drive the flow; an ink
    /// replaces a law, a law an ink.
    [[nodiscard]] Settings over(const Settings& defaults) const;

    /// The case, with what nobody said taken from the paper's: R 50 µm, 5 mm/s, ink alginate-2.5, cell
    /// reference.
    /// @throws UsageError  every problem, one a line
    [[nodiscard]] Case make_case() const;

  private:
    SettingValue& claim(Key key, std::string_view origin);
    std::array<std::optional<SettingValue>, key_count> values_;
    std::array<std::string, key_count> origins_;
};

/// Several UsageErrors as one.
class Problems {
  public:
    /// Runs `action`; what it throws as UsageError is kept.
    template <class Action>
    void collect(const Action& action);
    void add(std::string message, std::string option = {});
    [[nodiscard]] bool empty() const { return messages_.empty(); }
    /// @throws UsageError  when there are any
    void raise() const;

  private:
    std::vector<std::string> messages_;
    std::string option_;
};

}  // namespace bioprint

#include "bioprint/errors.hpp"

template <class Action>
void bioprint::Problems::collect(const Action& action) {
    try {
        action();
    } catch (const UsageError& e) {
        add(e.what(), e.option());
    }
}
