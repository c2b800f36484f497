#pragma once

#include <array>
#include <span>
#include <vector>

#include "solid/ring_mesh.hpp"

/// Neo-Hookean rings with triangular section: an axisymmetric elastic body by linear finite elements.
///
///   U = μ/2 (Ī − 3) + κ/2 (J − 1)²,  Ī = J^(−2/3) tr(FᵀF)          F: 2×2 in the plane, hoop stretch r/R at
///   the centroid nodal force = −V0 ∂U/∂x, the exact derivative tests/unit/solid/ring_triangles.cpp
///
/// κ = 0 leaves the volume to whatever surrounds the body: an immersed body in an incompressible fluid keeps
/// it. Stress is reported as the Cauchy stress's deviator, which κ does not enter.
namespace bioprint::solid {

struct NeoHookean {
    double shear_modulus;
    double bulk_modulus = 0.0;
};

struct RingForce {
    double x;
    double r;
};

/// What can be read off a deformed body.
struct RingShape {
    double volume;
    double centre;             ///< x of the centre of volume
    double length;             ///< extent along x
    double width;              ///< twice the largest r
    double von_mises;          ///< mean over the undeformed volume
    double smallest_jacobian;  ///< of an element's in-plane part; ≤ 0 is inverted
    double jacobian_min, jacobian_max;
    double deformation;  ///< 1 − 2√(πA)/P of the outline in a plane through the axis
};

class RingTriangles {
  public:
    explicit RingTriangles(const RingMesh& mesh);

    [[nodiscard]] const RingMesh& mesh() const { return mesh_; }
    /// The energy and, if `forces` is not empty, the nodal forces (added to what stands there).
    double energy(std::span<const RingPoint> position, const NeoHookean& material,
                  std::span<RingForce> forces) const;
    [[nodiscard]] RingShape shape(std::span<const RingPoint> position, const NeoHookean& material) const;
    /// Mean von Mises stress of each element.
    [[nodiscard]] std::vector<double> von_mises(std::span<const RingPoint> position,
                                                const NeoHookean& material) const;
    /// Volume of each element over its undeformed volume.
    [[nodiscard]] std::vector<double> jacobians(std::span<const RingPoint> position) const;

  private:
    struct Element {
        std::array<int, 3> v;
        std::array<RingPoint, 3> gradient;  ///< of the shape functions, undeformed
        double inverse_centroid;            ///< 1/R of the centroid
        double volume;
    };
    struct Deformation {
        double xx, xr, rx, rr, hoop;
        [[nodiscard]] double plane() const { return xx * rr - xr * rx; }
        [[nodiscard]] double jacobian() const { return plane() * hoop; }
        [[nodiscard]] double square() const { return xx * xx + xr * xr + rx * rx + rr * rr + hoop * hoop; }
    };
    [[nodiscard]] static Deformation deformation(const Element& e, std::span<const RingPoint> position);
    [[nodiscard]] static double von_mises(const Deformation& f, double shear_modulus);

    RingMesh mesh_;
    std::vector<Element> elements_;
};

}  // namespace bioprint::solid
