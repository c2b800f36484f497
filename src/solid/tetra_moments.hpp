#pragma once

#include <array>
#include <vector>

namespace bioprint {

/// Volume, first and second moments of a body, summed over its elements.
struct Moments {
    double volume = 0.0;
    std::array<double, 3> first{};
    std::array<std::array<double, 3>, 3> second{};

    void add(const std::vector<std::array<double, 3>>& positions, const std::array<int, 4>& element,
             double v) {
        std::array<double, 3> sum{};
        for (const int node : element) {
            for (int i = 0; i < 3; ++i) {
                sum[i] += positions[node][i];
            }
        }
        volume += v;
        for (int i = 0; i < 3; ++i) {
            first[i] += 0.25 * v * sum[i];
            for (int k = 0; k < 3; ++k) {
                double corners = sum[i] * sum[k];
                for (const int node : element) {
                    corners += positions[node][i] * positions[node][k];
                }
                second[i][k] += v / 20.0 * corners;
            }
        }
    }

    /// The other half, behind the mirror z = 0.
    void complete() {
        volume *= 2.0;
        first = {2.0 * first[0], 2.0 * first[1], 0.0};
        for (auto& row : second) {
            for (double& value : row) {
                value *= 2.0;
            }
        }
        second[0][2] = second[2][0] = second[1][2] = second[2][1] = 0.0;
    }
};

}  // namespace bioprint
