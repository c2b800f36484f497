#include "numerics/correlation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bioprint {
namespace {

constexpr double rounding = 1e-6;  // of entries written with six digits
/// A variance of this, of 1, is what rounding leaves of one that others determine.
constexpr double nothing = 1e-14;

struct Factor {
    std::vector<double> lower;  ///< Cholesky's, by rows
    double least_pivot;
};

/// A pivot that is no variance becomes a column of zeros.
Factor cholesky(std::span<const double> matrix, std::span<const std::size_t> order) {
    const std::size_t n = order.size();
    const auto columns = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
    Factor factor{.lower = std::vector<double>(n * n, 0.0), .least_pivot = 1.0};
    std::vector<double>& l = factor.lower;
    for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t i = j; i < n; ++i) {
            double rest = matrix[order[i] * columns + order[j]];
            for (std::size_t k = 0; k < j; ++k) rest -= l[i * n + k] * l[j * n + k];
            if (i == j) {
                factor.least_pivot = std::min(factor.least_pivot, rest);
                if (rest <= nothing) break;
                l[j * n + j] = std::sqrt(rest);
            } else {
                l[i * n + j] = rest / l[j * n + j];
            }
        }
    }
    return factor;
}

}  // namespace

bool is_correlation(std::span<const double> matrix, std::size_t n) {
    if (matrix.size() != n * n) return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (std::abs(matrix[i * n + i] - 1.0) > rounding) return false;
        for (std::size_t j = 0; j < n; ++j) {
            if (!(std::abs(matrix[i * n + j]) <= 1.0 + rounding) ||
                std::abs(matrix[i * n + j] - matrix[j * n + i]) > rounding) {
                return false;
            }
        }
    }
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    return cholesky(matrix, order).least_pivot >= -rounding;
}

double ConditionalNormals::correlation(std::size_t i, std::size_t j) const {
    const std::size_t n = spread.size();
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) sum += mixing[i * n + k] * mixing[j * n + k];
    return std::clamp(sum, -1.0, 1.0);
}

ConditionalNormals conditional_normals(std::span<const double> matrix, const std::vector<bool>& known) {
    // The known ones first: what is left of the factor behind them is that of the others, given these.
    std::vector<std::size_t> order;
    for (const bool first : {true, false}) {
        for (std::size_t i = 0; i < known.size(); ++i) {
            if (known[i] == first) order.push_back(i);
        }
    }
    const std::size_t all = order.size();
    const auto held = static_cast<std::size_t>(std::count(known.begin(), known.end(), true));
    const std::size_t n = all - held;
    const Factor factor = cholesky(matrix, order);
    ConditionalNormals result{.spread = std::vector<double>(n, 0.0),
                              .mixing = std::vector<double>(n * n, 0.0)};
    for (std::size_t i = 0; i < n; ++i) {
        double square = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
            const double entry = factor.lower[(held + i) * all + held + j];
            square += entry * entry;
        }
        result.spread[i] = std::sqrt(square);
        for (std::size_t j = 0; j < n; ++j) {
            result.mixing[i * n + j] = square > 0.0
                                           ? factor.lower[(held + i) * all + held + j] / result.spread[i]
                                           : (i == j ? 1.0 : 0.0);
        }
    }
    return result;
}

}  // namespace bioprint
