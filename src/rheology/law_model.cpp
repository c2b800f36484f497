#include "rheology/law_model.hpp"

#include <algorithm>
#include <cmath>

namespace bioprint {
namespace {

/// ln(1 + e^y).
double softplus(double y) {
    return y > 0.0 ? y + std::log1p(std::exp(-y)) : std::log1p(std::exp(y));
}

/// 1/(1 + e^−y).
double logistic(double y) {
    return y > 0.0 ? 1.0 / (1.0 + std::exp(-y)) : std::exp(y) / (1.0 + std::exp(y));
}

/// ln(e^a + e^b) and the share of e^a in it.
struct LogSum {
    double value;
    double share;
};
LogSum log_sum(double a, double b) {
    return {std::max(a, b) + std::log1p(std::exp(-std::abs(a - b))), logistic(a - b)};
}

/// The part that thins: ln η of it, and its gradient by (ln Δη, ln K, …).
LawValue thinning(FittedLaw law, std::span<const double> theta, double log_rate) {
    LawValue v{};
    if (law == FittedLaw::cross) {
        const double alpha = std::exp(theta[2]);
        const double y = alpha * (theta[1] + log_rate);
        const double s = logistic(y);
        v.log_viscosity = theta[0] - softplus(y);
        v.gradient = {1.0, -s * alpha, -s * y};
        return v;
    }
    const double a = std::exp(theta[2]);
    const double m = std::exp(theta[3]);  // 1 − n
    const double y = a * (theta[1] + log_rate);
    const double s = logistic(y);
    const double p = softplus(y);
    v.log_viscosity = theta[0] - m / a * p;
    v.gradient = {1.0, -m * s, m / a * (p - s * y), -m / a * p};
    return v;
}

constexpr std::array<ParameterShape, 1> newtonian_shapes = {{{"eta0"}}};
constexpr std::array<ParameterShape, 2> power_shapes = {{{"consistency"}, {"flow_index"}}};
constexpr std::array<ParameterShape, 4> cross_shapes = {
    {{"eta0"}, {"time_constant"}, {"alpha"}, {"eta_inf"}}};
constexpr std::array<ParameterShape, 5> carreau_shapes = {
    {{"eta0"}, {"time_constant"}, {"transition"}, {"flow_index", true}, {"eta_inf"}}};
constexpr std::array<ParameterShape, 3> herschel_shapes = {
    {{"yield_stress"}, {"consistency"}, {"flow_index"}}};

}  // namespace

std::string_view law_name(FittedLaw law) {
    static constexpr std::array<std::string_view, 5> names = {"newtonian", "power-law", "cross",
                                                              "carreau-yasuda", "herschel-bulkley"};
    return names.at(static_cast<std::size_t>(law));
}

std::span<const ParameterShape> LawModel::shapes() const {
    const std::size_t without = choice_.fit_eta_inf ? 0 : 1;
    switch (choice_.law) {
        case FittedLaw::newtonian:
            return newtonian_shapes;
        case FittedLaw::power_law:
            return power_shapes;
        case FittedLaw::cross:
            return std::span(cross_shapes).first(cross_shapes.size() - without);
        case FittedLaw::carreau_yasuda:
            return std::span(carreau_shapes).first(carreau_shapes.size() - without);
        case FittedLaw::herschel_bulkley:
            return herschel_shapes;
    }
    return newtonian_shapes;
}

LawValue LawModel::at(std::span<const double> theta, double log_rate) const {
    switch (choice_.law) {
        case FittedLaw::newtonian:
            return {theta[0], {1.0}};
        case FittedLaw::power_law: {
            const double n = std::exp(theta[1]);
            return {theta[0] + (n - 1.0) * log_rate, {1.0, n * log_rate}};
        }
        case FittedLaw::herschel_bulkley: {
            const double n = std::exp(theta[2]);
            const LogSum sum = log_sum(theta[0] - log_rate, theta[1] + (n - 1.0) * log_rate);
            return {sum.value, {sum.share, 1.0 - sum.share, (1.0 - sum.share) * n * log_rate}};
        }
        case FittedLaw::cross:
        case FittedLaw::carreau_yasuda:
            break;
    }
    LawValue v = thinning(choice_.law, theta, log_rate);
    const std::size_t last = parameters() - 1;
    if (!choice_.fit_eta_inf && eta_inf_ <= 0.0) return v;
    const double log_floor = choice_.fit_eta_inf ? theta[last] : std::log(eta_inf_);
    const LogSum sum = log_sum(v.log_viscosity, log_floor);
    for (double& g : v.gradient) g *= sum.share;
    if (choice_.fit_eta_inf) v.gradient.at(last) = 1.0 - sum.share;
    v.log_viscosity = sum.value;
    return v;
}

bool LawModel::allows(std::span<const double> theta, double low, double high) const {
    constexpr double decade = 2.302585092994046;
    // A time constant 4 decades past the rates, an exponent from 1e-4 to 30: the curve within the rates is then a
    // power law, a plateau or a corner, whatever the number.
    const auto exponent = [](double t) { return t > -4.0 * decade && t < 1.5 * decade; };
    const auto plain = [](double t) { return std::abs(t) < 100.0 * decade; };
    if (!std::all_of(theta.begin(), theta.end(), plain)) return false;
    if (choice_.law == FittedLaw::power_law) return exponent(theta[1]);
    if (choice_.law == FittedLaw::herschel_bulkley) return exponent(theta[2]);
    if (!has_plateau()) return true;
    const bool time = theta[1] > -high - 4.0 * decade && theta[1] < -low + 4.0 * decade;
    return time && exponent(theta[2]) && (choice_.law == FittedLaw::cross || exponent(theta[3]));
}

void LawModel::report(std::span<const double> theta, std::span<double> log_values,
                      std::span<double> jacobian) const {
    const std::size_t p = parameters();
    std::fill(jacobian.begin(), jacobian.end(), 0.0);
    for (std::size_t i = 0; i < p; ++i) {
        log_values[i] = theta[i];
        jacobian[i * p + i] = 1.0;
    }
    if (!has_plateau()) return;
    // η0 = Δη + η∞
    if (choice_.fit_eta_inf) {
        const LogSum sum = log_sum(theta[0], theta[p - 1]);
        log_values[0] = sum.value;
        jacobian[0] = sum.share;
        jacobian[p - 1] = 1.0 - sum.share;
    } else if (eta_inf_ > 0.0) {
        const LogSum sum = log_sum(theta[0], std::log(eta_inf_));
        log_values[0] = sum.value;
        jacobian[0] = sum.share;
    }
}

}  // namespace bioprint
