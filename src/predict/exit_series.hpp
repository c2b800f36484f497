#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "predict/exit_kind.hpp"

/// How the exit profile depends on the kind of flow: what the table and its maker share.
///
/// The profile is a cubic spline through nodes of the logit y = ln((1 − f + ε)/f): the places where y has the levels
/// 0, ½ … 7, and y at fixed distances in front of the first of them. Each of these numbers is
///
///   Newtonian + Σ c_ij u T_i(2u/u_last − 1) s^j,      u = 1 − n_e,   s² = (n_e − n_w)/(u n_e)
///
/// u is the thinning, zero for a Newtonian ink; s tells an ink that thins most at the wall (Cross at moderate rates,
/// up to 0.95) from a power law (0). In front of the lip the logit changes smoothly with the kind; behind it, where
/// the profile falls the more steeply the more the ink thins, the places do. ε keeps the logit finite where f passes 1
/// by 1e-4, as the Newtonian one does at X = −1.7.
namespace bioprint {

inline constexpr double exit_logit_end = 1e-3;
inline constexpr double exit_level_step = 0.5;
inline constexpr std::size_t exit_levels = 15;
/// From the place of level 0, in nozzle radii.
inline constexpr std::array<double, 28> exit_before{
    -7.5, -7.0,  -6.5, -6.0, -5.5, -5.0, -4.5, -4.0, -3.5,  -3.0,  -2.5,  -2.25, -2.0,  -1.75,
    -1.5, -1.25, -1.0, -0.9, -0.8, -0.7, -0.6, -0.5, -0.44, -0.38, -0.32, -0.26, -0.20, -0.14};
inline constexpr std::size_t exit_node_count = exit_before.size() + exit_levels;
using ExitNodes = std::array<double, exit_node_count>;
inline constexpr double exit_thinning_last = 0.95;
inline constexpr double exit_layering_last = 0.9;
inline constexpr double exit_index_first = 1.0 - exit_thinning_last;  ///< of both indices

inline double exit_logit(double f) {
    return std::log((1.0 - f + exit_logit_end) / f);
}

/// The inverse, and its derivatives over the logit.
struct ExitShare {
    double value;
    double slope;
    double bend;
};
inline ExitShare exit_share(double logit) {
    constexpr double whole = 1.0 + exit_logit_end;
    const double s = 1.0 / (1.0 + std::exp(logit));
    const double slope = -s * (1.0 - s);
    return {.value = whole * s, .slope = whole * slope, .bend = whole * slope * (2.0 * s - 1.0)};
}

/// Chebyshev terms in u for each power of s.
inline constexpr std::array<std::size_t, 4> exit_orders{8, 7, 6, 5};
inline constexpr std::size_t exit_cross_terms = 26;
/// And for inks that thin less at the wall than a power law: u w and u² w, w = (n_w − n_e)/u up to 0.5.
inline constexpr std::size_t exit_term_count = exit_cross_terms + 2;
inline constexpr double exit_recovery_last = 0.5;
using ExitTerms = std::array<double, exit_term_count>;

/// s² of a kind: 0 for a power law and for what thins less at the wall than one.
inline double exit_layering(const ExitKind& kind) {
    const double index = std::max(kind.index, exit_index_first);
    const double u = 1.0 - index;
    if (u < 1e-9) return 0.0;
    return std::clamp((index - std::max(kind.wall_index, exit_index_first)) / (u * index), 0.0,
                      exit_layering_last);
}

inline bool beyond_exit_table(const ExitKind& kind) {
    constexpr double margin = 1e-3;
    return std::min(kind.index, kind.wall_index) < exit_index_first - margin;
}

inline ExitTerms exit_terms(const ExitKind& kind) {
    const double u = std::clamp(1.0 - kind.index, 0.0, exit_thinning_last);
    const double s = std::sqrt(exit_layering(kind));
    const double v = 2.0 * u / exit_thinning_last - 1.0;
    ExitTerms terms{};
    std::size_t n = 0;
    double power = 1.0;
    for (const std::size_t order : exit_orders) {
        double before = v;  // T_-1 = T_1
        double chebyshev = 1.0;
        for (std::size_t i = 0; i < order; ++i) {
            terms[n++] = u * power * chebyshev;
            const double next = 2.0 * v * chebyshev - before;
            before = chebyshev;
            chebyshev = next;
        }
        power *= s;
    }
    const double recovery =
        u > 1e-9 ? std::clamp((kind.wall_index - kind.index) / u, 0.0, exit_recovery_last) : 0.0;
    terms[n++] = u * recovery;
    terms[n] = u * u * recovery;
    return terms;
}

/// The cubic spline of the logit through the nodes, straight beyond its ends.
class ExitSpline {
  public:
    explicit ExitSpline(const ExitNodes& nodes) {
        const std::size_t front = exit_before.size();
        for (std::size_t k = 0; k < exit_node_count; ++k) {
            x_[k] = k < front ? nodes[front] + exit_before[k] : nodes[k];
            y_[k] = k < front ? nodes[k] : exit_level_step * static_cast<double>(k - front);
            if (k > front) x_[k] = std::max(x_[k], x_[k - 1] + least_step);
        }
        ExitNodes upper{};
        for (std::size_t k = 1; k + 1 < exit_node_count; ++k) {
            const double before = x_[k] - x_[k - 1];
            const double after = x_[k + 1] - x_[k];
            const double jump = 6.0 * ((y_[k + 1] - y_[k]) / after - (y_[k] - y_[k - 1]) / before);
            const double pivot = 2.0 * (before + after) - before * upper[k - 1];
            upper[k] = after / pivot;
            bend_[k] = (jump - before * bend_[k - 1]) / pivot;
        }
        for (std::size_t k = exit_node_count - 1; k-- > 1;) bend_[k] -= upper[k] * bend_[k + 1];
    }

    struct Point {
        double logit;
        double slope;
        double bend;
    };
    /// @param k  a piece at or before that of x; moved on to it, so that ascending x need no search
    [[nodiscard]] Point at(double x, std::size_t& k) const {
        while (k + 2 < exit_node_count && x > x_[k + 1]) ++k;
        const double h = x_[k + 1] - x_[k];
        const double within = std::clamp(x, x_.front(), x_.back());
        const double t = (within - x_[k]) / h;
        const double s = 1.0 - t;
        const double a = bend_[k];
        const double b = bend_[k + 1];
        const double slope =
            (y_[k + 1] - y_[k]) / h + h / 6.0 * ((3.0 * t * t - 1.0) * b - (3.0 * s * s - 1.0) * a);
        return {.logit = s * y_[k] + t * y_[k + 1] - h * h / 6.0 * s * t * ((1.0 + s) * a + (1.0 + t) * b) +
                         slope * (x - within),
                .slope = slope,
                .bend = x == within ? s * a + t * b : 0.0};
    }

  private:
    static constexpr double least_step = 0.01;  ///< a third of the steepest simulated profile's
    ExitNodes x_{};
    ExitNodes y_{};
    ExitNodes bend_{};
};

}  // namespace bioprint
