#include "bioprint/flow/nozzle_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bioprint/errors.hpp"
#include "flow/profile.hpp"
#include "numerics/brief.hpp"
#include "numerics/roots.hpp"

namespace bioprint {
namespace {

/// Rates beyond 1e100/K describe nothing; they occur where a stress saturates (α near 1).
const double log_wall_limit = 100.0 * std::log(10.0);

[[noreturn]] void refuse(const CrossInk& ink, double velocity_average, double top) {
    throw NoSteadyFlow("no steady flow: at alpha = " + brief(ink.alpha) +
                       " the stress of this ink reaches at most " +
                       brief(stress(ink, std::exp(top) / ink.time_constant)) +
                       " Pa, too little to drive it at " + brief(velocity_average) +
                       " m/s through this nozzle; lower the flow rate, widen the nozzle, or use alpha < 1");
}

template <class Law>
[[noreturn]] void refuse(const Law& ink, double velocity_average, double top) {
    throw NoSteadyFlow(
        "no steady flow: at a stress of " + brief(stress(ink, std::exp(top) / time_scale(ink))) +
        " Pa this ink still flows slower than " + brief(velocity_average) +
        " m/s through this nozzle; lower the flow rate, widen the nozzle, or use a flow index above 0");
}

template <class Law>
double local_index(const Law& ink, double log_x) {
    return flow_index(ink, std::exp(log_x) / time_scale(ink));
}

/// A power-law ink flows with x_w = (3 + 1/n) K u_avg/R; two steps with the local n come within a few per
/// cent.
template <class Law>
double first_guess(const Law& ink, double log_reduced_velocity, double top) {
    double log_wall = std::min(log_reduced_velocity + std::log(4.0), top);
    for (int i = 0; i < 2; ++i) {
        const double n = std::max(local_index(ink, log_wall), 0.05);
        log_wall = std::min(log_reduced_velocity + std::log(3.0 + 1.0 / n), top);
    }
    return log_wall;
}

/// ln(K γ̇_w) of an average velocity: the root of x_w D(x_w) = 3 K u_avg/R, D = ∫(1−q³)dx/x_w.
template <class Law>
double log_wall_rate(const Law& ink, double radius, double velocity_average) {
    const double log_velocity = std::log(time_scale(ink)) + std::log(velocity_average) - std::log(radius);
    const double target = log_velocity + std::log(3.0);
    // d ln(x_w D)/d ln x_w = 3 n (1 − D)/D, from differentiating x_w D = x_w − t_w⁻³ ∫t³ dx.
    const auto f = [&](double log_wall) -> ValueAndSlope {
        const double d = third_deficit(ink, log_wall);
        return {log_wall + std::log(d) - target, 3.0 * local_index(ink, log_wall) * (1.0 - d) / d};
    };
    const double top =
        std::min(std::log(largest_stable_rate(ink)) + std::log(time_scale(ink)), log_wall_limit);
    const double low = target - 1e-9 * (1.0 + std::abs(target));  // D ≤ 1, so x_w ≥ 3 K u_avg/R
    if (low > top) refuse(ink, velocity_average, top);

    const double guess = std::max(first_guess(ink, log_velocity, top), low);
    double high = std::min(guess + 0.5, top);
    for (double step = 1.0; high < top && f(high).value < 0.0; step *= 2.0) high = std::min(top, high + step);
    if (high == top && f(high).value < 0.0) refuse(ink, velocity_average, top);
    return find_increasing_root(f, {low, high}, guess);
}

template <class Law>
double wall_rate_of(const Law& ink, double radius, double velocity_average) {
    if (const auto fixed = fixed_wall_rate(ink)) return *fixed * velocity_average / radius;
    return std::exp(log_wall_rate(ink, radius, velocity_average) - std::log(time_scale(ink)));
}

/// A plug of the whole pipe does not move.
void require_yielding(const Ink& ink, double radius, double gradient) {
    const double yield = yield_stress(ink);
    if (yield == 0.0 || gradient == 0.0 || 0.5 * gradient * radius > yield) return;
    throw NoSteadyFlow("no flow: the stress at the wall would be " + brief(0.5 * gradient * radius) +
                       " Pa, not above this ink's yield stress of " + brief(yield) +
                       " Pa; it flows above a pressure gradient of " + brief(2.0 * yield / radius) + " Pa/m");
}

double area(double radius) {
    return std::numbers::pi * radius * radius;
}

}  // namespace

NozzleFlow::NozzleFlow(const Ink& ink, double radius, double wall_rate)
    : ink_(ink), radius_(radius), wall_rate_(wall_rate) {
    if (wall_rate == 0.0) return;
    const DeficitIntegrals integrals = std::visit(
        [&](const auto& law) {
            return deficit_integrals(law, std::log(time_scale(law)) + std::log(wall_rate));
        },
        ink);
    const double velocity = radius * wall_rate;
    wall_stress_ = bioprint::stress(ink, wall_rate);
    velocity_average_ = velocity * integrals.third / 3.0;
    velocity_max_ = velocity * integrals.first;
    velocity_excess_ = velocity * integrals.excess / 3.0;
    rate_average_ = wall_rate * integrals.second;
}

NozzleFlow NozzleFlow::from_velocity(const Ink& ink, double radius, double velocity_average) {
    if (velocity_average == 0.0) return {ink, radius, 0.0};
    const double wall_rate =
        std::visit([&](const auto& law) { return wall_rate_of(law, radius, velocity_average); }, ink);
    NozzleFlow flow(ink, radius, wall_rate);
    flow.velocity_average_ = velocity_average;
    return flow;
}

NozzleFlow NozzleFlow::from_flow_rate(const Ink& ink, double radius, double flow_rate) {
    return from_velocity(ink, radius, flow_rate / area(radius));
}

NozzleFlow NozzleFlow::from_pressure_gradient(const Ink& ink, double radius, double gradient) {
    require_yielding(ink, radius, gradient);
    NozzleFlow flow(ink, radius, rate_at_stress(ink, 0.5 * gradient * radius));
    flow.wall_stress_ = 0.5 * gradient * radius;
    return flow;
}

NozzleFlow NozzleFlow::from_wall_rate(const Ink& ink, double radius, double rate) {
    return {ink, radius, rate};
}

double NozzleFlow::flow_rate() const {
    return velocity_average_ * area(radius_);
}

double NozzleFlow::pressure_gradient() const {
    return 2.0 * wall_stress_ / radius_;
}

double NozzleFlow::shear_rate(double r) const {
    if (r >= radius_) return wall_rate_;
    return std::min(rate_at_stress(ink_, stress(r)), wall_rate_);
}

double NozzleFlow::velocity(double r) const {
    if (wall_rate_ == 0.0 || r >= radius_) return 0.0;
    const double rate = shear_rate(r);
    if (rate == 0.0) return velocity_max_;
    const double share = std::visit(
        [&](const auto& law) {
            return velocity_at(law,
                               {.wall_rate = wall_rate_, .rate = rate, .from_wall = (radius_ - r) / radius_});
        },
        ink_);
    return std::min(radius_ * share, velocity_max_);
}

double NozzleFlow::plug_radius() const {
    const double yield = yield_stress(ink_);
    return yield == 0.0 ? 0.0 : radius_ * std::min(1.0, yield / wall_stress_);
}

}  // namespace bioprint
