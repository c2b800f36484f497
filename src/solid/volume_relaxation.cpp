#include "solid/volume_relaxation.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace bioprint::solid {
namespace {

/// The volume of a ring of triangular section and its derivative by each vertex: V = 2π r̄ A.
struct RingVolume {
    double value;
    std::array<RingPoint, 3> gradient;
};

RingVolume ring_volume(const std::array<int, 3>& v, std::span<const RingPoint> position) {
    constexpr double two_pi = 2.0 * std::numbers::pi;
    std::array<RingPoint, 3> p{};
    for (std::size_t n = 0; n < 3; ++n) {
        p[n] = position[static_cast<std::size_t>(v[n])];
    }
    const double area = 0.5 * ((p[1].x - p[0].x) * (p[2].r - p[0].r) - (p[2].x - p[0].x) * (p[1].r - p[0].r));
    const double r = (p[0].r + p[1].r + p[2].r) / 3.0;
    RingVolume volume{.value = two_pi * r * area, .gradient = {}};
    for (std::size_t n = 0; n < 3; ++n) {
        const RingPoint& b = p[(n + 1) % 3];
        const RingPoint& c = p[(n + 2) % 3];
        volume.gradient[n] = {.x = two_pi * r * 0.5 * (b.r - c.r),
                              .r = two_pi * (r * 0.5 * (c.x - b.x) + area / 3.0)};
    }
    return volume;
}

/// Of an element's own volume beside the mean of its vertices'. Any weight from 0.1 to 2 gives the same
/// stress within 1 %; with none, single elements swell and shrink by 10 % and the stress is 3 % too high.
constexpr double element_weight = 0.5;

}  // namespace

VolumeRelaxation::VolumeRelaxation(const RingMesh& mesh)
    : mesh_(mesh),
      volume_(mesh.vertices.size(), 0.0),
      strain_(mesh.vertices.size(), 0.0),
      shift_(mesh.vertices.size()) {
    for (const auto& triangle : mesh_.triangles) {
        const RingVolume ring = ring_volume(triangle, mesh_.vertices);
        own_.push_back(ring.value);
        for (const int v : triangle) {
            volume_[static_cast<std::size_t>(v)] += ring.value / 3.0;
        }
    }
}

void VolumeRelaxation::apply(std::span<RingPoint> position, double strength) {
    std::fill(strain_.begin(), strain_.end(), 0.0);
    std::fill(shift_.begin(), shift_.end(), RingPoint{.x = 0.0, .r = 0.0});
    std::vector<RingVolume> rings;
    rings.reserve(mesh_.triangles.size());
    for (const auto& triangle : mesh_.triangles) {
        rings.push_back(ring_volume(triangle, position));
        for (const int v : triangle) {
            strain_[static_cast<std::size_t>(v)] += rings.back().value / 3.0;
        }
    }
    for (std::size_t v = 0; v < strain_.size(); ++v) {
        strain_[v] = strain_[v] / volume_[v] - 1.0;
    }
    for (std::size_t e = 0; e < rings.size(); ++e) {
        double mean = 0.0;
        for (const int v : mesh_.triangles[e]) {
            mean += strain_[static_cast<std::size_t>(v)] / 3.0;
        }
        mean += element_weight * (rings[e].value / own_[e] - 1.0);
        for (std::size_t n = 0; n < 3; ++n) {
            RingPoint& shift = shift_[static_cast<std::size_t>(mesh_.triangles[e][n])];
            shift.x -= mean * rings[e].gradient[n].x;
            shift.r -= mean * rings[e].gradient[n].r;
        }
    }
    const double scale = strength * mesh_.spacing * mesh_.spacing;
    for (std::size_t v = 0; v < shift_.size(); ++v) {
        position[v].x += scale / volume_[v] * shift_[v].x;
        if (mesh_.vertices[v].r > 0.0) {
            position[v].r += scale / volume_[v] * shift_[v].r;
        }
    }
}

}  // namespace bioprint::solid
