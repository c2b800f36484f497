#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bioprint {

/// The cubic through the four samples around `at` (Lagrange), of fourth order in their distance.
/// @param x  places, ascending, four or more
/// @param f  the values there
inline double cubic_between(const std::vector<double>& x, const std::vector<double>& f, double at) {
    const auto above = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    const std::size_t begin = std::clamp<std::size_t>(above, 2, x.size() - 2) - 2;
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + 4; ++i) {
        double weight = 1.0;
        for (std::size_t j = begin; j < begin + 4; ++j) {
            if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
        }
        sum += weight * f[i];
    }
    return sum;
}

}  // namespace bioprint
