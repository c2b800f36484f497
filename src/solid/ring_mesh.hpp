#pragma once

#include <array>
#include <vector>

/// The half disk that turns into a sphere about the axis r = 0, cut into triangles; unit-free.
///
/// Layer k of n holds 3k segments between the poles: 3n² triangles of nearly one size, vertices on the true
/// circle.
namespace bioprint::solid {

struct RingPoint {
    double x;
    double r;
};

struct RingMesh {
    std::vector<RingPoint> vertices;
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise in (x, r)
    std::vector<int> outline;                   ///< vertices of the surface from one pole to the other
    double radius;
    double spacing;  ///< radius / layers

    [[nodiscard]] bool on_axis(int vertex) const {
        return vertices[static_cast<std::size_t>(vertex)].r == 0.0;
    }
};

/// A sphere of `radius` about the origin in `layers` ≥ 1 layers.
RingMesh half_disk(double radius, int layers);

}  // namespace bioprint::solid
