#include "bioprint/flow/flow_check.hpp"

#include <algorithm>
#include <cmath>

#include "flow/profile.hpp"
#include "numerics/quadrature.hpp"

namespace bioprint {

FlowCheck check_flow(const NozzleFlow& flow) {
    const double wall_rate = flow.shear_rate_max();
    if (wall_rate == 0.0) return {.velocity_average = 0.0, .velocity_excess = 0.0, .relative_error = 0.0};
    const double wall_stress = stress(flow.ink(), wall_rate);
    // Over v = ln(γ̇_w/γ̇): the rates of a profile span as many decades as its stresses.
    const auto q = [&](double v) { return stress(flow.ink(), wall_rate * std::exp(-v)) / wall_stress; };
    const auto third = [&](double v) { return std::exp(-v) * (1.0 - std::pow(q(v), 3)); };
    const auto excess = [&](double v) { return std::exp(-v) * (1.0 - q(v)) * (1.0 - q(v)) * (2.0 + q(v)); };
    const double scale_of_rate = std::visit([](const auto& law) { return time_scale(law); }, flow.ink());
    const double end = 40.0 + std::max(0.0, std::log(scale_of_rate * wall_rate));
    const Integral average = integrate(third, 0.0, end, 1e-10);
    const Integral difference = integrate(excess, 0.0, end, 1e-10);
    const double scale = flow.radius() * wall_rate / 3.0;
    return {.velocity_average = scale * average.value,
            .velocity_excess = scale * difference.value,
            .relative_error = std::max(average.error / average.value, difference.error / difference.value)};
}

}  // namespace bioprint
