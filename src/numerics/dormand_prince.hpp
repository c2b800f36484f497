#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "bioprint/errors.hpp"

/// Ordinary differential equations that are not stiff: the pair of Dormand and Prince (1980), order 5 with an
/// embedded order 4, steps chosen so that the error of each stays below the tolerance. On the stack, nothing
/// is allocated.
namespace bioprint {

template <std::size_t N>
using OdeState = std::array<double, N>;

struct OdeOptions {
    double tolerance = 1e-7;   ///< of each component, per step, relative to max(1, |y|) times its scale
    double first_step = 1e-3;  ///< > 0, in the independent variable
    int max_steps = 100000;
};

/// One accepted step, with its continuous extension of order 4.
template <std::size_t N>
struct OdeStep {
    double from;
    double to;
    OdeState<N> start;
    OdeState<N> end;
    std::array<OdeState<N>, 5> extension;

    /// The solution at from + θ (to − from), 0 ≤ θ ≤ 1.
    [[nodiscard]] OdeState<N> at(double theta) const {
        OdeState<N> y{};
        for (std::size_t i = 0; i < N; ++i) {
            const auto& r = extension;
            const double rest = 1.0 - theta;
            y[i] = r[0][i] + theta * (r[1][i] + rest * (r[2][i] + theta * (r[3][i] + rest * r[4][i])));
        }
        return y;
    }
};

/// Integrates dy/dx = f(x, y) from `from` to `to` > from and returns y there.
/// @param f        f(x, y) → OdeState<N>
/// @param scale    the size of each component that counts as one
/// @param observe  observe(step) → bool, called after each accepted step; false ends the integration there
/// @return         y at the end, and whether max_steps was enough
template <std::size_t N>
struct OdeResult {
    OdeState<N> y;
    double x;
    int steps;
    bool finished;
};

/// The larger of two errors; one that is no number stays.
inline double worse(double a, double b) {
    return a >= b || std::isnan(a) ? a : b;
}

template <std::size_t N, typename F, typename Observe>
OdeResult<N> dormand_prince(F&& f, double from, double to, OdeState<N> y, const OdeState<N>& scale,
                            const OdeOptions& options, Observe&& observe) {
    double x = from;
    double h = std::min(options.first_step, to - from);
    OdeState<N> k1 = f(x, y);
    const auto blend = [&y](double step, auto... terms) {
        OdeState<N> z = y;
        for (std::size_t i = 0; i < N; ++i) z[i] += step * (... + (terms.first * (*terms.second)[i]));
        return z;
    };
    const auto part = [](double c, const OdeState<N>& k) {
        return std::pair<double, const OdeState<N>*>(c, &k);
    };
    bool rejected = false;
    for (int steps = 0; steps < options.max_steps; ++steps) {
        const OdeState<N> k2 = f(x + h / 5, blend(h, part(1.0 / 5, k1)));
        const OdeState<N> k3 = f(x + 3 * h / 10, blend(h, part(3.0 / 40, k1), part(9.0 / 40, k2)));
        const OdeState<N> k4 =
            f(x + 4 * h / 5, blend(h, part(44.0 / 45, k1), part(-56.0 / 15, k2), part(32.0 / 9, k3)));
        const OdeState<N> k5 = f(x + 8 * h / 9, blend(h, part(19372.0 / 6561, k1), part(-25360.0 / 2187, k2),
                                                      part(64448.0 / 6561, k3), part(-212.0 / 729, k4)));
        const OdeState<N> k6 =
            f(x + h, blend(h, part(9017.0 / 3168, k1), part(-355.0 / 33, k2), part(46732.0 / 5247, k3),
                           part(49.0 / 176, k4), part(-5103.0 / 18656, k5)));
        const OdeState<N> next = blend(h, part(35.0 / 384, k1), part(500.0 / 1113, k3), part(125.0 / 192, k4),
                                       part(-2187.0 / 6784, k5), part(11.0 / 84, k6));
        const OdeState<N> k7 = f(x + h, next);
        double error = 0.0;
        for (std::size_t i = 0; i < N; ++i) {
            const double e = h * (71.0 / 57600 * k1[i] - 71.0 / 16695 * k3[i] + 71.0 / 1920 * k4[i] -
                                  17253.0 / 339200 * k5[i] + 22.0 / 525 * k6[i] - 1.0 / 40 * k7[i]);
            const double allowed =
                options.tolerance * std::max(scale[i], std::max(std::abs(y[i]), std::abs(next[i])));
            error = worse(error, std::abs(e) / allowed);
        }
        if (!(error <= 1.0)) {  // also where the step led out of the numbers
            h *= std::isfinite(error) ? std::max(0.2, 0.9 * std::pow(error, -0.2)) : 0.2;
            rejected = true;
            if (!(h > 1e-14 * std::max(std::abs(x), to - from)))
                return {.y = y, .x = x, .steps = steps, .finished = false};
            continue;
        }
        OdeStep<N> step{.from = x, .to = x + h, .start = y, .end = next, .extension = {}};
        for (std::size_t i = 0; i < N; ++i) {
            const double difference = next[i] - y[i];
            const double bend = h * k1[i] - difference;
            step.extension[0][i] = y[i];
            step.extension[1][i] = difference;
            step.extension[2][i] = bend;
            step.extension[3][i] = difference - h * k7[i] - bend;
            step.extension[4][i] =
                h * (-12715105075.0 / 11282082432 * k1[i] + 87487479700.0 / 32700410799 * k3[i] -
                     10690763975.0 / 1880347072 * k4[i] + 701980252875.0 / 199316789632 * k5[i] -
                     1453857185.0 / 822651844 * k6[i] + 69997945.0 / 29380423 * k7[i]);
        }
        x += h;
        y = next;
        k1 = k7;
        if (!observe(static_cast<const OdeStep<N>&>(step)) || x >= to)
            return {.y = y, .x = x, .steps = steps + 1, .finished = true};
        // Straight after a refusal a longer step would be refused as well.
        h *= std::min(rejected ? 1.0 : 5.0, 0.85 * std::pow(std::max(error, 1e-4), -0.2));
        rejected = false;
        if (x + 1.0001 * h >= to) h = to - x;
    }
    return {.y = y, .x = x, .steps = options.max_steps, .finished = false};
}

}  // namespace bioprint
