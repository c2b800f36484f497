#include "bioprint/cell/transient.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/shape_integrals.hpp"
#include "bioprint/errors.hpp"
#include "cell/checks.hpp"
#include "cell/tensor.hpp"
#include "numerics/dormand_prince.hpp"
#include "numerics/rosenbrock.hpp"

namespace bioprint {
namespace {

using State = OdeState<6>;

State packed(const Deformation& d) {
    return {d.log_diagonal[0], d.log_diagonal[1], d.log_diagonal[2], d.lower[0], d.lower[1], d.lower[2]};
}

Deformation unpacked(const State& y) {
    return {.log_diagonal = {y[0], y[1], y[2]}, .lower = {y[3], y[4], y[5]}};
}

/// C − 1
Tensor factor_excess(const Deformation& d) {
    return {{{std::expm1(d.log_diagonal[0]), 0.0, 0.0},
             {d.lower[0], std::expm1(d.log_diagonal[1]), 0.0},
             {d.lower[1], d.lower[2], std::expm1(d.log_diagonal[2])}}};
}

/// C⁻¹ A for C = 1 + excess, by forward substitution.
Tensor solved(const Tensor& excess, Tensor a) {
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < i; ++k) a[i][j] -= excess[i][k] * a[k][j];
            a[i][j] /= 1.0 + excess[i][i];
        }
    }
    return a;
}

/// α_i² from the eigenvalues of B − 1. The smallest of very unequal ones is below the round-off of the
/// largest; the volume gives it.
std::array<double, 3> squares_of(const std::array<double, 3>& excess) {
    std::array<double, 3> q{1.0 + excess[0], 1.0 + excess[1], 1.0 + excess[2]};
    const auto least = static_cast<std::size_t>(std::min_element(q.begin(), q.end()) - q.begin());
    if (*std::max_element(q.begin(), q.end()) > 4.0)
        q[least] = 1.0 / (q[(least + 1) % 3] * q[(least + 2) % 3]);
    return q;
}

double von_mises_of(const std::array<double, 3>& excess, double modulus) {
    const double a = excess[0] - excess[1];
    const double b = excess[1] - excess[2];
    const double c = excess[2] - excess[0];
    return modulus * std::sqrt(0.5 * (a * a + b * b + c * c));
}

/// y = S:E* and the spin Π:E* in the principal axes; `rate` is e there.
struct Disturbance {
    Tensor rate{};
    Tensor spin{};
};

Disturbance disturbance(const std::array<double, 3>& excess, const Tensor& rate, double elastic_over_viscous,
                        double lambda) {
    const std::array<double, 3> q = squares_of(excess);
    const ShapeIntegrals shape = shape_integrals(q);
    const auto& g = shape.second;
    const double determinant = g[0] * g[1] + g[1] * g[2] + g[2] * g[0];
    const double triple = g[0] * g[1] * g[2];
    const double c = 1.0 - lambda;
    const double mean = (excess[0] + excess[1] + excess[2]) / 3.0;

    // E* = c y − M, and y_i g_i = ½ D E*_i + s with s = −½ g1g2g3 Σ E*_i/g_i.
    std::array<double, 3> m{};
    double top = 0.0;
    double bottom = 1.0;
    std::array<double, 3> reduced{};
    for (std::size_t i = 0; i < 3; ++i) {
        m[i] = 0.5 * elastic_over_viscous * (excess[i] - mean) - c * rate[i][i];
        reduced[i] = g[i] - 0.5 * determinant * c;
        top += 0.5 * triple * m[i] / reduced[i];
        bottom += 0.5 * triple * c / (g[i] * reduced[i]);
    }
    const double s = top / bottom;
    Disturbance y{};
    double trace = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        y.rate[i][i] = (s - 0.5 * determinant * m[i]) / reduced[i];
        trace += y.rate[i][i];
    }
    for (std::size_t i = 0; i < 3; ++i) y.rate[i][i] -= trace / 3.0;

    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const double h = 0.5 * (q[i] + q[j]) * shape.first[k];
        const double shear = c * h * rate[i][j] / (1.0 - c * h);
        y.rate[i][j] = y.rate[j][i] = shear;
        y.spin[i][j] = shear * (q[i] - q[j]) / (q[i] + q[j]);
        y.spin[j][i] = -y.spin[i][j];
    }
    return y;
}

/// Time derivative of the factor: C⁻¹ dC/dt is the lower triangle of M + Mᵀ, the diagonal halved, with M =
/// C⁻¹ Λ C.
State derivative(const AmbientFlow& flow, const TransientCell& cell, const State& y) {
    const Deformation deformation = unpacked(y);
    const Tensor inside = inner_gradient(flow, cell, deformation);
    const Tensor excess = factor_excess(deformation);
    // M = Λ + C⁻¹ (Λ Y − Y Λ) with Y = C − 1; the spin in Λ drops out of the symmetric part exactly.
    const Tensor left = product(inside, excess);
    const Tensor right = product(excess, inside);
    Tensor commutator{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) commutator[i][j] = left[i][j] - right[i][j];
    }
    const Tensor z = solved(excess, commutator);
    Tensor t{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j <= i; ++j) t[i][j] = inside[i][j] + inside[j][i] + z[i][j] + z[j][i];
        t[i][i] *= 0.5;
    }
    const double mean = (t[0][0] + t[1][1] + t[2][2]) / 3.0;
    for (std::size_t i = 0; i < 3; ++i) t[i][i] -= mean;
    const auto lower = [&](std::size_t i, std::size_t j) {
        double sum = t[i][j];
        for (std::size_t k = j; k <= i; ++k) sum += excess[i][k] * t[k][j];
        return sum;
    };
    return {t[0][0], t[1][1], t[2][2], lower(1, 0), lower(2, 0), lower(2, 1)};
}

/// What the integration will meet: the size of the deformation, and the relaxation times the way lasts.
struct Prospect {
    double load;
    double relaxations;
};

Prospect prospect(FunctionRef<AmbientFlow(double)> flow, const TransientCell& cell, const Deformation& start,
                  double from, double to) {
    double load = 1e-30;
    double viscosity = flow(from).viscosity;
    for (int i = 0; i <= 16; ++i) {
        const AmbientFlow f = flow(from + (to - from) * i / 16.0);
        const Tensor e = symmetric_part(f.gradient);
        double square = 0.0;
        for (const auto& row : e) {
            for (const double v : row) square += 2.0 * v * v;
        }
        load = std::max(load, f.viscosity * std::sqrt(square) / cell.shear_modulus);
        viscosity = std::min(viscosity, f.viscosity);
    }
    for (const double v : packed(start)) load = std::max(load, std::abs(v));
    return {.load = std::min(load, 1.0),
            .relaxations = (to - from) * cell.shear_modulus / (viscosity * (1.5 + cell.viscosity_ratio))};
}

}  // namespace

Tensor strain_of(const Deformation& deformation) {
    const Tensor y = factor_excess(deformation);
    Tensor b = product(y, transposed(y));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) b[i][j] += y[i][j] + y[j][i];
    }
    return b;
}

Deformation deformation_of(const Tensor& x) {
    // Cholesky's factor of 1 + x, by its excess over the unit tensor.
    const auto root = [](double excess) {
        return excess / (1.0 + std::sqrt(1.0 + excess));
    };  // √(1+excess) − 1
    const double y11 = root(x[0][0]);
    const double c21 = x[1][0] / (1.0 + y11);
    const double c31 = x[2][0] / (1.0 + y11);
    const double y22 = root(x[1][1] - c21 * c21);
    const double c32 = (x[2][1] - c31 * c21) / (1.0 + y22);
    const double y33 = root(x[2][2] - c31 * c31 - c32 * c32);
    std::array<double, 3> log{std::log1p(y11), std::log1p(y22), std::log1p(y33)};
    const double mean = (log[0] + log[1] + log[2]) / 3.0;
    for (double& v : log) v -= mean;
    const double scale = std::exp(-mean);
    return {.log_diagonal = log, .lower = {c21 * scale, c31 * scale, c32 * scale}};
}

Tensor inner_gradient(const AmbientFlow& flow, const TransientCell& cell, const Deformation& deformation) {
    const Eigen3 eigen = eigen_of(strain_of(deformation));
    const Tensor rate = along(eigen.axes, symmetric_part(flow.gradient));
    const Disturbance y =
        disturbance(eigen.value, rate, cell.shear_modulus / flow.viscosity, cell.viscosity_ratio);
    Tensor sum{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) sum[i][j] = y.rate[i][j] + y.spin[i][j];
    }
    sum = back(eigen.axes, sum);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) sum[i][j] += flow.gradient[i][j];
    }
    return sum;
}

TransientState transient_state(double time, const Deformation& deformation, const TransientCell& cell) {
    const Eigen3 eigen = eigen_of(strain_of(deformation));
    const auto squares = squares_of(eigen.value);
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return squares[i] > squares[j]; });
    TransientState state{.time = time,
                         .deformation = deformation,
                         .stretch = {},
                         .axes = {},
                         .von_mises = von_mises_of(eigen.value, cell.shear_modulus)};
    for (std::size_t i = 0; i < 3; ++i) {
        state.stretch[i] = std::sqrt(squares[order[i]]);
        for (std::size_t k = 0; k < 3; ++k) state.axes[k][i] = eigen.axes[k][order[i]];
    }
    return state;
}

TransientState carry_cell(FunctionRef<AmbientFlow(double)> flow, const TransientCell& cell,
                          const Deformation& start, double from, double to, const TransientOptions& options,
                          FunctionRef<void(const TransientState&)> observe) {
    require_positive(cell.shear_modulus, "shear modulus");
    require_not_negative(cell.viscosity_ratio, "viscosity ratio");
    if (!(to >= from) || !std::isfinite(to - from)) {
        throw UsageError("transient cell: the end must not come before the start");
    }
    TransientState state = transient_state(from, start, cell);
    observe(state);
    if (to == from) return state;

    const auto [load, relaxations] = prospect(flow, cell, start, from, to);
    State scale{};
    scale.fill(load);
    const auto f = [&](double t, const State& y) { return derivative(flow(t), cell, y); };
    const int samples = std::max(1, options.samples);
    const auto record = [&](const OdeStep<6>& step) {
        for (int i = 1; i <= samples; ++i) {
            const double theta = static_cast<double>(i) / samples;
            const State y = i == samples ? step.end : step.at(theta);
            state = transient_state(step.from + theta * (step.to - step.from), unpacked(y), cell);
            observe(state);
        }
        return true;
    };
    const OdeOptions ode{
        .tolerance = options.tolerance, .first_step = 1e-3 * (to - from), .max_steps = options.max_steps};
    // An explicit step cannot be much longer than the relaxation time.
    const bool stiff = relaxations > 3000.0;
    const auto done = stiff ? rosenbrock<6>(f, from, to, packed(start), scale, ode, record)
                            : dormand_prince<6>(f, from, to, packed(start), scale, ode, record);
    if (!done.finished) throw NotConverged("transient cell: the integration in time gave up");
    return state;
}

TransientState carry_cell(FunctionRef<AmbientFlow(double)> flow, const TransientCell& cell,
                          const Deformation& start, double from, double to, const TransientOptions& options) {
    return carry_cell(flow, cell, start, from, to, options, [](const TransientState&) {});
}

}  // namespace bioprint
