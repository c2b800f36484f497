#pragma once

#include <array>
#include <span>
#include <vector>

#include "solid/ring_triangles.hpp"

/// Points inside a body's elements through which it meets what surrounds it.
///
/// Three points an element carry the nodal forces as the density f(X) = Σ F_a φ_a(X) whose moments are those
/// forces, and hand velocities back as the linear finite-element field nearest to them in the mean over the
/// volume:
///
///   M F = nodal forces,  M U = Σ_q w_q φ(X_q) u_q,  M_ab = Σ_q w_q φ_a φ_b
///
/// The two are adjoint, Σ_q w_q f_q·u_q = Σ_a force_a·U_a, and exact for fields linear in space. No point
/// lies on the surface, which keeps what is spread about the points inside the body. On the axis the radial
/// part is zero.
///
/// After Griffith, Luo, Int. J. Numer. Meth. Biomed. Engng 33 (2017) e2888, for rings.
namespace bioprint::solid {

class RingPoints {
  public:
    explicit RingPoints(const RingMesh& mesh);

    [[nodiscard]] std::size_t size() const { return points_.size(); }
    void place(std::span<const RingPoint> vertices, std::span<RingPoint> points) const;
    /// Ring forces of the points, Σ equal to that of the vertices.
    void spread(std::span<const RingForce> vertices, std::span<RingForce> points);
    /// Velocities of the vertices from those of the points.
    void gather(std::span<const RingPoint> points, std::span<RingPoint> vertices);

  private:
    struct Point {
        std::array<int, 3> v;
        std::array<double, 3> basis;
        double weight;
    };
    void invert_mass(std::vector<double>& inverse, const std::vector<bool>& held) const;

    std::size_t vertices_;
    std::vector<Point> points_;
    std::vector<double> inverse_x_, inverse_r_;  ///< of the mass matrix, dense
    std::vector<double> in_x_, in_r_, out_x_, out_r_;
};

}  // namespace bioprint::solid
