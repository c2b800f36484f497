#include "bioprint/flow/nozzle_flow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "bioprint/errors.hpp"
#include "flow/deficit_integrals.hpp"
#include "numerics/brief.hpp"
#include "numerics/roots.hpp"

namespace bioprint {
namespace {

/// Rates beyond 1e100/K describe nothing; they occur where a stress saturates (α near 1).
const double log_wall_limit = 100.0 * std::log(10.0);

/// The nodes depend on the ink alone, and sweeps and batches ask for the same few inks again and again.
StressDeficit& deficit_of(const CrossInk& ink) {
    struct Cached {
        double alpha = -1.0;
        double ratio = -1.0;
        StressDeficit deficit{0.0, 0.0};
    };
    thread_local std::array<Cached, 16> cache;
    thread_local std::size_t oldest = 0;
    const double ratio = ink.eta_inf / ink.eta0;
    for (Cached& entry : cache) {
        if (entry.alpha == ink.alpha && entry.ratio == ratio) return entry.deficit;
    }
    Cached& entry = cache[oldest];
    oldest = (oldest + 1) % cache.size();
    entry = Cached{ink.alpha, ratio, StressDeficit(ink.alpha, ratio)};
    return entry.deficit;
}

[[noreturn]] void refuse(const CrossInk& ink, double velocity_average, double top) {
    throw NoSteadyFlow("no steady flow: at alpha = " + brief(ink.alpha) +
                       " the stress of this ink reaches at most " +
                       brief(stress(ink, std::exp(top) / ink.time_constant)) +
                       " Pa, too little to drive it at " + brief(velocity_average) +
                       " m/s through this nozzle; lower the flow rate, widen the nozzle, or use alpha < 1");
}

double local_index(const CrossInk& ink, double log_x) {
    return flow_index(ink, std::exp(log_x) / ink.time_constant);
}

/// A power-law ink flows with x_w = (3 + 1/n) K u_avg/R; two steps with the local n come within a few per
/// cent.
double first_guess(const CrossInk& ink, double log_reduced_velocity, double top) {
    double log_wall = std::min(log_reduced_velocity + std::log(4.0), top);
    for (int i = 0; i < 2; ++i) {
        const double n = std::max(local_index(ink, log_wall), 0.05);
        log_wall = std::min(log_reduced_velocity + std::log(3.0 + 1.0 / n), top);
    }
    return log_wall;
}

/// ln(K γ̇_w) of an average velocity: the root of x_w D(x_w) = 3 K u_avg/R, D = ∫(1−q³)dx/x_w.
double log_wall_rate(const CrossInk& ink, double radius, double velocity_average) {
    StressDeficit& deficit = deficit_of(ink);
    const double log_velocity = std::log(ink.time_constant) + std::log(velocity_average) - std::log(radius);
    const double target = log_velocity + std::log(3.0);
    // d ln(x_w D)/d ln x_w = 3 n (1 − D)/D, from differentiating x_w D = x_w − t_w⁻³ ∫t³ dx.
    const auto f = [&](double log_wall) -> ValueAndSlope {
        const double d = deficit.third(log_wall);
        return {log_wall + std::log(d) - target, 3.0 * local_index(ink, log_wall) * (1.0 - d) / d};
    };
    const double top =
        std::min(std::log(largest_stable_rate(ink)) + std::log(ink.time_constant), log_wall_limit);
    const double low = target - 1e-9 * (1.0 + std::abs(target));  // D ≤ 1, so x_w ≥ 3 K u_avg/R
    if (low > top) refuse(ink, velocity_average, top);

    const double guess = std::max(first_guess(ink, log_velocity, top), low);
    double high = std::min(guess + 0.5, top);
    for (double step = 1.0; high < top && f(high).value < 0.0; step *= 2.0) high = std::min(top, high + step);
    if (high == top && f(high).value < 0.0) refuse(ink, velocity_average, top);
    return find_increasing_root(f, {low, high}, guess);
}

double area(double radius) {
    return std::numbers::pi * radius * radius;
}

}  // namespace

NozzleFlow::NozzleFlow(const CrossInk& ink, double radius, double wall_rate)
    : ink_(ink), radius_(radius), wall_rate_(wall_rate) {
    if (wall_rate == 0.0) return;
    const DeficitIntegrals integrals =
        deficit_of(ink).integrals(std::log(ink.time_constant) + std::log(wall_rate));
    const double velocity = radius * wall_rate;
    wall_stress_ = bioprint::stress(ink, wall_rate);
    velocity_average_ = velocity * integrals.third / 3.0;
    velocity_max_ = velocity * integrals.first;
    velocity_excess_ = velocity * integrals.excess / 3.0;
    rate_average_ = wall_rate * integrals.second;
}

NozzleFlow NozzleFlow::from_velocity(const CrossInk& ink, double radius, double velocity_average) {
    if (velocity_average == 0.0) return {ink, radius, 0.0};
    const bool newtonian = ink.alpha == 0.0 || ink.eta_inf == ink.eta0;
    const double wall_rate =
        newtonian ? 4.0 * velocity_average / radius
                  : std::exp(log_wall_rate(ink, radius, velocity_average) - std::log(ink.time_constant));
    NozzleFlow flow(ink, radius, wall_rate);
    flow.velocity_average_ = velocity_average;
    return flow;
}

NozzleFlow NozzleFlow::from_flow_rate(const CrossInk& ink, double radius, double flow_rate) {
    return from_velocity(ink, radius, flow_rate / area(radius));
}

NozzleFlow NozzleFlow::from_pressure_gradient(const CrossInk& ink, double radius, double gradient) {
    NozzleFlow flow(ink, radius, rate_at_stress(ink, 0.5 * gradient * radius));
    flow.wall_stress_ = 0.5 * gradient * radius;
    return flow;
}

NozzleFlow NozzleFlow::from_wall_rate(const CrossInk& ink, double radius, double rate) {
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
    // R/K ( x_r (1 − q_r) + ∫ (1 − q) dx from x_r to x_w ), both positive.
    const double log_wall = std::log(ink_.time_constant) + std::log(wall_rate_);
    const double below = rate * ((radius_ - r) / radius_);
    const double above = wall_rate_ * deficit_of(ink_).first_down_to(log_wall, std::log(wall_rate_ / rate));
    return std::min(radius_ * (below + above), velocity_max_);
}

}  // namespace bioprint
