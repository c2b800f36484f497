#include "bioprint/rheology/herschel_bulkley.hpp"

#include <cmath>
#include <limits>

#include "rheology/largest_rate.hpp"

namespace bioprint {

double viscosity(const HerschelBulkleyInk& ink, double rate) {
    const double flowing = ink.consistency * std::pow(rate, ink.flow_index - 1.0);
    return ink.yield_stress == 0.0 ? flowing : ink.yield_stress / rate + flowing;
}

double stress(const HerschelBulkleyInk& ink, double rate) {
    return ink.yield_stress + ink.consistency * std::pow(rate, ink.flow_index);
}

double largest_stable_rate(const HerschelBulkleyInk& /*ink*/) {
    return std::numeric_limits<double>::infinity();
}

double flow_index(const HerschelBulkleyInk& ink, double rate) {
    if (ink.yield_stress == 0.0) return ink.flow_index;
    const double flowing = ink.consistency * std::pow(rate, ink.flow_index);
    return ink.flow_index / (1.0 + ink.yield_stress / flowing);
}

double rate_at_stress(const HerschelBulkleyInk& ink, double stress) {
    if (stress <= ink.yield_stress) return 0.0;
    const double flowing = (stress - ink.yield_stress) / ink.consistency;
    return within_largest_rate(std::pow(flowing, 1.0 / ink.flow_index), stress);
}

}  // namespace bioprint
