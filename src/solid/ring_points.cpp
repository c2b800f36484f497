#include "solid/ring_points.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace bioprint::solid {
namespace {

/// y = A x for a symmetric A held row by row; walks rows so that the inner loop is free of sums and
/// vectorises.
void multiply(const std::vector<double>& a, const std::vector<double>& x, std::vector<double>& y) {
    const std::size_t n = x.size();
    std::fill(y.begin(), y.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const double* row = a.data() + i * n;
        const double factor = x[i];
        for (std::size_t j = 0; j < n; ++j) {
            y[j] += factor * row[j];
        }
    }
}

}  // namespace

RingPoints::RingPoints(const RingMesh& mesh)
    : vertices_(mesh.vertices.size()),
      in_x_(vertices_),
      in_r_(vertices_),
      out_x_(vertices_),
      out_r_(vertices_) {
    constexpr double near = 2.0 / 3.0;
    constexpr double far = 1.0 / 6.0;
    for (const auto& t : mesh.triangles) {
        std::array<RingPoint, 3> p{};
        for (std::size_t n = 0; n < 3; ++n) {
            p[n] = mesh.vertices[static_cast<std::size_t>(t[n])];
        }
        const double area =
            0.5 * ((p[1].x - p[0].x) * (p[2].r - p[0].r) - (p[2].x - p[0].x) * (p[1].r - p[0].r));
        for (std::size_t n = 0; n < 3; ++n) {
            Point point{.v = t, .basis = {far, far, far}, .weight = 0.0};
            point.basis[n] = near;
            const double r = point.basis[0] * p[0].r + point.basis[1] * p[1].r + point.basis[2] * p[2].r;
            point.weight = 2.0 * std::numbers::pi * r * area / 3.0;
            points_.push_back(point);
        }
    }
    std::vector<bool> held(vertices_, false);
    invert_mass(inverse_x_, held);
    for (std::size_t v = 0; v < vertices_; ++v) {
        held[v] = mesh.on_axis(static_cast<int>(v));
    }
    invert_mass(inverse_r_, held);
}

// Gauss-Jordan without pivoting: the matrix is symmetric and positive. Held vertices get a zero row and
// column.
void RingPoints::invert_mass(std::vector<double>& inverse, const std::vector<bool>& held) const {
    const std::size_t n = vertices_;
    std::vector<double> mass(n * n, 0.0);
    for (const Point& q : points_) {
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) {
                mass[static_cast<std::size_t>(q.v[a]) * n + static_cast<std::size_t>(q.v[b])] +=
                    q.weight * q.basis[a] * q.basis[b];
            }
        }
    }
    inverse.assign(n * n, 0.0);
    for (std::size_t v = 0; v < n; ++v) {
        for (std::size_t w = 0; w < n && held[v]; ++w) {
            mass[v * n + w] = mass[w * n + v] = 0.0;
        }
        mass[v * n + v] = held[v] ? 1.0 : mass[v * n + v];
        inverse[v * n + v] = held[v] ? 0.0 : 1.0;
    }
    for (std::size_t k = 0; k < n; ++k) {
        const double pivot = 1.0 / mass[k * n + k];
        for (std::size_t j = 0; j < n; ++j) {
            mass[k * n + j] *= pivot;
            inverse[k * n + j] *= pivot;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const double factor = mass[i * n + k];
            if (i == k || factor == 0.0) {
                continue;
            }
            for (std::size_t j = 0; j < n; ++j) {
                mass[i * n + j] -= factor * mass[k * n + j];
                inverse[i * n + j] -= factor * inverse[k * n + j];
            }
        }
    }
}

void RingPoints::place(std::span<const RingPoint> vertices, std::span<RingPoint> points) const {
    for (std::size_t q = 0; q < points_.size(); ++q) {
        points[q] = {.x = 0.0, .r = 0.0};
        for (std::size_t a = 0; a < 3; ++a) {
            const RingPoint& p = vertices[static_cast<std::size_t>(points_[q].v[a])];
            points[q].x += points_[q].basis[a] * p.x;
            points[q].r += points_[q].basis[a] * p.r;
        }
    }
}

void RingPoints::spread(std::span<const RingForce> vertices, std::span<RingForce> points) {
    for (std::size_t v = 0; v < vertices_; ++v) {
        in_x_[v] = vertices[v].x;
        in_r_[v] = vertices[v].r;
    }
    multiply(inverse_x_, in_x_, out_x_);
    multiply(inverse_r_, in_r_, out_r_);
    for (std::size_t q = 0; q < points_.size(); ++q) {
        points[q] = {.x = 0.0, .r = 0.0};
        for (std::size_t a = 0; a < 3; ++a) {
            const auto v = static_cast<std::size_t>(points_[q].v[a]);
            points[q].x += points_[q].weight * points_[q].basis[a] * out_x_[v];
            points[q].r += points_[q].weight * points_[q].basis[a] * out_r_[v];
        }
    }
}

void RingPoints::gather(std::span<const RingPoint> points, std::span<RingPoint> vertices) {
    std::fill(in_x_.begin(), in_x_.end(), 0.0);
    std::fill(in_r_.begin(), in_r_.end(), 0.0);
    for (std::size_t q = 0; q < points_.size(); ++q) {
        for (std::size_t a = 0; a < 3; ++a) {
            const auto v = static_cast<std::size_t>(points_[q].v[a]);
            in_x_[v] += points_[q].weight * points_[q].basis[a] * points[q].x;
            in_r_[v] += points_[q].weight * points_[q].basis[a] * points[q].r;
        }
    }
    multiply(inverse_x_, in_x_, out_x_);
    multiply(inverse_r_, in_r_, out_r_);
    for (std::size_t v = 0; v < vertices_; ++v) {
        vertices[v] = {.x = out_x_[v], .r = out_r_[v]};
    }
}

}  // namespace bioprint::solid
