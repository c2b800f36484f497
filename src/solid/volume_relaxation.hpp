#pragma once

#include <span>
#include <vector>

#include "solid/ring_mesh.hpp"

/// Holds the volumes of an immersed body's rings.
///
/// In an incompressible fluid an immersed body keeps the volume of every part of it: elastic pressure then
/// does nothing but shift the fluid's. On a lattice the body's vertices are moved by interpolated velocities
/// whose divergence vanishes only to second order, and the volume of elements wanders. A descent on
///
///   E = Σ_v (V_v − V0_v)²/(2 V0_v),  V_v = a third of the elements about vertex v
///
/// moves the vertices back without loading the fluid. Volumes about vertices, not of elements, are held: as
/// many conditions as half the unknowns, so the mesh does not lock.
namespace bioprint::solid {

class VolumeRelaxation {
  public:
    explicit VolumeRelaxation(const RingMesh& mesh);

    /// One step of the descent, of `strength` times the spacing squared (stable below about 0.1).
    void apply(std::span<RingPoint> position, double strength);

  private:
    RingMesh mesh_;
    std::vector<double> volume_, own_;
    std::vector<double> strain_;
    std::vector<RingPoint> shift_;
};

}  // namespace bioprint::solid
