#include "solid/tetra_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bioprint {

namespace {

/// Gradients of six times the volume with respect to the four nodes; returns six times the volume.
double volume_gradient(const std::vector<Vector3>& x, const std::array<int, 4>& t,
                       std::array<Vector3, 4>& g) {
    std::array<Vector3, 3> e{};
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            e[k][i] = x[t[k + 1]][i] - x[t[0]][i];
        }
    }
    g[0] = {};
    for (int k = 0; k < 3; ++k) {
        const Vector3& a = e[(k + 1) % 3];
        const Vector3& b = e[(k + 2) % 3];
        g[k + 1] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        for (int i = 0; i < 3; ++i) {
            g[0][i] -= g[k + 1][i];
        }
    }
    return e[0][0] * g[1][0] + e[0][1] * g[1][1] + e[0][2] * g[1][2];
}

}  // namespace

TetraVolume::TetraVolume(const TetraMesh& mesh, bool half)
    : mesh_(mesh),
      half_(half),
      rest_(mesh.nodes.size()),
      volume_(mesh.nodes.size()),
      step_(mesh.nodes.size()) {
    std::array<Vector3, 4> g{};
    for (const auto& t : mesh_.elements) {
        const double v = volume_gradient(mesh_.nodes, t, g) / 24.0;
        for (const int node : t) {
            rest_[node] += v;
        }
    }
    double total = 0.0;
    for (const double v : rest_) {
        total += v;
    }
    // Volume gradients have the size of an area: over a length they make a step. The same length for every
    // node keeps the sum of all steps zero, so that the descent never carries the body along.
    spacing_ = std::cbrt(total / static_cast<double>(rest_.size()));
}

void TetraVolume::relax(std::vector<Vector3>& positions, double strength) {
    std::fill(volume_.begin(), volume_.end(), 0.0);
    std::fill(step_.begin(), step_.end(), Vector3{});
    std::array<Vector3, 4> g{};
    for (const auto& t : mesh_.elements) {
        const double v = volume_gradient(positions, t, g) / 24.0;
        for (const int node : t) {
            volume_[node] += v;
        }
    }
    for (const auto& t : mesh_.elements) {
        volume_gradient(positions, t, g);
        double excess = 0.0;
        for (const int node : t) {
            excess += volume_[node] / rest_[node] - 1.0;
        }
        for (int a = 0; a < 4; ++a) {
            for (int i = 0; i < 3; ++i) {
                step_[t[a]][i] += excess * g[a][i] / 24.0;
            }
        }
    }
    for (std::size_t n = 0; n < positions.size(); ++n) {
        for (int i = 0; i < (half_ && mesh_.nodes[n][2] == 0.0 ? 2 : 3); ++i) {
            positions[n][i] -= strength / spacing_ * step_[n][i];
        }
    }
}

}  // namespace bioprint
