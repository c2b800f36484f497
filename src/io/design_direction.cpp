#include "io/design_direction.hpp"

#include <algorithm>
#include <array>

namespace bioprint {
namespace {

template <std::size_t N>
bool contains(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 9> grow_with_load = {
    "flow_rate",      "pressure_gradient",  "pressure_drop", "velocity_average", "velocity_max",
    "shear_rate_max", "shear_rate_average", "stress_max",    "stress_average"};
constexpr std::array<std::string_view, 5> fall_with_radius = {
    "pressure_gradient", "pressure_drop", "shear_rate_max", "stress_max", "stress_average"};
constexpr std::array<std::string_view, 7> grow_with_radius = {
    "flow_rate",          "velocity_average", "velocity_max",  "shear_rate_max",
    "shear_rate_average", "stress_max",       "stress_average"};

bool pressure_driven(Drive drive) {
    return drive == Drive::pressure || drive == Drive::pressure_gradient;
}

}  // namespace

int direction_by_theory(std::string_view path, Key sought, Drive drive) {
    if (!path.starts_with("nozzle.")) return 0;
    path.remove_prefix(7);
    switch (sought) {
        case Key::flow_rate:
        case Key::velocity:
        case Key::pressure_gradient:
        case Key::pressure:
            if (path == "residence_time") return -1;
            return contains(grow_with_load, path) ? 1 : 0;
        case Key::radius:
            if (pressure_driven(drive)) return contains(grow_with_radius, path) ? 1 : 0;
            if (path == "velocity_average" && drive == Drive::flow_rate) return -1;
            return contains(fall_with_radius, path) ? -1 : 0;
        default:
            return 0;
    }
}

bool steady_flow_ends_above(Key sought, Drive drive) {
    return sought != Key::radius || pressure_driven(drive);
}

}  // namespace bioprint
