#include "numerics/least_squares.hpp"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "bioprint/errors.hpp"
#include "numerics/gsl_errors.hpp"

namespace bioprint {
namespace {

constexpr int most_iterations = 300;
/// Between two reweightings, which move the goal anyway.
constexpr int most_iterations_between = 20;
constexpr int most_reweightings = 20;
/// Relative decrease of the cost below which an iteration has done nothing.
constexpr double no_progress = 1e-14;
constexpr double step_tolerance = 1e-10;
constexpr double gradient_tolerance = 1e-12;

std::span<const double> view(const gsl_vector* v) {
    return {v->data, v->size};  // GSL's own vectors have no stride
}

/// Counts as a step that leads nowhere: far above any residual, far below what its square can overflow.
constexpr double refused = 1e120;

int call_residuals(const gsl_vector* x, void* model, gsl_vector* f) {
    const std::span<double> residuals(f->data, f->size);
    static_cast<const LeastSquaresModel*>(model)->evaluate(view(x), residuals, {});
    for (double& r : residuals) {
        if (!std::isfinite(r)) r = refused;
    }
    return GSL_SUCCESS;
}

int call_jacobian(const gsl_vector* x, void* model, gsl_matrix* j) {
    const std::span<double> jacobian(j->data, j->size1 * j->size2);
    static_cast<const LeastSquaresModel*>(model)->evaluate(view(x), {}, jacobian);
    for (double& d : jacobian) {
        if (!std::isfinite(d)) d = 0.0;
    }
    return GSL_SUCCESS;
}

struct FreeWorkspace {
    void operator()(gsl_multifit_nlinear_workspace* w) const { gsl_multifit_nlinear_free(w); }
};
using Workspace = std::unique_ptr<gsl_multifit_nlinear_workspace, FreeWorkspace>;

struct FreeMatrix {
    void operator()(gsl_matrix* m) const { gsl_matrix_free(m); }
};

double cost_of(const gsl_multifit_nlinear_workspace* workspace) {
    double cost = 0.0;
    gsl_blas_ddot(workspace->f, workspace->f, &cost);
    return cost;
}

/// Iterates until nothing changes; whether that was a minimum.
bool iterate(gsl_multifit_nlinear_workspace* workspace, int most, int& iterations) {
    double cost = cost_of(workspace);
    int idle = 0;
    for (iterations = 0; iterations < most; ++iterations) {
        const int status = gsl_multifit_nlinear_iterate(workspace);
        // No step from here lowers the cost any more.
        if (status == GSL_ENOPROG) return true;
        if (status != GSL_SUCCESS) return false;
        int reason = 0;
        if (gsl_multifit_nlinear_test(step_tolerance, gradient_tolerance, 0.0, &reason, workspace) ==
            GSL_SUCCESS) {
            return true;
        }
        const double next = cost_of(workspace);
        idle = cost - next <= no_progress * cost ? idle + 1 : 0;
        if (idle >= 3) return true;
        cost = next;
    }
    return false;
}

std::vector<double> covariance_of(gsl_multifit_nlinear_workspace* workspace, std::size_t parameters) {
    const std::unique_ptr<gsl_matrix, FreeMatrix> matrix(gsl_matrix_calloc(parameters, parameters));
    const int status = gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(workspace), 0.0, matrix.get());
    std::vector<double> covariance(matrix->data, matrix->data + parameters * parameters);
    for (std::size_t i = 0; i < parameters; ++i) {
        double& variance = covariance[i * parameters + i];
        if (status != GSL_SUCCESS || !(variance > 0.0)) variance = std::numeric_limits<double>::infinity();
    }
    return covariance;
}

/// Tukey's biweight: 1 at the middle, 0 past `reach`. Never quite 0, so that no fit loses its points.
double biweight(double residual, double reach) {
    const double u = residual / reach;
    const double rest = std::max(0.0, 1.0 - u * u);
    return std::max(rest * rest, 1e-6);
}

LeastSquaresFit search(const LeastSquaresModel& model, std::span<const double> start,
                       std::span<const double> weights, int most) {
    use_gsl_status_codes();
    gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
    options.solver = gsl_multifit_nlinear_solver_qr;
    const Workspace workspace(
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, model.points, model.parameters));
    if (!workspace) throw NotConverged("least squares: fewer points than parameters");

    gsl_multifit_nlinear_fdf problem{};
    problem.f = call_residuals;
    problem.df = call_jacobian;
    problem.n = model.points;
    problem.p = model.parameters;
    problem.params = const_cast<LeastSquaresModel*>(&model);
    const gsl_vector_const_view x0 = gsl_vector_const_view_array(start.data(), start.size());
    if (weights.empty()) {
        check_gsl(gsl_multifit_nlinear_init(&x0.vector, &problem, workspace.get()), "least squares");
    } else {
        const gsl_vector_const_view w = gsl_vector_const_view_array(weights.data(), weights.size());
        check_gsl(gsl_multifit_nlinear_winit(&x0.vector, &w.vector, &problem, workspace.get()),
                  "least squares");
    }
    if (!(cost_of(workspace.get()) < refused)) {
        throw NotConverged("least squares: the residuals at the start are not finite");
    }

    LeastSquaresFit fit{};
    fit.converged = iterate(workspace.get(), most, fit.iterations);
    const std::span<const double> x = view(gsl_multifit_nlinear_position(workspace.get()));
    fit.x.assign(x.begin(), x.end());
    fit.residuals.resize(model.points);
    model.evaluate(fit.x, fit.residuals, {});
    fit.cost = cost_of(workspace.get());
    fit.covariance = covariance_of(workspace.get(), model.parameters);
    return fit;
}

}  // namespace

LeastSquaresFit fit_least_squares(const LeastSquaresModel& model, std::span<const double> start,
                                  std::span<const double> weights) {
    return search(model, start, weights, most_iterations);
}

LeastSquaresFit fit_robustly(const LeastSquaresModel& model, std::span<const double> start,
                             std::span<const double> weights, double smallest_scale) {
    // Reweighting begins at the start's own residuals: a plain fit first would follow the outliers.
    std::vector<double> residuals(model.points);
    model.evaluate(start, residuals, {});
    const auto standardise = [&](std::vector<double>& r) {
        for (std::size_t k = 0; k < weights.size(); ++k) r[k] *= std::sqrt(weights[k]);
    };
    standardise(residuals);
    std::vector<double> x(start.begin(), start.end());
    LeastSquaresFit fit{};
    double scale = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_reweightings; ++i) {
        const double previous = scale;
        scale = std::max(robust_scale(residuals, model.parameters), smallest_scale);
        std::vector<double> w(model.points);
        for (std::size_t k = 0; k < w.size(); ++k) {
            w[k] = (weights.empty() ? 1.0 : weights[k]) * biweight(residuals[k], 4.685 * scale);
        }
        fit = search(model, x, w, most_iterations_between);
        x = fit.x;
        residuals = fit.residuals;
        standardise(residuals);
        if (i > 0 && std::abs(scale - previous) <= 1e-4 * scale) break;
    }
    return fit;
}

double robust_scale(std::span<const double> residuals, std::size_t parameters) {
    if (residuals.size() <= parameters) return 0.0;
    std::vector<double> magnitudes(residuals.size());
    std::transform(residuals.begin(), residuals.end(), magnitudes.begin(),
                   [](double r) { return std::abs(r); });
    // The fit makes as many residuals vanish as it has parameters: the median of the others.
    const std::size_t middle = (residuals.size() + parameters) / 2;
    const auto at = magnitudes.begin() + static_cast<std::ptrdiff_t>(std::min(middle, magnitudes.size() - 1));
    std::nth_element(magnitudes.begin(), at, magnitudes.end());
    constexpr double median_of_normal = 0.674489750196082;
    return *at / median_of_normal;
}

double student_t(double probability, double degrees_of_freedom) {
    use_gsl_status_codes();
    return gsl_cdf_tdist_Pinv(probability, degrees_of_freedom);
}

}  // namespace bioprint
