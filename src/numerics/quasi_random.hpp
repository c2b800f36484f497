#pragma once

#include <cstddef>
#include <vector>

/// Points that fill a cube evenly, and the normal distribution. Each coordinate of 2^m points takes every one of
/// the values (i + 1/2)/2^m once, so that a sum of functions of one coordinate each is averaged as by the midpoint
/// rule. Always the same points: there is no seed.
namespace bioprint {

/// The first `count` points of Sobol's sequence, in the middle of their cells; point by point.
/// @param dimensions  1 to 40
/// @throws UsageError  more dimensions
std::vector<double> sobol_points(std::size_t dimensions, std::size_t count);

/// The standard normal distribution function, and its inverse for 0 < p < 1.
double normal_probability(double z);
double normal_quantile(double p);

}  // namespace bioprint
