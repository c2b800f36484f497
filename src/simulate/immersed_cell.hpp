#pragma once

#include <array>
#include <span>
#include <vector>

#include "lattice/axisymmetric.hpp"
#include "solid/ring_points.hpp"
#include "solid/ring_triangles.hpp"
#include "solid/volume_relaxation.hpp"

/// A centred elastic cell in the axisymmetric lattice, two-way coupled; lattice units.
///
/// Forces are spread with the two-point kernel over the ring areas 2πr of the nodes, velocities interpolated
/// with the same weights: the two are adjoint, so the coupling neither makes nor loses work.
///
/// The forces are those of the mean of the last two positions: half of each step's positions is what keeps the lattice's
/// oscillation of period two, which no viscosity damps, from feeding on them (A. J. C. Ladd, J. Fluid Mech. 271, 1994,
/// averages the forces on a particle so). Without it the cell of every run grows it, e times in some thousand steps.
///
/// `inside` couples through points within the elements (solid/ring_points.hpp). Three points an element and
/// elements 1.5 lattice spacings wide leave no excess of the body's hydrodynamic radius that can be seen;
/// coupling at the vertices, the usual way, makes a body act as one larger by 0.3 to 0.4 spacings at any
/// resolution, and is kept to show that. There `retraction` makes the mesh smaller and its material stiffer
/// in proportion to volume.
namespace bioprint {

enum class Coupling { inside, vertices };

struct ImmersedCellSetup {
    double radius;
    Coupling coupling = Coupling::inside;
    double retraction = 0.0;
    double spacing = 1.52;          ///< of the mesh, before rounding to whole layers
    double shear_modulus;           ///< in lattice stress units
    double bulk_modulus = 0.0;      ///< zero: the fluid alone keeps the volume
    double volume_strength = 0.08;  ///< of a sweep of the volume relaxation
    int volume_sweeps = 4;  ///< a step: fewer let a soft cell's elements drift and take up less stress
};

class ImmersedCell {
  public:
    ImmersedCell(const ImmersedCellSetup& setup, double centre);

    /// Puts the cell's forces into the flow.
    void load(lattice::AxisymmetricFlow& flow);
    /// Moves with the flow's velocity after the step that followed `load`.
    /// @return false when a velocity is out of all bounds: the run has broken down, and nothing was moved
    [[nodiscard]] bool move(const lattice::AxisymmetricFlow& flow);

    [[nodiscard]] solid::RingShape shape() const;
    [[nodiscard]] const solid::RingTriangles& body() const { return body_; }
    [[nodiscard]] std::span<const solid::RingPoint> positions() const { return position_; }
    [[nodiscard]] std::vector<double> von_mises() const;
    void set_positions(std::span<const solid::RingPoint> position);
    /// Positions and velocities as plain numbers, and back.
    /// @throws DataError  they are those of another mesh
    [[nodiscard]] std::vector<double> state() const;
    void restore(std::span<const double> state);
    void shift(double x);

  private:
    /// The four nodes about a point: bilinear weights; row −1 is row 0 seen in the axis.
    struct Stencil {
        std::array<std::size_t, 4> node;
        std::array<double, 4> weight;
        std::array<double, 4> radial_weight;
        std::array<double, 4> inverse_radius;
    };
    [[nodiscard]] static Stencil stencil(const solid::RingPoint& p,
                                         const lattice::AxisymmetricDomain& domain);
    [[nodiscard]] lattice::ForceWindow window() const;
    void clear(lattice::AxisymmetricFlow& flow) const;

    ImmersedCellSetup setup_;
    solid::RingTriangles body_;
    solid::VolumeRelaxation volume_;
    solid::RingPoints inside_;
    solid::NeoHookean stiffened_;
    std::vector<solid::RingPoint> position_, mean_position_, vertex_velocity_, point_, point_velocity_;
    std::vector<solid::RingForce> force_, point_force_;
    std::vector<Stencil> stencil_;
    lattice::ForceWindow loaded_;
};

}  // namespace bioprint
