#pragma once

#include <cmath>

/// The one shape integral an ellipsoid of revolution needs, in closed form: α2 = α3 = α1^(-1/2), x = ln α1.
///
///   g2'' = 2 α1^-3 J(κ),   κ = 1 − α1^-3,   J = ∫_1^∞ (v²−1)/(v²(v²−κ)²) dv = ((3−κ) T(κ) − 3)/(2κ²)
///   T = artanh(√κ)/√κ for κ > 0, arctan(√−κ)/√−κ for κ < 0; near the sphere the power series of J.
///
/// Accuracy: 2e-14 relative for α1 from 1/400 to 400 (tests/verify/axis_passage.cpp); finite from 1e-26 to 1e26.
namespace bioprint {

inline double spheroid_integral(double log_stretch) {
    const double inverse = std::exp(-3.0 * log_stretch);
    const double kappa = -std::expm1(-3.0 * log_stretch);
    if (std::abs(kappa) < 0.25) {
        double sum = 0.0;
        for (int n = 26; n >= 0; --n) sum = sum * kappa + 2.0 * (n + 1) / ((2.0 * n + 3.0) * (2.0 * n + 5.0));
        return 2.0 * inverse * sum;
    }
    const double root = std::sqrt(std::abs(kappa));
    const double t = kappa > 0.0 ? (std::log1p(root) + 1.5 * log_stretch) / root : std::atan(root) / root;
    return inverse * ((3.0 - kappa) * t - 3.0) / (kappa * kappa);
}

}  // namespace bioprint
