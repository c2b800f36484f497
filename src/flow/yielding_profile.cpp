#include <cmath>

#include "flow/profile.hpp"

namespace bioprint {
namespace {

HerschelBulkleyInk without_yield(const PowerLawInk& ink) {
    return {.yield_stress = 0.0, .consistency = ink.consistency, .flow_index = ink.flow_index};
}

/// φ = τ_y/τ_w, the radius of the plug over that of the pipe, and ψ = 1 − φ, each by itself.
struct Yield {
    double plug;
    double sheared;
};

Yield yield_of(const HerschelBulkleyInk& ink, double rate) {
    const double flowing = ink.consistency * std::pow(rate, ink.flow_index);
    if (ink.yield_stress == 0.0) return {.plug = 0.0, .sheared = 1.0};
    return {.plug = 1.0 / (1.0 + flowing / ink.yield_stress),
            .sheared = 1.0 / (1.0 + ink.yield_stress / flowing)};
}

/// ∫ (1 − q³) dx/x_w of 1 − q³ = 3φ²ψ(1−z) + 3φψ²(1−z²) + ψ³(1−z³), z = e^{−nv}.
double third_of(const Yield& y, double n) {
    return 3.0 * n * y.sheared *
           (y.plug * y.plug / (1.0 + n) + 2.0 * y.plug * y.sheared / (1.0 + 2.0 * n) +
            y.sheared * y.sheared / (1.0 + 3.0 * n));
}

}  // namespace

double time_scale(const HerschelBulkleyInk& /*ink*/) {
    return 1.0;
}

DeficitIntegrals deficit_integrals(const HerschelBulkleyInk& ink, double log_wall) {
    const double n = ink.flow_index;
    const Yield y = yield_of(ink, std::exp(log_wall));
    const double square = 2.0 * n * n / ((1.0 + n) * (1.0 + 2.0 * n));  // ∫ (1−z)² e^{−v} dv
    return {.first = y.sheared * n / (1.0 + n),
            .second = 2.0 * n * y.sheared * (y.plug / (1.0 + n) + y.sheared / (1.0 + 2.0 * n)),
            .third = third_of(y, n),
            .excess = y.sheared * y.sheared * square *
                      (3.0 * y.plug + 2.0 * y.sheared + y.sheared / (1.0 + 3.0 * n))};
}

double third_deficit(const HerschelBulkleyInk& ink, double log_wall) {
    return third_of(yield_of(ink, std::exp(log_wall)), ink.flow_index);
}

std::optional<double> fixed_wall_rate(const HerschelBulkleyInk& ink) {
    if (ink.yield_stress > 0.0) return std::nullopt;
    return 3.0 + 1.0 / ink.flow_index;
}

double velocity_at(const HerschelBulkleyInk& ink, const ProfilePlace& place) {
    const double n = ink.flow_index;
    const Yield y = yield_of(ink, place.wall_rate);
    // u/u_max = 1 − z^((n+1)/n), z = (τ − τ_y)/(τ_w − τ_y) = 1 − (1 − r/R)/ψ: exact near the wall.
    const double z_below_one = place.from_wall / y.sheared;
    const double top = place.wall_rate * y.sheared * n / (1.0 + n);
    if (z_below_one >= 1.0) return top;
    return -top * std::expm1((1.0 + n) / n * std::log1p(-z_below_one));
}

double time_scale(const PowerLawInk& ink) {
    return time_scale(without_yield(ink));
}

DeficitIntegrals deficit_integrals(const PowerLawInk& ink, double log_wall) {
    return deficit_integrals(without_yield(ink), log_wall);
}

double third_deficit(const PowerLawInk& ink, double log_wall) {
    return third_deficit(without_yield(ink), log_wall);
}

std::optional<double> fixed_wall_rate(const PowerLawInk& ink) {
    return fixed_wall_rate(without_yield(ink));
}

double velocity_at(const PowerLawInk& ink, const ProfilePlace& place) {
    return velocity_at(without_yield(ink), place);
}

}  // namespace bioprint
