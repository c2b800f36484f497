#include "flow/deficit_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/quadrature.hpp"

namespace bioprint {
namespace {

/// Beyond ln(x_w) + 38 the weight e^{−v} is below rounding whatever the integrand.
constexpr double tail = 38.0;

double thinning_at(double v, double alpha) {
    return std::exp(-v) * std::expm1((1.0 - alpha) * v);
}

}  // namespace

StressDeficit::StressDeficit(double alpha, double viscosity_ratio)
    : alpha_(alpha), ratio_(viscosity_ratio), panel_width_(4.0 / std::max(1.0, alpha)) {}

std::size_t StressDeficit::node_count(double log_wall) const {
    const double panels = std::ceil((tail + std::max(0.0, log_wall)) / panel_width_);
    return static_cast<std::size_t>(panels) * GaussRule::size;
}

void StressDeficit::reserve(double log_wall) {
    const std::size_t count = node_count(log_wall);
    const GaussRule& rule = gauss_rule();
    for (std::size_t i = weight_.size(); i < count; ++i) {
        const std::size_t panel = i / GaussRule::size;
        const double v = panel_width_ * (static_cast<double>(panel) + rule.node[i % GaussRule::size]);
        weight_.push_back(panel_width_ * rule.weight[i % GaussRule::size] * std::exp(-v));
        newtonian_.push_back(-std::expm1(-v));
        thinning_.push_back(thinning_at(v, alpha_));
        decay_.push_back(std::exp(-alpha_ * v));
    }
}

StressDeficit::Weights StressDeficit::weights(double log_wall) const {
    // Divided by 1 + y, so that neither a huge nor a tiny y overflows.
    const double a = 1.0 / (1.0 + std::exp(alpha_ * log_wall));
    const double b = 1.0 / (1.0 + std::exp(-alpha_ * log_wall));
    return {.a = a, .b = b, .newtonian = ratio_ == 0.0 ? 0.0 : ratio_ / (ratio_ + (1.0 - ratio_) * a)};
}

double StressDeficit::third(double log_wall) {
    reserve(log_wall);
    const Weights w = weights(log_wall);
    const double a = w.a;
    const double b = w.b;
    const double mean = w.newtonian;
    const double* const weight = weight_.data();
    const double* const plain = newtonian_.data();
    const double* const thinning = thinning_.data();
    const double* const decay = decay_.data();
    const std::size_t n = node_count(log_wall);
    double sum = 0.0;
#pragma omp simd reduction(+ : sum)
    for (std::size_t i = 0; i < n; ++i) {
        const double cross = (a * plain[i] + b * thinning[i]) / (a + b * decay[i]);
        const double deficit = mean * plain[i] + (1.0 - mean) * cross;
        const double q = 1.0 - deficit;
        sum += weight[i] * deficit * (1.0 + q + q * q);
    }
    return sum;
}

DeficitIntegrals StressDeficit::integrals(double log_wall) {
    reserve(log_wall);
    const Weights w = weights(log_wall);
    const std::size_t n = node_count(log_wall);
    DeficitIntegrals sum{};
    for (std::size_t i = 0; i < n; ++i) {
        const double cross = (w.a * newtonian_[i] + w.b * thinning_[i]) / (w.a + w.b * decay_[i]);
        const double deficit = w.newtonian * newtonian_[i] + (1.0 - w.newtonian) * cross;
        const double q = 1.0 - deficit;
        sum.first += weight_[i] * deficit;
        sum.second += weight_[i] * deficit * (1.0 + q);
        sum.third += weight_[i] * deficit * (1.0 + q + q * q);
        sum.excess += weight_[i] * deficit * deficit * (2.0 + q);
    }
    return sum;
}

double StressDeficit::first_down_to(double log_wall, double depth) const {
    const auto [a, b, newtonian] = weights(log_wall);
    const double end = std::min(depth, tail + std::max(0.0, log_wall));
    const auto panels = static_cast<std::size_t>(std::ceil(end / panel_width_));
    const double width = panels == 0 ? 0.0 : end / static_cast<double>(panels);
    const GaussRule& rule = gauss_rule();
    double sum = 0.0;
    for (std::size_t panel = 0; panel < panels; ++panel) {
        for (std::size_t i = 0; i < GaussRule::size; ++i) {
            const double v = width * (static_cast<double>(panel) + rule.node[i]);
            const double plain = -std::expm1(-v);
            const double thinned = (a * plain + b * thinning_at(v, alpha_)) / (a + b * std::exp(-alpha_ * v));
            sum += width * rule.weight[i] * std::exp(-v) * (newtonian * plain + (1.0 - newtonian) * thinned);
        }
    }
    return sum;
}

}  // namespace bioprint
