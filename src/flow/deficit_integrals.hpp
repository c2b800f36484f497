#pragma once

#include <cstddef>
#include <vector>

/// The integrals of a Cross ink's pipe flow over the rate of strain, x from 0 to x_w.
///
/// With x = x_w e^{−v} and y = x_w^α the stress deficit of the Cross part is a ratio of positive terms,
///
///   1 − q = [ (1 − e^{−v}) + y e^{−v}(e^{(1−α)v} − 1) ] / (1 + y e^{−αv}),
///
/// and of the whole law a convex mean of it and the Newtonian 1 − e^{−v}. Its nearest singularity lies π/α
/// off the real axis, so Gauss-Legendre panels of width 4/max(1, α) with 16 points are exact to rounding. All
/// exponentials depend on α and the nodes only: they are computed once, and a step of the root search is
/// plain arithmetic.
namespace bioprint {

/// ∫(1−q)dx, ∫(1−q²)dx, ∫(1−q³)dx and ∫(1−q)²(2+q)dx, each divided by x_w.
struct DeficitIntegrals {
    double first;
    double second;
    double third;
    double excess;
};

class StressDeficit {
  public:
    /// @param alpha            ≥ 0
    /// @param viscosity_ratio  η_inf/η0
    StressDeficit(double alpha, double viscosity_ratio);

    /// Precomputes nodes for wall rates up to `log_wall` = ln(K γ̇_w).
    void reserve(double log_wall);

    [[nodiscard]] DeficitIntegrals integrals(double log_wall);
    /// The third alone, for the root search.
    [[nodiscard]] double third(double log_wall);
    /// (1/x_w) ∫ (1−q) dx from x = x_w e^{−depth} to x_w.
    [[nodiscard]] double first_down_to(double log_wall, double depth) const;

  private:
    /// a (1−e^{−v}) + b D over a + b E is the Cross part, `newtonian` the weight of the other.
    struct Weights {
        double a;
        double b;
        double newtonian;
    };
    [[nodiscard]] Weights weights(double log_wall) const;
    [[nodiscard]] std::size_t node_count(double log_wall) const;

    double alpha_;
    double ratio_;
    double panel_width_;
    std::vector<double> weight_;     // of dx/x_w = e^{−v} dv
    std::vector<double> newtonian_;  // 1 − e^{−v}
    std::vector<double> thinning_;   // e^{−v}(e^{(1−α)v} − 1)
    std::vector<double> decay_;      // e^{−αv}
};

}  // namespace bioprint
