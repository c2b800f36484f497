#include <algorithm>
#include <cmath>

#include "flow/profile.hpp"
#include "numerics/quadrature.hpp"

namespace bioprint {
namespace {

/// Beyond ln(x_w) + 38 the weight e^{−v} is below rounding whatever the integrand.
constexpr double tail = 38.0;

/// e^z past this is no longer told from e^z − 1.
constexpr double huge_exponent = 40.0;

/// 1 − q over v.
class Deficit {
  public:
    Deficit(const CarreauYasudaInk& ink, double log_wall)
        : n_(ink.flow_index),
          a_(ink.transition),
          plateau_(1.0 / (1.0 + std::exp(ink.transition * log_wall))),
          thinned_(1.0 / (1.0 + std::exp(-ink.transition * log_wall))) {
        const double e = ink.eta_inf / ink.eta0;
        if (e == 0.0) return;
        const double z = ink.transition * log_wall;
        const double thinning =
            std::exp((n_ - 1.0) / a_ * (std::max(z, 0.0) + std::log1p(std::exp(-std::abs(z)))));
        newtonian_ = e / (e + (1.0 - e) * thinning);
    }

    double operator()(double v) const {
        const double plain = -std::expm1(-v);
        return newtonian_ * plain - (1.0 - newtonian_) * std::expm1(-thinned(v));
    }

  private:
    /// −ln q of the thinning part.
    [[nodiscard]] double thinned(double v) const {
        const double z = a_ * v;
        if (n_ > 1.0) return v + (1.0 - n_) / a_ * log_of_fall(z);
        const double rise = z < huge_exponent ? std::log1p(plateau_ * std::expm1(z))
                                              : z + std::log(plateau_ + thinned_ * std::exp(-z));
        return n_ * v + (1.0 - n_) / a_ * rise;
    }

    /// ln[(1 + y e^{−z})/(1 + y)]
    [[nodiscard]] double log_of_fall(double z) const {
        const double fall = thinned_ * std::expm1(-z);
        return fall > -0.5 ? std::log1p(fall) : std::log(plateau_ + thinned_ * std::exp(-z));
    }

    double n_;
    double a_;
    double plateau_;  ///< 1/(1+y)
    double thinned_;  ///< y/(1+y)
    double newtonian_ = 0.0;
};

/// Gauss panels over v from 0 to `end`: the nearest singularity of the integrand lies π/a off the real axis, so panels
/// of 4/max(1, a) with 16 points are exact to rounding.
template <class Take>
void over_panels(const CarreauYasudaInk& ink, double end, const Take& take) {
    const double widest = 4.0 / std::max(1.0, ink.transition);
    const auto panels = static_cast<int>(std::ceil(end / widest));
    const double width = panels == 0 ? 0.0 : end / panels;
    const GaussRule& rule = gauss_rule();
    for (int panel = 0; panel < panels; ++panel) {
        for (std::size_t i = 0; i < GaussRule::size; ++i) {
            const double v = width * (panel + rule.node[i]);
            take(v, width * rule.weight[i] * std::exp(-v));
        }
    }
}

double end_of(double log_wall) {
    return tail + std::max(0.0, log_wall);
}

}  // namespace

double time_scale(const CarreauYasudaInk& ink) {
    return ink.time_constant;
}

DeficitIntegrals deficit_integrals(const CarreauYasudaInk& ink, double log_wall) {
    const Deficit deficit(ink, log_wall);
    DeficitIntegrals sum{};
    over_panels(ink, end_of(log_wall), [&](double v, double weight) {
        const double d = deficit(v);
        const double q = 1.0 - d;
        sum.first += weight * d;
        sum.second += weight * d * (1.0 + q);
        sum.third += weight * d * (1.0 + q + q * q);
        sum.excess += weight * d * d * (2.0 + q);
    });
    return sum;
}

double third_deficit(const CarreauYasudaInk& ink, double log_wall) {
    const Deficit deficit(ink, log_wall);
    double sum = 0.0;
    over_panels(ink, end_of(log_wall), [&](double v, double weight) {
        const double d = deficit(v);
        const double q = 1.0 - d;
        sum += weight * d * (1.0 + q + q * q);
    });
    return sum;
}

std::optional<double> fixed_wall_rate(const CarreauYasudaInk& ink) {
    const bool newtonian = ink.flow_index == 1.0 || ink.eta_inf == ink.eta0;
    return newtonian ? std::optional(4.0) : std::nullopt;
}

double velocity_at(const CarreauYasudaInk& ink, const ProfilePlace& place) {
    // 1/K ( x_r (1 − q_r) + ∫ (1 − q) dx from x_r to x_w ), both positive.
    const double log_wall = std::log(ink.time_constant) + std::log(place.wall_rate);
    const Deficit deficit(ink, log_wall);
    double sum = 0.0;
    const double depth = std::min(std::log(place.wall_rate / place.rate), end_of(log_wall));
    over_panels(ink, depth, [&](double v, double weight) { sum += weight * deficit(v); });
    return place.rate * place.from_wall + place.wall_rate * sum;
}

}  // namespace bioprint
