#include "bioprint/flow/nozzle_exit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/errors.hpp"
#include "numerics/roots.hpp"

namespace bioprint {

NozzleExit nozzle_exit(const NozzleFlow& flow) {
    const double rate = flow.velocity_excess() / (2.0 * flow.radius());
    // An ink with a yield stress bears it however slowly it is stretched; at rest nothing stretches it.
    if (rate == 0.0) return {.elongation_rate = 0.0, .elongational_stress = 0.0};
    return {.elongation_rate = rate, .elongational_stress = stress(flow.ink(), std::numbers::sqrt3 * rate)};
}

std::optional<NozzleFlow> flow_at_elongational_stress(const Ink& ink, double radius, double stress) {
    try {
        // The stress of the exit grows with the rate at the wall, and is always below the stress there.
        const double least_rate = rate_at_stress(ink, stress);
        if (least_rate == 0.0) return std::nullopt;  // below the yield stress, which every flow passes
        const double low = std::log(least_rate);
        const double top = std::min(std::log(largest_stable_rate(ink)), low + 200.0);
        const auto missing = [&](double log_rate) {
            const NozzleFlow flow = NozzleFlow::from_wall_rate(ink, radius, std::exp(log_rate));
            return std::log(nozzle_exit(flow).elongational_stress / stress);
        };
        double high = low;
        for (double step = 1.0; high < top && missing(high) < 0.0; step *= 2.0)
            high = std::min(top, high + step);
        if (missing(high) < 0.0) return std::nullopt;
        const double root = find_root(missing, {low, high}, {.absolute = 1e-12, .relative = 1e-12});
        return NozzleFlow::from_wall_rate(ink, radius, std::exp(root));
    } catch (const NoSteadyFlow&) {
        return std::nullopt;
    }
}

}  // namespace bioprint
