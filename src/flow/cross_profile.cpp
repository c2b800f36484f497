#include <array>
#include <cmath>

#include "flow/profile.hpp"

namespace bioprint {
namespace {

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

}  // namespace

double time_scale(const CrossInk& ink) {
    return ink.time_constant;
}

DeficitIntegrals deficit_integrals(const CrossInk& ink, double log_wall) {
    return deficit_of(ink).integrals(log_wall);
}

double third_deficit(const CrossInk& ink, double log_wall) {
    return deficit_of(ink).third(log_wall);
}

std::optional<double> fixed_wall_rate(const CrossInk& ink) {
    const bool newtonian = ink.alpha == 0.0 || ink.eta_inf == ink.eta0;
    return newtonian ? std::optional(4.0) : std::nullopt;
}

double velocity_at(const CrossInk& ink, const ProfilePlace& place) {
    // 1/K ( x_r (1 − q_r) + ∫ (1 − q) dx from x_r to x_w ), both positive.
    const double log_wall = std::log(ink.time_constant) + std::log(place.wall_rate);
    const double below = place.rate * place.from_wall;
    const double above =
        place.wall_rate * deficit_of(ink).first_down_to(log_wall, std::log(place.wall_rate / place.rate));
    return below + above;
}

}  // namespace bioprint
