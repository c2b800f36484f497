#include "bioprint/cell/shape_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/quadrature.hpp"

namespace bioprint {
namespace {

constexpr double smallest = 1e-60;
constexpr int most_nodes = 460;

/// Equal steps in ln λ. The error of a step is exp(-2π²/step) times some 1e4 (the integrands end in a power
/// -7/2 at Im s = π); what lies beyond the ends is of the same size: at the lower end g' falls as λ, at the
/// upper g'' as λ^(-3/2).
struct Steps {
    double step;
    double below;
    double above;
    int first;  ///< lambda[0] = exp(first * step)
    std::array<double, most_nodes> lambda;

    Steps(double step_size, double lower, double upper)
        : step(step_size),
          below(lower),
          above(upper),
          first(static_cast<int>(std::floor((std::log(smallest) - lower) / step_size))),
          lambda() {
        for (int i = 0; i < most_nodes; ++i)
            lambda[static_cast<std::size_t>(i)] = std::exp(step * (first + i));
    }
};

const Steps& exact_steps() {
    static const Steps steps(0.45, 37.0, 25.0);
    return steps;
}

const Steps& brief_steps() {
    static const Steps steps(0.75, 18.0, 12.0);
    return steps;
}

std::array<double, 3> scaled(const std::array<double, 3>& squares, double scale) {
    return {squares[0] / scale, squares[1] / scale, squares[2] / scale};
}

/// g' has the dimension length^-5, g'' length^-3.
ShapeIntegrals unscaled(ShapeIntegrals g, double scale) {
    const double third = 1.0 / (scale * std::sqrt(scale));
    for (double& v : g.first) v *= third / scale;
    for (double& v : g.second) v *= third;
    return g;
}

ShapeIntegrals summed(const Steps& steps, const std::array<double, 3>& squares) {
    const double scale = std::max({squares[0], squares[1], squares[2]});
    const double a = squares[0] / scale;
    const double b = squares[1] / scale;
    const double c = squares[2] / scale;
    const double step = steps.step;
    const double least = std::max(smallest, std::min({a, b, c}));
    const int from = static_cast<int>(std::floor((std::log(least) - steps.below) / step)) - steps.first;
    const int to = static_cast<int>(std::ceil(steps.above / step)) - steps.first;

    double f1 = 0.0, f2 = 0.0, f3 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
    const double* lambda = steps.lambda.data();
#pragma omp simd reduction(+ : f1, f2, f3, s1, s2, s3)
    for (int i = std::max(0, from); i < to; ++i) {
        const double l = lambda[i];
        const double x = a + l;
        const double y = b + l;
        const double z = c + l;
        const double product = x * y * z;
        const double weight = l / (product * std::sqrt(product));
        const double u = weight * x;
        const double v = weight * y;
        const double w = weight * z;
        f1 += u;
        f2 += v;
        f3 += w;
        s1 += u * l;
        s2 += v * l;
        s3 += w * l;
    }
    return unscaled({.first = {step * f1, step * f2, step * f3}, .second = {step * s1, step * s2, step * s3}},
                    scale);
}

}  // namespace

ShapeIntegrals shape_integrals(const std::array<double, 3>& squares) {
    return summed(exact_steps(), squares);
}

ShapeIntegrals shape_integrals_brief(const std::array<double, 3>& squares) {
    return summed(brief_steps(), squares);
}

CheckedShapeIntegrals shape_integrals_adaptive(const std::array<double, 3>& squares) {
    const double scale = std::max({squares[0], squares[1], squares[2]});
    const auto q = scaled(squares, scale);
    const double low = std::log(std::min({q[0], q[1], q[2]})) - exact_steps().below;
    CheckedShapeIntegrals result{};
    const auto integral = [&](std::size_t i, double power) {
        const Integral g = integrate(
            [&](double s) {
                const double l = std::exp(s);
                const double product = (q[0] + l) * (q[1] + l) * (q[2] + l);
                return std::exp(power * s) * (q[i] + l) / (product * std::sqrt(product));
            },
            low, exact_steps().above, 1e-13);
        result.relative_error = std::max(result.relative_error, g.error / g.value);
        return g.value;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        result.value.first[i] = integral(i, 1.0);
        result.value.second[i] = integral(i, 2.0);
    }
    result.value = unscaled(result.value, scale);
    return result;
}

}  // namespace bioprint
