#include "solid/ring_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bioprint::solid {

namespace {

double sphere_volume(double radius) {
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

double volume(const RingMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        const RingPoint& a = mesh.vertices[static_cast<std::size_t>(t[0])];
        const RingPoint& b = mesh.vertices[static_cast<std::size_t>(t[1])];
        const RingPoint& c = mesh.vertices[static_cast<std::size_t>(t[2])];
        const double area = 0.5 * ((b.x - a.x) * (c.r - a.r) - (c.x - a.x) * (b.r - a.r));
        sum += 2.0 * std::numbers::pi * (a.r + b.r + c.r) / 3.0 * area;
    }
    return sum;
}

}  // namespace

RingMesh half_disk(double radius, int layers) {
    RingMesh mesh{.vertices = {{.x = 0.0, .r = 0.0}},
                  .triangles = {},
                  .outline = {},
                  .radius = radius,
                  .spacing = radius / layers};
    int inner = 0;  // first vertex of the layer within
    for (int k = 1; k <= layers; ++k) {
        const int segments = 3 * k;
        const int outer = static_cast<int>(mesh.vertices.size());
        for (int s = 0; s <= segments; ++s) {
            const double angle = std::numbers::pi * s / segments;
            const bool pole = s == 0 || s == segments;
            const double distance = radius * k / layers;
            mesh.vertices.push_back(
                {.x = distance * std::cos(angle), .r = pole ? 0.0 : distance * std::sin(angle)});
        }
        // Walk both arcs together: advance on the one whose next vertex comes first.
        const int inner_segments = 3 * (k - 1);
        int a = 0;
        int b = 0;
        while (a < inner_segments || b < segments) {
            const bool step_outer = static_cast<long>(2 * b + 1) * std::max(inner_segments, 1) <=
                                        static_cast<long>(2 * a + 1) * segments ||
                                    a == inner_segments;
            if (step_outer && b < segments) {
                mesh.triangles.push_back({inner + a, outer + b, outer + b + 1});
                ++b;
            } else {
                mesh.triangles.push_back({inner + a, outer + b, inner + a + 1});
                ++a;
            }
        }
        inner = outer;
    }
    const double shortfall = sphere_volume(radius) / volume(mesh);
    for (auto& p : mesh.vertices) {
        p.x *= std::cbrt(shortfall);
        p.r *= std::cbrt(shortfall);
    }
    for (int v = inner; v < static_cast<int>(mesh.vertices.size()); ++v) {
        mesh.outline.push_back(v);
    }
    return mesh;
}

}  // namespace bioprint::solid
