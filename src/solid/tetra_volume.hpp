#pragma once

#include <vector>

#include "solid/tetra_solid.hpp"

/// Holds the volumes about the nodes of an immersed body of tetrahedra.
///
/// In an incompressible fluid a body keeps the volume of each of its parts, and elastic pressure does nothing
/// but shift the fluid's. On a lattice nodes move with interpolated velocities whose divergence vanishes only
/// to second order, so element volumes wander. One step of a descent on
///
///   E = Σ_v (V_v − V0_v)²/(2 V0_v),    V_v = a quarter of the elements about node v
///
/// moves the nodes back without loading the fluid. Volumes about nodes, not of elements, are held: a third as
/// many conditions as unknowns, so the mesh does not lock.
namespace bioprint {

class TetraVolume {
  public:
    explicit TetraVolume(const TetraMesh& mesh, bool half);
    /// `strength` below about 0.1 is stable; it is scaled by the square of the spacing.
    void relax(std::vector<Vector3>& positions, double strength);

  private:
    TetraMesh mesh_;
    bool half_;
    double spacing_ = 1.0;
    std::vector<double> rest_, volume_;
    std::vector<Vector3> step_;
};

}  // namespace bioprint
