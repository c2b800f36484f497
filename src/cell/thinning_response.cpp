#include "cell/thinning_response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bioprint {
namespace {

/// The disturbance round a sphere with surface velocity diag(1, −½, −½)·x, at one point of the ink: ε':ε' and
/// e:ε' for unit sizes (e:e = 3/2), and the weight of the point in an integral over the outside.
struct Point {
    double weight;
    double square;
    double product;
};

// Gauss-Legendre on (0, 1).
constexpr std::array<double, 6> node{0.033765242898423986, 0.16939530676686774, 0.38069040695840155,
                                     0.61930959304159845,  0.83060469323313226, 0.96623475710157601};
constexpr std::array<double, 6> gauss_weight{0.085662246189585173, 0.18038078652406930, 0.23395696728634552,
                                             0.23395696728634552,  0.18038078652406930, 0.085662246189585173};

/// With ρ = r^-3 the volume element is dρ/ρ², and every product of rates falls as ρ² at least.
Point point(double rho, double cosine) {
    const double r3 = rho;
    const double r5 = std::pow(rho, 5.0 / 3.0);
    const double c2 = cosine * cosine;
    const double s2 = 1.0 - c2;
    const double p = 0.5 * (3.0 * c2 - 1.0);
    const double radial = 2.5 * r3 - 1.5 * r5;  // u_r = radial · p · r, u_θ = ½ r^-4 dP2/dθ
    const double tangential = 0.5 * r5;
    const double rr = (6.0 * r5 - 5.0 * r3) * p;
    const double tt = -3.0 * (c2 - s2) * tangential + radial * p;
    const double pp = radial * p - 3.0 * c2 * tangential;
    const double shear = (2.5 * r3 - 4.0 * r5);  // of both: times ½ dP2/dθ = −(3/2) cos sin
    const double quarter = 2.25 * c2 * s2;
    const double ett = p - 1.5 * (c2 - s2);
    const double epp = p - 1.5 * c2;
    return {.weight = 1.0 / (rho * rho),
            .square = rr * rr + tt * tt + pp * pp + 2.0 * quarter * shear * shear,
            .product = p * rr + ett * tt + epp * pp + 2.0 * quarter * shear};
}

using Points = std::array<Point, 36>;

const Points& points() {
    static const Points all = [] {
        Points list{};
        for (std::size_t i = 0; i < node.size(); ++i) {
            for (std::size_t j = 0; j < node.size(); ++j) {
                Point q = point(node[i], node[j]);
                q.weight *= gauss_weight[i] * gauss_weight[j];
                list[node.size() * i + j] = q;
            }
        }
        return list;
    }();
    return all;
}

/// γ̇^α of the disturbed ink at every point, for e = cos φ and d − e = sin φ.
using Powers = std::array<double, 36>;

constexpr double deepest_level = 0.97;
constexpr double least_ratio = 0.05;

Powers powers(double cosine, double sine, double alpha) {
    Powers p{};
    for (std::size_t k = 0; k < points().size(); ++k) {
        const Point& q = points()[k];
        const double square =
            cosine * cosine + (2.0 * cosine * sine * q.product + sine * sine * q.square) / 1.5;
        p[k] = std::pow(std::max(square, 0.0), 0.5 * alpha);
    }
    return p;
}

/// c_b (1 + X) with X/(1 + X) = level, X = (K γ̇)^α of unit size. The undisturbed viscosity drops out: the
/// average of ε' over every shell round the sphere is zero.
double response(const Powers& p, double cosine, double sine, double level) {
    double top = 0.0;
    double bottom = 0.0;
    for (std::size_t k = 0; k < points().size(); ++k) {
        const Point& q = points()[k];
        const double near = 1.0 / (1.0 + level * (p[k] - 1.0));
        top += q.weight * near * (q.square + cosine / sine * q.product);
        bottom += q.weight * q.square;
    }
    return top / bottom;
}

struct Sizes {
    double size;
    double angle;  ///< −π/2 to π/2: disturbance against elongation
};

Sizes sizes(double elongation, double disturbance) {
    const double sign = elongation < 0.0 ? -1.0 : 1.0;
    return {.size = std::sqrt(elongation * elongation + disturbance * disturbance),
            .angle = std::atan2(sign * disturbance, std::abs(elongation))};
}

/// cos(n π (k + ½)/N): the Chebyshev polynomials at their nodes.
template <std::size_t N>
struct Cosines {
    std::array<std::array<double, N>, N> value{};
    Cosines() {
        for (std::size_t n = 0; n < N; ++n) {
            for (std::size_t k = 0; k < N; ++k) {
                value[n][k] =
                    std::cos(std::numbers::pi * static_cast<double>(n) * (static_cast<double>(k) + 0.5) / N);
            }
        }
    }
};

}  // namespace

ThinningResponse::ThinningResponse(double alpha, double time_constant)
    : alpha_(alpha), time_constant_(time_constant) {
    if (alpha == 0.0) return;
    static const Cosines<angles> in_angle;
    static const Cosines<levels> in_level;
    std::array<std::array<double, levels>, angles> rows{};  // transformed over the levels
    for (std::size_t i = 0; i < angles; ++i) {
        const double angle = 0.5 * std::numbers::pi * in_angle.value[1][i];
        const double cosine = std::cos(angle);
        const double sine = std::sin(angle);
        const Powers p = powers(cosine, sine, alpha);
        for (std::size_t j = 0; j < levels; ++j) {
            const double value = response(p, cosine, sine, 0.5 * (1.0 + in_level.value[1][j]));
            for (std::size_t n = 0; n < levels; ++n) rows[i][n] += value * in_level.value[n][j];
        }
    }
    for (std::size_t m = 0; m < angles; ++m) {
        for (std::size_t n = 0; n < levels; ++n) {
            double sum = 0.0;
            for (std::size_t i = 0; i < angles; ++i) sum += rows[i][n] * in_angle.value[m][i];
            series_[n][m] = sum * (m == 0 ? 1.0 : 2.0) * (n == 0 ? 1.0 : 2.0) / (angles * levels);
        }
    }
}

double ThinningResponse::operator()(double elongation, double disturbance) const {
    if (alpha_ == 0.0) return 0.5;
    const Sizes s = sizes(elongation, disturbance);
    if (s.size == 0.0) return 1.0;
    const double power = std::pow(time_constant_ * std::numbers::sqrt3 * s.size, alpha_);
    return ratio(s.angle, power / (1.0 + power)) / (1.0 + power);
}

double ThinningResponse::relative(double elongation, double disturbance, double level) const {
    const Sizes s = sizes(elongation, disturbance);
    return alpha_ == 0.0 || s.size == 0.0 ? 1.0 : ratio(s.angle, level);
}

double ThinningResponse::ratio(double angle, double level) const {
    // Deep in the power law the ratio no longer changes but where the ink is at rest around the cell.
    const double u = 4.0 * std::min(level, deepest_level) - 2.0;
    const double v = 2.0 * (angle / (0.5 * std::numbers::pi));
    // Clenshaw's sum over the levels, all angles side by side, then that over the angles.
    std::array<double, angles> rows{};
    std::array<double, angles> before{};
    for (std::size_t n = levels - 1; n > 0; --n) {
        for (std::size_t m = 0; m < angles; ++m) {
            const double next = u * rows[m] - before[m] + series_[n][m];
            before[m] = rows[m];
            rows[m] = next;
        }
    }
    for (std::size_t m = 0; m < angles; ++m) rows[m] = 0.5 * u * rows[m] - before[m] + series_[0][m];
    double b1 = 0.0;
    double b2 = 0.0;
    for (std::size_t m = angles - 1; m > 0; --m) {
        const double b = v * b1 - b2 + rows[m];
        b2 = b1;
        b1 = b;
    }
    return std::max(0.5 * v * b1 - b2 + rows[0], least_ratio);
}

double ThinningResponse::integral(double elongation, double disturbance) const {
    const Sizes s = sizes(elongation, disturbance);
    // The integrand is finite at both ends of the angle; a thousandth aside of them it has its digits.
    const double smallest = 1e-4;
    double angle = std::clamp(s.angle, smallest - 0.5 * std::numbers::pi, 0.5 * std::numbers::pi - smallest);
    if (std::abs(angle) < smallest) angle = smallest;
    const double power = std::pow(time_constant_ * std::numbers::sqrt3 * s.size, alpha_);
    const Powers p = powers(std::cos(angle), std::sin(angle), alpha_);
    return response(p, std::cos(angle), std::sin(angle), power / (1.0 + power)) / (1.0 + power);
}

}  // namespace bioprint
