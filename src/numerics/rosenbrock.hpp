#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "numerics/dormand_prince.hpp"

/// Ordinary differential equations that are stiff: the L-stable Rosenbrock method RODAS of order 4 with an
/// embedded order 3 and a continuous extension of order 3 (E. Hairer, G. Wanner, Solving Ordinary Differential
/// Equations II, 1996, section VI.4). On the stack, nothing is allocated.
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

/// Its coefficients, for stages that solve (1/(γh) − J) k_i = f(x + a_i h, y + Σ A_ij k_j) + Σ C_ij/h k_j + g_i h ∂f/∂x.
/// The last two stages take up the stages before them as they are.
namespace rodas {
constexpr double gamma = 0.25;
constexpr std::array<double, 6> place{0.0, 0.386, 0.21, 0.63, 1.0, 1.0};
constexpr std::array<double, 6> slope{0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0};
constexpr std::array<std::array<double, 5>, 6> shift{
    {{},
     {1.544},
     {0.9466785280815826, 0.2557011698983284},
     {3.314825187068521, 2.896124015972201, 0.9986419139977817},
     {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
     {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1.0}}};
constexpr std::array<std::array<double, 5>, 6> coupling{
    {{},
     {-5.6688},
     {-2.430093356833875, -0.2063599157091915},
     {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
     {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
     {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}}};
constexpr std::array<std::array<double, 5>, 2> extension{
    {{10.12623508344586, -7.487995877610167, -34.80091861555747, -7.992771707568823, 1.025137723295662},
     {-0.6762803392801253, 6.087714651680015, 16.43084320892478, 24.76722511418386, -6.594389125716872}}};
}  // namespace rodas

/// A right side f(x, y) about one point.
template <std::size_t N>
struct Linearised {
    OdeState<N> value;
    typename SmallLu<N>::Matrix jacobian;  ///< ∂f_i/∂y_j
    OdeState<N> in_x;                      ///< ∂f/∂x
};

/// By differences.
/// @param length  of x, over which f changes
template <std::size_t N, typename F>
Linearised<N> linearised(F&& f, double x, const OdeState<N>& y, double length, const OdeState<N>& scale) {
    constexpr double small = 1e-7;
    Linearised<N> l{.value = f(x, y), .jacobian = {}, .in_x = {}};
    for (std::size_t j = 0; j < N; ++j) {
        OdeState<N> moved = y;
        const double dy = small * std::max(scale[j], std::abs(y[j]));
        moved[j] += dy;
        const OdeState<N> g = f(x, moved);
        for (std::size_t i = 0; i < N; ++i) l.jacobian[i][j] = (g[i] - l.value[i]) / dy;
    }
    const double dx = small * length;
    const OdeState<N> ahead = f(x + dx, y);
    for (std::size_t i = 0; i < N; ++i) l.in_x[i] = (ahead[i] - l.value[i]) / dx;
    return l;
}

/// As dormand_prince, which see.
/// @param linearise  linearise(x, y, length of the step) → Linearised<N>
template <std::size_t N, typename F, typename L, typename Observe>
OdeResult<N> rosenbrock(F&& f, L&& linearise, double from, double to, OdeState<N> y, const OdeState<N>& scale,
                        const OdeOptions& options, Observe&& observe) {
    double x = from;
    double h = std::min(options.first_step, to - from);
    for (int steps = 0; steps < options.max_steps; ++steps) {
        const auto [here, jacobian, in_x] = linearise(x, static_cast<const OdeState<N>&>(y), h);
        while (true) {
            typename SmallLu<N>::Matrix m{};
            for (std::size_t i = 0; i < N; ++i) {
                for (std::size_t j = 0; j < N; ++j)
                    m[i][j] = (i == j ? 1.0 / (rodas::gamma * h) : 0.0) - jacobian[i][j];
            }
            const SmallLu<N> lu(m);
            std::array<OdeState<N>, 6> k{};
            OdeState<N> next = y;
            for (std::size_t stage = 0; stage < k.size(); ++stage) {
                next = y;
                OdeState<N> right{};
                for (std::size_t i = 0; i < N; ++i) {
                    for (std::size_t j = 0; j < stage; ++j) {
                        next[i] += rodas::shift[stage][j] * k[j][i];
                        right[i] += rodas::coupling[stage][j] / h * k[j][i];
                    }
                    right[i] += rodas::slope[stage] * h * in_x[i];
                }
                const OdeState<N> there = stage == 0 ? here : f(x + rodas::place[stage] * h, next);
                for (std::size_t i = 0; i < N; ++i) right[i] += there[i];
                k[stage] = lu.solve(right);
            }
            double error = 0.0;
            for (std::size_t i = 0; i < N; ++i) {
                next[i] += k[5][i];
                const double allowed =
                    options.tolerance * std::max(scale[i], std::max(std::abs(y[i]), std::abs(next[i])));
                error = worse(error, std::abs(k[5][i]) / allowed);
            }
            if (!(error <= 1.0)) {  // also where the step led out of the numbers
                h *= std::isfinite(error) ? std::max(0.1, 0.9 * std::pow(error, -0.25)) : 0.1;
                if (!(h > 1e-14 * std::max(std::abs(x), to - from)))
                    return {.y = y, .x = x, .steps = steps, .finished = false};
                continue;
            }
            OdeStep<N> step{.from = x, .to = x + h, .start = y, .end = next, .extension = {}};
            for (std::size_t i = 0; i < N; ++i) {
                step.extension[0][i] = y[i];
                step.extension[1][i] = next[i] - y[i];
                for (std::size_t j = 0; j < 5; ++j) {
                    step.extension[2][i] += rodas::extension[0][j] * k[j][i];
                    step.extension[3][i] += rodas::extension[1][j] * k[j][i];
                }
            }
            x += h;
            y = next;
            if (!observe(static_cast<const OdeStep<N>&>(step)) || x >= to)
                return {.y = y, .x = x, .steps = steps + 1, .finished = true};
            h *= std::min(5.0, 0.9 * std::pow(std::max(error, 1e-4), -0.25));
            if (x + 1.0001 * h >= to) h = to - x;
            break;
        }
    }
    return {.y = y, .x = x, .steps = options.max_steps, .finished = false};
}

/// The same, linearised by differences.
template <std::size_t N, typename F, typename Observe>
OdeResult<N> rosenbrock(F&& f, double from, double to, const OdeState<N>& y, const OdeState<N>& scale,
                        const OdeOptions& options, Observe&& observe) {
    const auto by_differences = [&](double x, const OdeState<N>& at, double length) {
        return linearised<N>(f, x, at, length, scale);
    };
    return rosenbrock<N>(f, by_differences, from, to, y, scale, options, observe);
}

}  // namespace bioprint
