#pragma once

#include <array>
#include <vector>

#include "solid/tetra_mesh.hpp"

/// A compressible neo-Hookean solid of linear tetrahedra.
///
///   U = μ/2 (Ī − 3) + κ/2 (J − 1)²,     Ī = J^(−2/3) tr FᵀF,     f = −∂(Σ V0 U)/∂x, exactly
///   Cauchy stress  σ = μ J^(−5/3) dev(FFᵀ) + κ (J − 1) 1
///
/// Unit-free. An inverted element (J ≤ 0) has no energy; `forces` reports it and adds nothing for it.
/// Checked: forces against differences of the energy to 1e-8, rotation, no net force or torque.
///                                                                              tests/unit/solid/tetra_solid.cpp
namespace bioprint {

using Vector3 = std::array<double, 3>;
using Matrix3 = std::array<std::array<double, 3>, 3>;

struct Elasticity {
    double shear_modulus;  ///< μ
    double bulk_modulus;   ///< κ
};

/// κ = 2μ(1 + ν)/(3(1 − 2ν)) from Poisson's ratio −1 < ν < ½.
Elasticity elasticity(double shear_modulus, double poisson_ratio);

struct Ellipsoid {
    Vector3 centre;
    Vector3 semi_axes;   ///< falling
    Matrix3 directions;  ///< of the axes, one a row
    double inclination;  ///< of the longest axis in the xy plane against x, in (−π/2, π/2]
};

struct SolidState {
    double volume;     ///< of the deformed body
    double von_mises;  ///< mean over the elements, weighted by undeformed volume
    double von_mises_max;
    Matrix3 stress;  ///< mean Cauchy stress, weighted by undeformed volume
    double smallest_j;
    double largest_j;
    double worst_quality;  ///< 6√2 V / (rms edge)³, 1 for a regular tetrahedron, ≤ 0 inverted
    Ellipsoid ellipsoid;   ///< of equal inertia tensor
};

struct ElementState {
    double von_mises;
    double jacobian;  ///< volume over rest volume
};

class TetraSolid {
  public:
    /// `half`: the mesh is the part z ≥ 0 of a body with a mirror plane; what is reported is the whole
    /// body's.
    TetraSolid(TetraMesh mesh, const Elasticity& elasticity, bool half);

    [[nodiscard]] const TetraMesh& mesh() const { return mesh_; }
    [[nodiscard]] std::size_t nodes() const { return mesh_.nodes.size(); }
    [[nodiscard]] double rest_volume() const { return rest_volume_; }

    [[nodiscard]] double energy(const std::vector<Vector3>& positions) const;
    /// Replaces `forces`; returns the number of inverted elements.
    int forces(const std::vector<Vector3>& positions, std::vector<Vector3>& forces) const;
    [[nodiscard]] SolidState state(const std::vector<Vector3>& positions) const;
    /// The state of every element; an inverted one has no stress.
    [[nodiscard]] std::vector<ElementState> elements(const std::vector<Vector3>& positions) const;
    /// Mean gradient ∂v_i/∂x_j of a nodal velocity over the deformed body.
    [[nodiscard]] Matrix3 mean_gradient(const std::vector<Vector3>& positions,
                                        const std::vector<Vector3>& velocities) const;

  private:
    struct Element {
        Matrix3 gradient;  ///< of the shape functions of nodes 1 to 3 in the rest shape, one a row
        double volume;
    };
    [[nodiscard]] Matrix3 deformation(std::size_t element, const std::vector<Vector3>& positions) const;

    TetraMesh mesh_;
    Elasticity elasticity_;
    bool half_;
    double rest_volume_ = 0.0;
    std::vector<Element> elements_;
};

}  // namespace bioprint
