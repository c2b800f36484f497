// Writes shear_curve_table.hpp: the universal curve of stationary shapes in shear as three Chebyshev series.
//
//   make_shear_curve > src/cell/shear_curve_table.hpp
//
// Computed in long double, so that the printed coefficients are exact to double. What the series hold, and in
// which variable, is said in shear_curve.hpp. Program, not library: built beside it, never installed.
#include <array>
#include <cmath>
#include <cstdio>

namespace {

using Real = long double;
constexpr int terms = 40;
constexpr Real bend = 6;

struct Integrals {
    std::array<Real, 3> first{};   // g_i'
    std::array<Real, 3> second{};  // g_i''
    std::array<Real, 3> single{};  // ∫ dλ / ((α_i²+λ) Δ)
};

// Trapezoidal rule in ln λ, as shape_integrals.cpp, with step and range for 20 digits.
Integrals integrals(const std::array<Real, 3>& q) {
    constexpr Real step = 0.35L;
    const Real low = std::log(std::fmin(q[0], std::fmin(q[1], q[2]))) - 48;
    Integrals g;
    const int last = static_cast<int>(32 / step);
    for (int i = static_cast<int>(std::floor(low / step)); i <= last; ++i) {
        const Real l = std::exp(i * step);
        const std::array<Real, 3> x{q[0] + l, q[1] + l, q[2] + l};
        const Real product = x[0] * x[1] * x[2];
        const Real weight = step * l / std::sqrt(product);
        for (std::size_t i = 0; i < 3; ++i) {
            g.single[i] += weight / x[i];
            g.first[i] += weight * x[i] / product;
            g.second[i] += weight * x[i] / product * l;
        }
    }
    return g;
}

struct Point {
    Real lean;     // (ln(α1/α3)/δ − 1/2)/δ
    Real slip;     // (1 − h)/s
    Real bearing;  // w
};

// The stationary shape of δ = 1 − α2/α1, with α1 = 1: a secant iteration on ℓ = ln(α1/α3)/δ.
Point stationary_shape(Real delta) {
    const Real s = 1 - delta;
    const Real z = -std::log1p(-delta);
    Integrals g;
    const auto residual = [&](Real ell) {
        g = integrals({1, s * s, std::exp(-2 * delta * ell)});
        const Real top = -std::expm1(-2 * delta * ell);                 // α1² − α3²
        const Real bottom = s * s * std::expm1(2 * (z - delta * ell));  // α3² − α2²
        return std::log(top / bottom) - std::log(g.second[0] / g.second[1]);
    };
    Real before = delta > 0.9L ? 1.3L : 0.5L;
    Real ell = delta > 0.9L ? 1.4L : 0.5L + 0.22L * delta;
    Real f_before = residual(before);
    Real f = residual(ell);
    for (int i = 0; i < 60 && std::abs(ell - before) > 1e-19L && f != f_before; ++i) {
        const Real next = ell - f * (ell - before) / (f - f_before);
        before = ell;
        f_before = f;
        ell = next;
        f = residual(ell);
    }
    const Real q = std::exp(-delta * ell);
    const auto& b = g.second;
    // Two forms of (1 − h)/s: the second, by g3' = (I2 − I1)/(α1²−α2²) and I1 + I2 + I3 = 2/(α1α2α3), keeps
    // its digits where h tends to 1.
    const Real slip = s > 0.5L ? (1 - 0.5L * (1 + s * s) * s * q * g.first[2]) / s
                               : ((1 + s * s) * q * (g.single[0] + 0.5L * g.single[2]) - 2 * s) / (1 - s * s);
    return {.lean = (ell - 0.5L) / delta,
            .slip = slip,
            .bearing = (b[0] * b[1] + b[1] * b[2] + b[2] * b[0]) / (b[0] + b[1])};
}

using Series = std::array<Real, terms>;

Series chebyshev(const std::array<Real, terms>& values, Real pi) {
    Series series{};
    for (int n = 0; n < terms; ++n) {
        Real sum = 0;
        for (int k = 0; k < terms; ++k)
            sum += values[static_cast<std::size_t>(k)] * std::cos(pi * n * (k + 0.5L) / terms);
        series[static_cast<std::size_t>(n)] = sum * (n == 0 ? 1 : 2) / terms;
    }
    return series;
}

void print(const char* name, const Series& series) {
    std::printf("inline constexpr std::array<double, shear_curve_terms> %s{\n", name);
    for (const Real c : series) std::printf("    %.17Lg,\n", c);
    std::printf("};\n");
}

}  // namespace

int main() {
    const Real pi = std::acos(-1.0L);
    Series lean{};
    Series slip{};
    Series bearing{};
    for (std::size_t k = 0; k < terms; ++k) {
        const Real v = (1 + std::cos(pi * (static_cast<Real>(k) + 0.5L) / terms)) / 2;
        const Point p = stationary_shape(v * (1 + bend) / (1 + bend * v));
        lean[k] = p.lean;
        slip[k] = p.slip;
        bearing[k] = p.bearing;
    }
    std::printf(
        "#pragma once\n\n#include <array>\n#include <cstddef>\n\n"
        "// Written by make_shear_curve; see shear_curve.hpp.\n// clang-format off\nnamespace bioprint {\n\n"
        "inline constexpr std::size_t shear_curve_terms = %d;\ninline constexpr double shear_curve_bend = "
        "%.0Lf;\n",
        terms, bend);
    print("shear_curve_lean", chebyshev(lean, pi));
    print("shear_curve_slip", chebyshev(slip, pi));
    print("shear_curve_bearing", chebyshev(bearing, pi));
    std::printf("\n}  // namespace bioprint\n// clang-format on\n");
    return 0;
}
