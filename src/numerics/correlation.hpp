#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Correlated normal numbers from independent ones.
namespace bioprint {

/// True for a matrix by rows that is a correlation: symmetric, ones on its diagonal, no combination of negative variance
/// (rounding of 1e-6 apart).
bool is_correlation(std::span<const double> matrix, std::size_t n);

/// What stays open of correlated normals of variance 1 when some of them are known: those left, in their order, are
///
///   z_i = spread_i Σ_j mixing_ij w_j        w: as many independent normals, each row of the mixing of length 1
struct ConditionalNormals {
    std::vector<double> spread;  ///< 0 to 1; 1 where what is known says nothing
    std::vector<double> mixing;  ///< lower triangle, by rows
    [[nodiscard]] double correlation(std::size_t i, std::size_t j) const;
};

/// @param matrix  a correlation, by rows
/// @param known   of each, whether it is
ConditionalNormals conditional_normals(std::span<const double> matrix, const std::vector<bool>& known);

}  // namespace bioprint
