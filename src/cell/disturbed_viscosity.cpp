#include "cell/disturbed_viscosity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bioprint {
namespace {

/// α, the exponent with which a law thins at most.
double thinning_exponent(const CrossInk& ink) {
    return ink.alpha;
}
double thinning_exponent(const PowerLawInk& ink) {
    return std::max(0.0, 1.0 - ink.flow_index);
}
double thinning_exponent(const CarreauYasudaInk& ink) {
    return std::max(0.0, 1.0 - ink.flow_index);
}
double thinning_exponent(const HerschelBulkleyInk& ink) {
    return std::max(0.0, 1.0 - ink.flow_index);
}

double time_constant(const Ink& ink) {
    const auto* cross = std::get_if<CrossInk>(&ink);
    return cross == nullptr ? 1.0 : cross->time_constant;
}

}  // namespace

DisturbedViscosity::DisturbedViscosity(const Ink& ink, double least_rate)
    : ink_(ink), least_rate_(least_rate) {
    const double alpha = std::visit([](const auto& law) { return thinning_exponent(law); }, ink);
    newtonian_ = alpha == 0.0 && yield_stress(ink) == 0.0;
    if (alpha > 0.0) thinning_.emplace(alpha, time_constant(ink));
    if (yield_stress(ink) > 0.0) yielding_.emplace(1.0, 1.0);
}

double DisturbedViscosity::operator()(double elongation, double disturbance) const {
    if (const auto* cross = std::get_if<CrossInk>(&ink_)) {
        const double c = thinning_ ? (*thinning_)(elongation, disturbance) : 0.5;
        return cross->eta_inf + (cross->eta0 - cross->eta_inf) * c;
    }
    const double rate = std::max(std::numbers::sqrt3 * std::hypot(elongation, disturbance), least_rate_);
    const auto part = [&](const std::optional<ThinningResponse>& response, double level) {
        return response ? response->relative(elongation, disturbance, level) : 1.0;
    };
    if (const auto* carreau = std::get_if<CarreauYasudaInk>(&ink_)) {
        const double level = 1.0 / (1.0 + std::pow(carreau->time_constant * rate, -carreau->transition));
        return carreau->eta_inf + (viscosity(*carreau, rate) - carreau->eta_inf) * part(thinning_, level);
    }
    const double yielding = yield_stress(ink_) / rate;
    return yielding * part(yielding_, 1.0) + (viscosity(ink_, rate) - yielding) * part(thinning_, 1.0);
}

}  // namespace bioprint
