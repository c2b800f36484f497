#include "cell/planar_cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/cell/shape_integrals.hpp"

namespace bioprint {
namespace {

/// C_xx and C_rr, their squares less 1, and C_rx.
struct Factor {
    double xx;
    double rr;
    double excess_x;
    double excess_r;
    double rx;
};

Factor factor(const PlanarState& y) {
    const double x = std::expm1(2.0 * y[0]);
    const double r = std::expm1(2.0 * y[1]);
    return {.xx = std::sqrt(1.0 + x), .rr = std::sqrt(1.0 + r), .excess_x = x, .excess_r = r, .rx = y[2]};
}

PlanarStrain strain_of(const Factor& c) {
    const double both = c.excess_x + c.excess_r + c.excess_x * c.excess_r;
    return {.xx = c.excess_x,
            .xr = c.rx * c.xx,
            .rr = c.excess_r + c.rx * c.rx,
            .tt = -both / ((1.0 + c.excess_x) * (1.0 + c.excess_r))};
}

/// B − 1 in its axes: the first lies at the angle with cosine c and sine s to x.
struct Principal {
    std::array<double, 3> excess;
    double c;
    double s;
};

/// The larger principal value in the plane comes first.
Principal principal(const PlanarStrain& b) {
    const double mean = 0.5 * (b.xx + b.rr);
    const double half = 0.5 * (b.xx - b.rr);
    const double square = half * half + b.xr * b.xr;
    const double spread = square > 1e-280 ? std::sqrt(square) : std::hypot(half, b.xr);
    Principal p{.excess = {mean + spread, mean - spread, b.tt}, .c = 1.0, .s = 0.0};
    if (spread > 0.0) {
        // Half of the double angle; the larger of the two from a root, the other from the product.
        if (half >= 0.0) {
            p.c = std::sqrt(0.5 * (1.0 + half / spread));
            p.s = 0.5 * b.xr / spread / p.c;
        } else {
            p.s = std::copysign(std::sqrt(0.5 * (1.0 - half / spread)), b.xr);
            p.c = 0.5 * b.xr / spread / p.s;
        }
    }
    return p;
}

/// α_i²; the smallest of very unequal ones is below the round-off of the largest, the volume gives it.
std::array<double, 3> squares_of(const std::array<double, 3>& excess) {
    std::array<double, 3> q{1.0 + excess[0], 1.0 + excess[1], 1.0 + excess[2]};
    const std::size_t least = q[1] < q[2] ? 1 : 2;
    if (std::max(q[0], q[2]) > 4.0) q[least] = 1.0 / (q[0] * q[3 - least]);
    return q;
}

/// The flow's gradient in the cell's axes 1 and 2, axis 3 being θ.
struct Turned {
    double d11;
    double d22;
    double d12;   ///< symmetric part
    double spin;  ///< ½(∂u1/∂x2 − ∂u2/∂x1), the same in every frame
};

Turned turned(const PlanarFlow& f, const Principal& p) {
    const double shear = 0.5 * (f.xr + f.rx);
    return {.d11 = p.c * p.c * f.xx + p.s * p.s * f.rr + 2.0 * p.c * p.s * shear,
            .d22 = p.s * p.s * f.xx + p.c * p.c * f.rr - 2.0 * p.c * p.s * shear,
            .d12 = p.c * p.s * (f.rr - f.xx) + (p.c * p.c - p.s * p.s) * shear,
            .spin = 0.5 * (f.xr - f.rx)};
}

/// The gradient inside, in the cell's axes.
struct Inside {
    Turned rate;
    double d33;
};

Inside inside(const PlanarCell& cell, const PlanarFlow& flow, const Principal& p) {
    const std::array<double, 3> q = squares_of(p.excess);
    // Needles and discs are differences of nearly equal integrals.
    const bool moderate = std::max(q[0], q[2]) < 100.0;
    const ShapeIntegrals shape = moderate ? shape_integrals_brief(q) : shape_integrals(q);
    const auto& g = shape.second;
    const Turned e = turned(flow, p);
    const std::array<double, 3> rate{e.d11, e.d22, flow.tt};
    const double determinant = g[0] * g[1] + g[1] * g[2] + g[2] * g[0];
    const double triple = g[0] * g[1] * g[2];
    const double c = 1.0 - cell.viscosity_ratio;
    const double mean = (p.excess[0] + p.excess[1] + p.excess[2]) / 3.0;
    const double elastic = 0.5 * cell.shear_modulus / flow.viscosity;

    // E* = c d − (μ/2η) dev B and S:E* = d − e, as in transient.cpp.
    std::array<double, 3> m{};
    std::array<double, 3> reduced{};
    double top = 0.0;
    double bottom = 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        m[i] = elastic * (p.excess[i] - mean) - c * rate[i];
        reduced[i] = g[i] - 0.5 * determinant * c;
        top += 0.5 * triple * m[i] / reduced[i];
        bottom += 0.5 * triple * c / (g[i] * reduced[i]);
    }
    const double s = top / bottom;
    std::array<double, 3> y{};
    for (std::size_t i = 0; i < 3; ++i) y[i] = (s - 0.5 * determinant * m[i]) / reduced[i];
    const double trace = (y[0] + y[1] + y[2]) / 3.0;

    const double h = 0.5 * (q[0] + q[1]) * shape.first[2];
    const double y12 = c * h * e.d12 / (1.0 - c * h);
    const double r = (q[0] - q[1]) / (q[0] + q[1]);
    return {.rate = {.d11 = e.d11 + y[0] - trace,
                     .d22 = e.d22 + y[1] - trace,
                     .d12 = e.d12 + y12,
                     .spin = e.spin + r * y12},
            .d33 = flow.tt + y[2] - trace};
}

}  // namespace

PlanarStrain planar_strain(const PlanarState& y) {
    return strain_of(factor(y));
}

PlanarState planar_state(const PlanarStrain& b) {
    const double log_x = 0.5 * std::log1p(b.xx);
    const double rx = b.xr * std::exp(-log_x);
    const double log_r = 0.5 * std::log1p(b.rr - rx * rx);
    const double mean = (log_x + log_r + 0.5 * std::log1p(b.tt)) / 3.0;
    return {log_x - mean, log_r - mean, rx * std::exp(-mean)};
}

PlanarStress planar_stress(const PlanarStrain& b) {
    const double x = b.xx - b.rr;
    const double r = b.rr - b.tt;
    const double t = b.tt - b.xx;
    const double shear = 3.0 * b.xr * b.xr;
    const double square = 0.5 * (x * x + r * r + t * t) + shear;
    return {.von_mises = std::sqrt(square), .shear_part = square > 0.0 ? shear / square : 0.0};
}

PlanarShape planar_shape(const PlanarStrain& strain) {
    const PlanarStress stress = planar_stress(strain);
    const Principal p = principal(strain);
    const std::array<double, 3> q = squares_of(p.excess);
    const std::array<double, 3>& b = p.excess;
    PlanarShape shape{.stretch = {std::sqrt(q[0]), std::sqrt(q[1]), std::sqrt(q[2])},
                      .elastic = {(2.0 * b[0] - b[1] - b[2]) / 3.0, (2.0 * b[1] - b[2] - b[0]) / 3.0,
                                  (2.0 * b[2] - b[0] - b[1]) / 3.0},
                      .angle = -std::atan2(p.s, p.c),
                      .von_mises = stress.von_mises,
                      .shear_part = stress.shear_part};
    if (shape.angle > 0.5 * std::numbers::pi) shape.angle -= std::numbers::pi;
    if (shape.angle <= -0.5 * std::numbers::pi) shape.angle += std::numbers::pi;
    // A quarter turn is where the two axes change their parts; a round-off past it is still a quarter turn.
    constexpr double quarter = 0.25 * std::numbers::pi * (1.0 + 1e-12);
    if (std::abs(shape.angle) > quarter) {
        std::swap(shape.stretch[0], shape.stretch[1]);
        std::swap(shape.elastic[0], shape.elastic[1]);
        shape.angle -= std::copysign(0.5 * std::numbers::pi, shape.angle);
    }
    return shape;
}

PlanarState PlanarCell::derivative(const PlanarFlow& flow, const PlanarState& y) const {
    const Factor f = factor(y);
    const Principal p = principal(strain_of(f));
    const auto [d, d33] = inside(*this, flow, p);
    // Back to x and r.
    const double shear = p.c * p.s * (d.d11 - d.d22) + (p.c * p.c - p.s * p.s) * d.d12;
    const double xx = p.c * p.c * d.d11 + p.s * p.s * d.d22 - 2.0 * p.c * p.s * d.d12;
    const double rr = p.s * p.s * d.d11 + p.c * p.c * d.d22 + 2.0 * p.c * p.s * d.d12;
    const double xr = shear + d.spin;
    const double rx = shear - d.spin;
    // With M = C⁻¹ Λ C, C⁻¹ dC/dt is the lower triangle of M + Mᵀ, its diagonal halved.
    const double lean = f.rx / f.xx;
    const double m11 = xx + xr * lean;
    const double m22 = rr - xr * lean;
    const double m12 = xr * f.rr / f.xx;
    const double m21 = (rx * f.xx + (rr - m11) * f.rx) / f.rr;
    return {m11, m22, f.rx * m11 + f.rr * (m21 + m12)};
}

double PlanarCell::inner_shear(const PlanarFlow& flow, const PlanarStrain& strain) const {
    const Principal p = principal(strain);
    return -inside(*this, flow, p).rate.d12;
}

}  // namespace bioprint
