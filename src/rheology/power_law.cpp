#include "bioprint/rheology/power_law.hpp"

#include <cmath>
#include <limits>

#include "rheology/largest_rate.hpp"

namespace bioprint {

double viscosity(const PowerLawInk& ink, double rate) {
    return ink.consistency * std::pow(rate, ink.flow_index - 1.0);
}

double stress(const PowerLawInk& ink, double rate) {
    return ink.consistency * std::pow(rate, ink.flow_index);
}

double largest_stable_rate(const PowerLawInk& /*ink*/) {
    return std::numeric_limits<double>::infinity();
}

double flow_index(const PowerLawInk& ink, double /*rate*/) {
    return ink.flow_index;
}

double rate_at_stress(const PowerLawInk& ink, double stress) {
    return within_largest_rate(std::pow(stress / ink.consistency, 1.0 / ink.flow_index), stress);
}

}  // namespace bioprint
