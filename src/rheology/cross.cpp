#include "bioprint/rheology/cross.hpp"

#include <cmath>
#include <limits>
#include <string>

#include "bioprint/errors.hpp"
#include "numerics/brief.hpp"
#include "numerics/roots.hpp"

namespace bioprint {
namespace {

// x = Kγ̇, e = η_inf/η0, t(x) = Kτ/η0 = x (e + (1−e)/(1+x^α)): the law without dimensions.

/// Past x = 1e100 no ink is described by anything; the bound also keeps every intermediate finite.
const double log_x_limit = 100.0 * std::log(10.0);

double log_reduced_stress(double log_x, double alpha, double e) {
    return log_x + std::log(e + (1.0 - e) / (1.0 + std::exp(alpha * log_x)));
}

/// d ln t/d ln x: 1 for a Newtonian ink, 0 where the stress saturates.
double local_index(double log_x, double alpha, double e) {
    const double y = std::exp(alpha * log_x);
    return 1.0 - alpha * (1.0 - e) / (e * (1.0 + y) + 1.0 - e) * (1.0 / (1.0 + 1.0 / y));
}

/// Below this index a stress in double precision no longer tells its rate.
constexpr double saturated_index = 1e-13;

/// The x at which t stops growing: the smaller root of e(1+y)² + (1−e)(1+(1−α)y) = 0, y = x^α.
double largest_stable_x(double alpha, double e) {
    const double infinity = std::numeric_limits<double>::infinity();
    if (alpha <= 1.0) return infinity;
    const double half_b = e + 0.5 * (1.0 - e) * (1.0 - alpha);  // e y² + 2 half_b y + 1 = 0
    const double discriminant = half_b * half_b - e;
    if (half_b >= 0.0 || discriminant < 0.0) return infinity;
    const double y = 1.0 / (-half_b + std::sqrt(discriminant));
    return std::pow(y, 1.0 / alpha);
}

[[noreturn]] void refuse(const CrossInk& ink, double stress, double top) {
    const double bearable =
        std::exp(log_reduced_stress(top, ink.alpha, ink.eta_inf / ink.eta0)) * ink.eta0 / ink.time_constant;
    throw NoSteadyFlow("no steady flow: this ink bears a stress of at most " + brief(bearable) +
                       " Pa, but the load is " + brief(stress) +
                       " Pa; lower the pressure or the flow rate, or use alpha < 1");
}

}  // namespace

double viscosity(const CrossInk& ink, double rate) {
    return ink.eta_inf + (ink.eta0 - ink.eta_inf) / (1.0 + std::pow(ink.time_constant * rate, ink.alpha));
}

double stress(const CrossInk& ink, double rate) {
    return viscosity(ink, rate) * rate;
}

double largest_stable_rate(const CrossInk& ink) {
    return largest_stable_x(ink.alpha, ink.eta_inf / ink.eta0) / ink.time_constant;
}

double flow_index(const CrossInk& ink, double rate) {
    if (rate == 0.0) return 1.0;
    return local_index(std::log(ink.time_constant) + std::log(rate), ink.alpha, ink.eta_inf / ink.eta0);
}

double rate_at_stress(const CrossInk& ink, double stress) {
    if (stress == 0.0) return 0.0;
    const double e = ink.eta_inf / ink.eta0;
    if (ink.alpha == 0.0) return stress / (0.5 * (ink.eta0 + ink.eta_inf));

    const double log_t = std::log(ink.time_constant) + std::log(stress) - std::log(ink.eta0);
    const auto f = [&](double log_x) -> ValueAndSlope {
        return {log_reduced_stress(log_x, ink.alpha, e) - log_t, local_index(log_x, ink.alpha, e)};
    };
    const double top = std::min(std::log(largest_stable_x(ink.alpha, e)), log_x_limit);
    // t ≤ x, so x ≥ t; the margin outlasts rounding.
    const double low = log_t - 1e-9 * (1.0 + std::abs(log_t));
    double high = low;
    for (double step = 1.0; high < top && f(high).value < 0.0; step *= 2.0) high = std::min(top, high + step);
    if (low > top || f(high).value < 0.0) refuse(ink, stress, top);
    const double log_x = find_increasing_root(f, {low, high}, low);
    if (local_index(log_x, ink.alpha, e) < saturated_index) refuse(ink, stress, top);
    return std::exp(log_x) / ink.time_constant;
}

}  // namespace bioprint
