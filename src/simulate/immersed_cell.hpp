#pragma once

#include <span>
#include <vector>

#include "lattice/axisymmetric.hpp"
#include "solid/ring_triangles.hpp"
#include "solid/volume_relaxation.hpp"

/// A centred elastic cell in the axisymmetric lattice, two-way coupled; lattice units.
///
/// Forces are spread with the two-point kernel over ring areas 2πr of the nodes, and velocities are
/// interpolated with the same weights: the two are adjoint in r dr dx, so the coupling neither makes nor
/// loses work.
///
/// A body coupled this way acts as one larger by a fixed fraction δ of a lattice spacing, whatever the
/// resolution. The mesh is therefore made smaller by δ and the material stiffer in proportion to volume, so
/// that at a given strain it exerts the same stresslet as the cell it stands for; stresses and strains are
/// those of the cell.
namespace bioprint {

struct ImmersedCellSetup {
    double radius;             ///< of the cell
    double retraction = 0.38;  ///< δ
    double spacing = 1.5;      ///< of the mesh, before rounding to whole layers
    double shear_modulus;      ///< in lattice stress units
    double bulk_modulus = 0.0;
    double volume_strength = 0.02;  ///< of the volume relaxation, per step
};

class ImmersedCell {
  public:
    ImmersedCell(const ImmersedCellSetup& setup, double centre);

    /// Puts the cell's forces into the flow.
    void load(lattice::AxisymmetricFlow& flow);
    /// Moves with the flow's velocity after a step.
    void move(const lattice::AxisymmetricFlow& flow);

    [[nodiscard]] solid::RingShape shape() const;
    [[nodiscard]] double mesh_radius() const { return body_.mesh().radius; }
    [[nodiscard]] const solid::RingTriangles& body() const { return body_; }
    [[nodiscard]] std::span<const solid::RingPoint> positions() const { return position_; }
    void set_positions(std::span<const solid::RingPoint> position);
    void shift(double x);

  private:
    [[nodiscard]] lattice::ForceWindow window() const;
    void clear(lattice::AxisymmetricFlow& flow) const;

    ImmersedCellSetup setup_;
    solid::RingTriangles body_;
    solid::VolumeRelaxation volume_;
    solid::NeoHookean stiffened_;
    std::vector<solid::RingPoint> position_;
    std::vector<solid::RingForce> force_;
    lattice::ForceWindow loaded_;
};

}  // namespace bioprint
