#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// What a sample says of a quantity: its mean and spread, and how much of its variance each input makes alone.
///
/// The first-order index of an input is Var(E[y | x]) / Var(y) (Sobol 1993). As the inputs are independent and each
/// is a function of a standard normal z, E[y | x] is expanded in Hermite polynomials of z, whose coefficients are
/// averages over the sample: no evaluation beyond the sample's own is needed. The sum of the indices is at most 1;
/// what it lacks is made by inputs together. Accuracy with 1024 points: 0.01.      tests/unit/numerics/sampling.cpp
///
/// Of inputs that depend on each other the index is the same share, which goes when the input is known; it holds what
/// the others then are known by, so that their indices overlap. The points do not fill those normals' cube as evenly:
/// the expansion ends at the second order there. Accuracy: 0.02.
namespace bioprint {

struct SampleStatistics {
    double mean;
    double standard_deviation;        ///< of the distribution, not of the mean
    std::array<double, 3> quantiles;  ///< 5, 50 and 95 %
    std::vector<double> first_order;  ///< of each input, 0 to 1; zeros where nothing varies
};

/// @param values   at least one, finite
/// @param normals  the inputs' standard normals, point by point: `inputs` for each value
/// @param mixed    of each input, whether it depends on others; empty: none does
SampleStatistics sample_statistics(std::span<const double> values, std::span<const double> normals,
                                   std::size_t inputs, const std::vector<bool>& mixed = {});

}  // namespace bioprint
