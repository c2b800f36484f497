#include "bioprint/rheology/carreau_yasuda.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "bioprint/errors.hpp"
#include "numerics/brief.hpp"
#include "numerics/roots.hpp"

namespace bioprint {
namespace {

// x = Kγ̇, y = x^a, e = η_inf/η0, t(x) = Kτ/η0 = x (e + (1−e)(1+y)^((n−1)/a)): the law without dimensions.

/// Past x = 1e100 no ink is described by anything; the bound also keeps every intermediate finite.
const double log_x_limit = 100.0 * std::log(10.0);

/// Below this index a stress in double precision no longer tells its rate.
constexpr double saturated_index = 1e-13;

/// ln(1 + e^z)
double softplus(double z) {
    return std::max(z, 0.0) + std::log1p(std::exp(-std::abs(z)));
}

/// (1+y)^((n−1)/a), also where y is beyond any number.
double thinning(const CarreauYasudaInk& ink, double x) {
    const double y = std::pow(x, ink.transition);
    if (std::isinf(y)) return std::pow(x, ink.flow_index - 1.0);
    return std::pow(1.0 + y, (ink.flow_index - 1.0) / ink.transition);
}

/// The Newtonian part of the viscosity over the whole.
double newtonian_share(const CarreauYasudaInk& ink, double log_x) {
    const double e = ink.eta_inf / ink.eta0;
    if (e == 0.0) return 0.0;
    const double thinned =
        std::exp((ink.flow_index - 1.0) / ink.transition * softplus(ink.transition * log_x));
    return e / (e + (1.0 - e) * thinned);
}

double local_index(const CarreauYasudaInk& ink, double log_x) {
    const double plateau = 1.0 / (1.0 + std::exp(ink.transition * log_x));
    const double thinned = ink.flow_index + (1.0 - ink.flow_index) * plateau;
    const double share = newtonian_share(ink, log_x);
    return share + (1.0 - share) * thinned;
}

double log_reduced_stress(const CarreauYasudaInk& ink, double log_x) {
    const double e = ink.eta_inf / ink.eta0;
    const double log_thinned = (ink.flow_index - 1.0) / ink.transition * softplus(ink.transition * log_x);
    return log_x + (e == 0.0 ? log_thinned : std::log(e + (1.0 - e) * std::exp(log_thinned)));
}

[[noreturn]] void refuse(const CarreauYasudaInk& ink, double stress) {
    const double bearable = std::exp(log_reduced_stress(ink, log_x_limit)) * ink.eta0 / ink.time_constant;
    throw NoSteadyFlow("no steady flow: this ink bears a stress of at most " + brief(bearable) +
                       " Pa, but the load is " + brief(stress) +
                       " Pa; lower the pressure or the flow rate, or use a flow index above 0");
}

}  // namespace

double viscosity(const CarreauYasudaInk& ink, double rate) {
    return ink.eta_inf + (ink.eta0 - ink.eta_inf) * thinning(ink, ink.time_constant * rate);
}

double stress(const CarreauYasudaInk& ink, double rate) {
    return viscosity(ink, rate) * rate;
}

double largest_stable_rate(const CarreauYasudaInk& /*ink*/) {
    return std::numeric_limits<double>::infinity();
}

double flow_index(const CarreauYasudaInk& ink, double rate) {
    if (rate == 0.0) return 1.0;
    return local_index(ink, std::log(ink.time_constant) + std::log(rate));
}

double rate_at_stress(const CarreauYasudaInk& ink, double stress) {
    if (stress == 0.0) return 0.0;
    if (ink.flow_index == 1.0 || ink.eta_inf == ink.eta0) return stress / ink.eta0;
    const double log_t = std::log(ink.time_constant) + std::log(stress) - std::log(ink.eta0);
    const auto f = [&](double log_x) -> ValueAndSlope {
        return {log_reduced_stress(ink, log_x) - log_t, local_index(ink, log_x)};
    };
    // A thinning ink has t ≤ x and a thickening one t ≥ x; the margin outlasts rounding.
    double low = log_t - 1e-9 * (1.0 + std::abs(log_t));
    for (double step = 1.0; ink.flow_index > 1.0 && f(low).value > 0.0; step *= 2.0) low -= step;
    double high = low;
    for (double step = 1.0; high < log_x_limit && f(high).value < 0.0; step *= 2.0)
        high = std::min(log_x_limit, high + step);
    if (low > log_x_limit || f(high).value < 0.0) refuse(ink, stress);
    const double log_x = find_increasing_root(f, {low, high}, low);
    if (local_index(ink, log_x) < saturated_index) refuse(ink, stress);
    return std::exp(log_x) / ink.time_constant;
}

}  // namespace bioprint
