#include "solid/ring_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bioprint::solid {
namespace {

constexpr double pi = std::numbers::pi;

double plane_area(const RingPoint& a, const RingPoint& b, const RingPoint& c) {
    return 0.5 * ((b.x - a.x) * (c.r - a.r) - (c.x - a.x) * (b.r - a.r));
}

}  // namespace

RingTriangles::RingTriangles(const RingMesh& mesh) : mesh_(mesh) {
    elements_.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        const auto point = [&](int n) {
            return mesh.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(n)])];
        };
        Element e{.v = triangle, .gradient = {}, .inverse_centroid = 0.0, .volume = 0.0};
        const double area = plane_area(point(0), point(1), point(2));
        for (int n = 0; n < 3; ++n) {
            const RingPoint b = point((n + 1) % 3);
            const RingPoint c = point((n + 2) % 3);
            e.gradient[static_cast<std::size_t>(n)] = {.x = (b.r - c.r) / (2.0 * area),
                                                       .r = (c.x - b.x) / (2.0 * area)};
        }
        const double centroid = (point(0).r + point(1).r + point(2).r) / 3.0;
        e.inverse_centroid = 1.0 / centroid;
        e.volume = 2.0 * pi * centroid * area;
        elements_.push_back(e);
    }
}

RingTriangles::Deformation RingTriangles::deformation(const Element& e, std::span<const RingPoint> position) {
    Deformation f{};
    double r = 0.0;
    for (std::size_t n = 0; n < 3; ++n) {
        const RingPoint& p = position[static_cast<std::size_t>(e.v[n])];
        f.xx += p.x * e.gradient[n].x;
        f.xr += p.x * e.gradient[n].r;
        f.rx += p.r * e.gradient[n].x;
        f.rr += p.r * e.gradient[n].r;
        r += p.r / 3.0;
    }
    f.hoop = r * e.inverse_centroid;
    return f;
}

double RingTriangles::energy(std::span<const RingPoint> position, const NeoHookean& material,
                             std::span<RingForce> forces) const {
    double total = 0.0;
    for (const Element& e : elements_) {
        const Deformation f = deformation(e, position);
        const double j = f.jacobian();
        const double square = f.square();
        const double shear = material.shear_modulus / std::cbrt(j * j);
        total += e.volume * (0.5 * shear * square - 1.5 * material.shear_modulus +
                             0.5 * material.bulk_modulus * (j - 1.0) * (j - 1.0));
        if (forces.empty()) {
            continue;
        }
        // P = shear (F − tr/3 F⁻ᵀ) + κ (J − 1) J F⁻ᵀ
        const double spherical = material.bulk_modulus * (j - 1.0) * j - shear * square / 3.0;
        const double inverse = spherical / f.plane();
        const double p_xx = shear * f.xx + inverse * f.rr;
        const double p_xr = shear * f.xr - inverse * f.rx;
        const double p_rx = shear * f.rx - inverse * f.xr;
        const double p_rr = shear * f.rr + inverse * f.xx;
        const double p_hoop = (shear * f.hoop + spherical / f.hoop) * e.inverse_centroid / 3.0;
        for (std::size_t n = 0; n < 3; ++n) {
            RingForce& force = forces[static_cast<std::size_t>(e.v[n])];
            force.x -= e.volume * (p_xx * e.gradient[n].x + p_xr * e.gradient[n].r);
            force.r -= e.volume * (p_rx * e.gradient[n].x + p_rr * e.gradient[n].r + p_hoop);
        }
    }
    return total;
}

double RingTriangles::von_mises(const Deformation& f, double shear_modulus) {
    const double b_xx = f.xx * f.xx + f.xr * f.xr;
    const double b_rr = f.rx * f.rx + f.rr * f.rr;
    const double b_xr = f.xx * f.rx + f.xr * f.rr;
    const double b_tt = f.hoop * f.hoop;
    const double third = (b_xx + b_rr + b_tt) / 3.0;
    const double square = (b_xx - third) * (b_xx - third) + (b_rr - third) * (b_rr - third) +
                          (b_tt - third) * (b_tt - third) + 2.0 * b_xr * b_xr;
    return shear_modulus * std::sqrt(1.5 * square) / std::pow(std::abs(f.jacobian()), 5.0 / 3.0);
}

std::vector<double> RingTriangles::von_mises(std::span<const RingPoint> position,
                                             const NeoHookean& material) const {
    std::vector<double> stress;
    stress.reserve(elements_.size());
    for (const Element& e : elements_) {
        stress.push_back(von_mises(deformation(e, position), material.shear_modulus));
    }
    return stress;
}

std::vector<double> RingTriangles::jacobians(std::span<const RingPoint> position) const {
    std::vector<double> ratios;
    ratios.reserve(elements_.size());
    for (const Element& e : elements_) {
        ratios.push_back(deformation(e, position).jacobian());
    }
    return ratios;
}

RingShape RingTriangles::shape(std::span<const RingPoint> position, const NeoHookean& material) const {
    RingShape s{.volume = 0.0,
                .centre = 0.0,
                .length = 0.0,
                .width = 0.0,
                .von_mises = 0.0,
                .smallest_jacobian = 1e300,
                .jacobian_min = 1e300,
                .jacobian_max = -1e300,
                .deformation = 0.0};
    double undeformed = 0.0;
    for (const Element& e : elements_) {
        const Deformation f = deformation(e, position);
        const double j = f.jacobian();
        double x = 0.0;
        double r = 0.0;
        double xr = 0.0;
        for (const int v : e.v) {
            const RingPoint& p = position[static_cast<std::size_t>(v)];
            x += p.x / 3.0;
            r += p.r / 3.0;
            xr += p.x * p.r / 3.0;
        }
        // ∫ x r dA = area/4 (3 x̄ r̄ + mean(x r)); the ring's volume is 2π r̄ area.
        s.volume += e.volume * j;
        s.centre += e.volume * j * (0.75 * x + 0.25 * (r > 0.0 ? xr / r : x));
        s.von_mises += e.volume * von_mises(f, material.shear_modulus);
        undeformed += e.volume;
        s.smallest_jacobian = std::min(s.smallest_jacobian, std::min(f.plane(), f.hoop));
        s.jacobian_min = std::min(s.jacobian_min, j);
        s.jacobian_max = std::max(s.jacobian_max, j);
    }
    s.centre /= s.volume;
    s.von_mises /= undeformed;
    double area = 0.0;
    double perimeter = 0.0;
    double low = 1e300;
    double high = -1e300;
    for (std::size_t n = 0; n < mesh_.outline.size(); ++n) {
        const RingPoint& p = position[static_cast<std::size_t>(mesh_.outline[n])];
        low = std::min(low, p.x);
        high = std::max(high, p.x);
        s.width = std::max(s.width, 2.0 * p.r);
        if (n > 0) {
            const RingPoint& q = position[static_cast<std::size_t>(mesh_.outline[n - 1])];
            area += (q.x - p.x) * (q.r + p.r);
            perimeter += 2.0 * std::hypot(p.x - q.x, p.r - q.r);
        }
    }
    s.length = high - low;
    s.deformation = 1.0 - 2.0 * std::sqrt(pi * std::abs(area)) / perimeter;
    return s;
}

}  // namespace bioprint::solid
