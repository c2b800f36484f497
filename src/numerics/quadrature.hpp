#pragma once

#include <array>
#include <cstddef>
#include <functional>

/// Integrals. The adaptive GSL routes return their own error estimate and are the reference; the fixed
/// Gauss-Legendre rule serves integrands that were first made smooth.
namespace bioprint {

struct Integral {
    double value;
    double error;  ///< GSL's estimate of the absolute error
};

/// ∫ f over [low, high], adaptive Gauss-Kronrod (GSL QAG).
Integral integrate(const std::function<double(double)>& f, double low, double high, double relative = 1e-12);

/// ∫ f over [low, ∞), adaptive (GSL QAGIU).
Integral integrate_to_infinity(const std::function<double(double)>& f, double low, double relative = 1e-12);

/// Nodes and weights of the 16-point Gauss-Legendre rule on [0, 1].
struct GaussRule {
    static constexpr std::size_t size = 16;
    std::array<double, size> node;
    std::array<double, size> weight;
};
const GaussRule& gauss_rule();

}  // namespace bioprint
