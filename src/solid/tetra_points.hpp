#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "solid/tetra_solid.hpp"

/// Points inside a body's tetrahedra through which it meets the fluid around it.
///
/// Four points an element carry the nodal forces as the density f(X) = Σ F_a φ_a(X) whose moments are those
/// forces, and hand velocities back as the linear finite-element field nearest to them in the mean over the
/// rest volume:
///
///   M F = nodal forces,   M U = Σ_q w_q φ(X_q) u_q,   M_ab = Σ_q w_q φ_a(X_q) φ_b(X_q)
///
/// The two are adjoint, Σ_q f_q·u_q = Σ_a force_a·U_a, and exact for velocities linear in space. No point
/// lies on the surface: what is spread about the points stays with the body instead of enlarging it. Nodes in
/// the mirror plane of a half body have neither force nor velocity across it.
///
/// After Griffith, Luo, Int. J. Numer. Meth. Biomed. Engng 33 (2017) e2888.
namespace bioprint {

class TetraPoints {
  public:
    TetraPoints(const TetraMesh& mesh, bool half);
    ~TetraPoints();
    TetraPoints(const TetraPoints&) = delete;
    TetraPoints& operator=(const TetraPoints&) = delete;

    [[nodiscard]] std::size_t size() const { return points_.size(); }
    void place(const std::vector<Vector3>& nodes, std::vector<Vector3>& points) const;
    /// Forces of the points, their sum equal to that of the nodes.
    void spread(const std::vector<Vector3>& nodes, std::vector<Vector3>& points);
    /// Velocities of the nodes from those of the points.
    void gather(const std::vector<Vector3>& points, std::vector<Vector3>& nodes);

  private:
    struct Point {
        std::array<int, 4> node;
        std::array<double, 4> basis;
        double weight;
    };
    struct Mass;  ///< factors of M, and of M without the nodes held in the mirror plane
    void solve();

    std::vector<Point> points_;
    std::unique_ptr<Mass> mass_;
};

}  // namespace bioprint
