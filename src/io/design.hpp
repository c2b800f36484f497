#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/checks.hpp"
#include "io/settings.hpp"

/// The value of one parameter with which all limits are kept.
///
/// Each limit bounds the parameter from one side: along a flow, a velocity or a pressure, stresses grow; along
/// the radius at a given flow they fall. For quantities of the nozzle that direction follows from the theory
/// (the flow grows with the wall's stress, for every ink on its stable branch); for the others it is measured,
/// and every evaluation of the search is held against it. The limits' ends are then found by bracketing
/// (numerics/boundary.hpp) and bound an interval:
///
///   admissible = [ the largest of the lower ends, the smallest of the upper ends ]
///
/// The answer is the end that a limit sets; where both ends are set by limits, the largest flow, velocity or
/// pressure, the smallest radius or alpha. Strict limits are kept strictly.
namespace bioprint {

struct DesignQuestion {
    Key sought;  ///< radius, flow_rate, velocity, pressure, pressure_gradient or alpha
    std::vector<Check> limits;
    std::optional<std::pair<double, double>> range = {};  ///< SI; none: `default_range`
};

enum class DesignOutcome {
    found,      ///< a limit binds
    unlimited,  ///< every value of the range keeps all limits
    impossible  ///< none does; the value is the one that comes closest
};

struct LimitStand {
    CheckResult result;      ///< at the value
    bool binds = false;      ///< its end is the value; of an impossible question, one of those in the way
    bool by_theory = false;  ///< its direction is
    bool monotone = true;    ///< as far as it was evaluated
};

struct Design {
    DesignOutcome outcome;
    double value;                                   ///< SI
    bool largest;                                   ///< the end of the interval; else the smallest
    std::pair<double, double> range;                ///< searched
    std::optional<std::pair<double, double>> kept;  ///< the interval in which all limits are kept
    std::optional<double> beyond;                   ///< a value just outside at which a limit is broken
    bool steady_flow_binds = false;                 ///< what ends the interval is that no steady flow follows
    std::vector<LimitStand> limits;
    std::vector<std::string> remarks;  ///< where a limit was found not to be monotone
    int evaluations;                   ///< predictions made
};

/// The key of a word of `--solve`.
/// @throws UsageError
Key sought_key(std::string_view word);

/// `LOW:HIGH` in the parameter's unit.
/// @throws UsageError
std::pair<double, double> parse_range(std::string_view text, Key sought);

/// @param base  the question's other settings; `sought` is not among them
/// @param jobs  threads; the answer does not depend on them
/// @throws UsageError    the question is none without regard to the value, or a limit has no value anywhere
/// @throws NoSteadyFlow  nowhere in the range
Design solve_design(const DesignQuestion& question, const Settings& base, unsigned jobs = 1);

/// The base with the value in place.
Settings with_value(const Settings& base, Key sought, double value);

}  // namespace bioprint
