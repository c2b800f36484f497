#pragma once

#include <span>
#include <vector>

#include "bioprint/function_ref.hpp"

/// Nonlinear least squares with weights, and the same robust to outliers.
///
/// A thin face over GSL's trust-region Levenberg-Marquardt (gsl_multifit_nlinear): every status is checked, steps are
/// bounded in number, and a search that can no longer improve ends where it is. A direction that the data leave free
/// shows as a variance without bound, never as an error.
namespace bioprint {

/// Residuals of a model, r_i(x).
struct LeastSquaresModel {
    std::size_t points;
    std::size_t parameters;
    /// Writes r(x), and ∂r_i/∂x_j by rows into a Jacobian; either span may be empty and is then left alone.
    /// Values that are not finite make a step one that is not taken.
    FunctionRef<void(std::span<const double> x, std::span<double> residuals, std::span<double> jacobian)>
        evaluate;
};

struct LeastSquaresFit {
    std::vector<double> x;
    std::vector<double> residuals;
    double cost;  ///< Σ w r²
    /// (Jᵀ W J)⁻¹ by rows: times the variance of a residual of weight 1 it is the covariance of x. A parameter that
    /// the residuals do not depend on has an infinite variance.
    std::vector<double> covariance;
    int iterations;
    bool converged;  ///< a minimum to rounding, not the end of the iterations
};

/// The local minimum of Σ w r² that a search from `start` falls into.
/// @param weights  one a point, > 0; empty: 1 each
/// @throws NotConverged  the residuals at the start are not finite, or GSL refuses the problem
LeastSquaresFit fit_least_squares(const LeastSquaresModel& model, std::span<const double> start,
                                  std::span<const double> weights = {});

/// The same, with far points losing their weight: Tukey's biweight at 4.685 robust standard deviations, by
/// reweighting. `cost` and `covariance` are those of the last weights.
/// @param smallest_scale  a standard deviation (of weight 1) below which residuals are not told apart
LeastSquaresFit fit_robustly(const LeastSquaresModel& model, std::span<const double> start,
                             std::span<const double> weights, double smallest_scale);

/// The standard deviation of normal residuals from the median of their magnitudes, corrected for the parameters fitted
/// to them; half of them may be anything.
double robust_scale(std::span<const double> residuals, std::size_t parameters);

/// Student's t: the value that a variable of so many degrees of freedom stays below with a probability.
double student_t(double probability, double degrees_of_freedom);

}  // namespace bioprint
