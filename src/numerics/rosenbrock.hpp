#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "numerics/dormand_prince.hpp"

/// Ordinary differential equations that are stiff: the L-stable Rosenbrock method Rodas3 of order 3 with an
/// embedded order 2 (Sandu et al., Atmos. Environ. 31, 1997), Jacobian by differences. On the stack, nothing
/// is allocated.
namespace bioprint {

/// LU decomposition with row exchanges of a small dense matrix.
template <std::size_t N>
class SmallLu {
  public:
    using Matrix = std::array<std::array<double, N>, N>;
    explicit SmallLu(const Matrix& m) : lu_(m) {
        for (std::size_t i = 0; i < N; ++i) row_[i] = i;
        for (std::size_t k = 0; k < N; ++k) {
            std::size_t best = k;
            for (std::size_t i = k + 1; i < N; ++i) {
                if (std::abs(lu_[i][k]) > std::abs(lu_[best][k])) best = i;
            }
            std::swap(lu_[k], lu_[best]);
            std::swap(row_[k], row_[best]);
            for (std::size_t i = k + 1; i < N; ++i) {
                lu_[i][k] /= lu_[k][k];
                for (std::size_t j = k + 1; j < N; ++j) lu_[i][j] -= lu_[i][k] * lu_[k][j];
            }
        }
    }

    [[nodiscard]] OdeState<N> solve(const OdeState<N>& b) const {
        OdeState<N> x{};
        for (std::size_t i = 0; i < N; ++i) {
            x[i] = b[row_[i]];
            for (std::size_t j = 0; j < i; ++j) x[i] -= lu_[i][j] * x[j];
        }
        for (std::size_t i = N; i-- > 0;) {
            for (std::size_t j = i + 1; j < N; ++j) x[i] -= lu_[i][j] * x[j];
            x[i] /= lu_[i][i];
        }
        return x;
    }

  private:
    Matrix lu_;
    std::array<std::size_t, N> row_{};
};

/// As dormand_prince, which see; the continuous extension of a step is the parabola through its ends and the
/// point before: the slopes themselves are no use, a stiff problem multiplies the error of y in them.
template <std::size_t N, typename F, typename Observe>
OdeResult<N> rosenbrock(F&& f, double from, double to, OdeState<N> y, const OdeState<N>& scale,
                        const OdeOptions& options, Observe&& observe) {
    double x = from;
    double h = std::min(options.first_step, to - from);
    double h_before = 0.0;
    OdeState<N> chord{};  // of the step before
    for (int steps = 0; steps < options.max_steps; ++steps) {
        const OdeState<N> f0 = f(x, y);
        const double dx = 1e-7 * h;
        const OdeState<N> ahead = f(x + dx, y);
        OdeState<N> in_x{};
        for (std::size_t i = 0; i < N; ++i) in_x[i] = (ahead[i] - f0[i]) / dx;
        typename SmallLu<N>::Matrix jacobian{};
        for (std::size_t j = 0; j < N; ++j) {
            OdeState<N> moved = y;
            const double dy = 1e-7 * std::max(scale[j], std::abs(y[j]));
            moved[j] += dy;
            const OdeState<N> g = f(x, moved);
            for (std::size_t i = 0; i < N; ++i) jacobian[i][j] = (g[i] - f0[i]) / dy;
        }
        bool accepted = false;
        while (!accepted) {
            typename SmallLu<N>::Matrix m{};
            for (std::size_t i = 0; i < N; ++i) {
                for (std::size_t j = 0; j < N; ++j) m[i][j] = (i == j ? 2.0 / h : 0.0) - jacobian[i][j];
            }
            const SmallLu<N> lu(m);
            const auto solve = [&](const OdeState<N>& value, double gamma, auto&& terms) {
                OdeState<N> b{};
                for (std::size_t i = 0; i < N; ++i) b[i] = value[i] + terms(i) / h + gamma * h * in_x[i];
                return lu.solve(b);
            };
            const auto shift = [&](auto&& terms) {
                OdeState<N> z = y;
                for (std::size_t i = 0; i < N; ++i) z[i] += terms(i);
                return z;
            };
            const OdeState<N> k1 = solve(f0, 0.5, [](std::size_t) { return 0.0; });
            const OdeState<N> k2 = solve(f0, 1.5, [&](std::size_t i) { return 4.0 * k1[i]; });
            const OdeState<N> f3 = f(x + h, shift([&](std::size_t i) { return 2.0 * k1[i]; }));
            const OdeState<N> k3 = solve(f3, 0.0, [&](std::size_t i) { return k1[i] - k2[i]; });
            const OdeState<N> f4 = f(x + h, shift([&](std::size_t i) { return 2.0 * k1[i] + k3[i]; }));
            const OdeState<N> k4 =
                solve(f4, 0.0, [&](std::size_t i) { return k1[i] - k2[i] - 8.0 / 3.0 * k3[i]; });
            const OdeState<N> next = shift([&](std::size_t i) { return 2.0 * k1[i] + k3[i] + k4[i]; });
            double error = 0.0;
            for (std::size_t i = 0; i < N; ++i) {
                const double allowed =
                    options.tolerance * std::max(scale[i], std::max(std::abs(y[i]), std::abs(next[i])));
                error = worse(error, std::abs(k4[i]) / allowed);
            }
            accepted = error <= 1.0;
            if (!accepted) {
                h *= std::isfinite(error) ? std::max(0.1, 0.9 * std::cbrt(1.0 / error)) : 0.1;
                if (!(h > 1e-14 * std::max(std::abs(x), to - from)))
                    return {.y = y, .x = x, .steps = steps, .finished = false};
                continue;
            }
            OdeStep<N> step{.from = x, .to = x + h, .start = y, .end = next, .extension = {}};
            for (std::size_t i = 0; i < N; ++i) {
                const double difference = next[i] - y[i];
                step.extension[0][i] = y[i];
                step.extension[1][i] = difference;
                if (h_before > 0.0) {
                    step.extension[2][i] = -h * h * (difference / h - chord[i]) / (h + h_before);
                }
                chord[i] = difference / h;
            }
            h_before = h;
            x += h;
            y = next;
            if (!observe(static_cast<const OdeStep<N>&>(step)) || x >= to)
                return {.y = y, .x = x, .steps = steps + 1, .finished = true};
            h *= std::min(5.0, 0.9 * std::cbrt(1.0 / std::max(error, 1e-3)));
            if (x + 1.0001 * h >= to) h = to - x;
        }
    }
    return {.y = y, .x = x, .steps = options.max_steps, .finished = false};
}

}  // namespace bioprint
