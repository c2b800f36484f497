#pragma once

#include <span>
#include <vector>

#include "lattice/d3q19.hpp"
#include "solid/tetra_points.hpp"
#include "solid/tetra_solid.hpp"
#include "solid/tetra_volume.hpp"

/// An elastic body of tetrahedra in the 3-D lattice, two-way coupled; lattice units.
///
/// Forces are spread to the eight nodes about a point with trilinear weights, velocities interpolated with
/// the same weights: the two are adjoint, so the coupling neither makes nor loses work. The points lie inside
/// the elements (solid/tetra_points.hpp), or are the mesh's nodes, the usual way, which makes a body act as
/// one larger by a third of a spacing and more; it is kept to show that.
///
/// In a lattice with a mirror at z = 0 the body is the half z ≥ 0, and what falls beyond the mirror folds
/// back.
namespace bioprint {

struct ImmersedBodySetup {
    double radius;
    double spacing = 2.0;  ///< of the mesh's nodes, nearest built-in mesh
    bool inside = true;    ///< couple through points inside the elements
    double shear_modulus;
    double bulk_modulus = 0.0;      ///< 0: the fluid alone keeps the volume
    double volume_strength = 0.02;  ///< of the volume relaxation in each step
};

template <class Real>
class ImmersedBody {
  public:
    /// `centre` in lattice positions: x from the low face, y and z from the section's centre.
    ImmersedBody(const ImmersedBodySetup& setup, D3q19<Real>& lattice, const Vector3& centre);

    /// Puts the body's forces into the fluid.
    /// @throws NotConverged  an element turned inside out, or the body touches a wall
    void load();
    /// Moves with the fluid after the step that followed `load`.
    void move();

    [[nodiscard]] const TetraSolid& solid() const { return solid_; }
    [[nodiscard]] const std::vector<Vector3>& positions() const { return position_; }
    [[nodiscard]] const std::vector<Vector3>& velocities() const { return velocity_; }
    void set_positions(const std::vector<Vector3>& positions) { position_ = positions; }
    void shift(const Vector3& by);
    /// The positions as plain numbers, and back: all the body's memory.
    [[nodiscard]] std::vector<double> record() const;
    /// @throws DataError  the numbers are of another mesh
    void restore(std::span<const double> record);
    [[nodiscard]] SolidState state() const { return solid_.state(position_); }

  private:
    struct Stencil {
        std::array<int, 4> row;  ///< (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1)
        std::array<double, 4> weight;
        int x, next_x;
        double share;     ///< of next_x
        double low_sign;  ///< −1 when the first two rows are mirror images
    };
    [[nodiscard]] Stencil stencil(const Vector3& point) const;
    void clear();

    ImmersedBodySetup setup_;
    D3q19<Real>& lattice_;
    bool half_;
    TetraSolid solid_;
    TetraPoints inside_;
    TetraVolume volume_;
    std::vector<int> row_of_;   ///< of (y, z) from −1 to ny, nz
    std::vector<int> touched_;  ///< rows that carry forces
    std::vector<char> is_touched_;
    std::vector<Vector3> position_, velocity_, force_, point_, point_force_, point_velocity_;
    std::vector<Stencil> stencil_;
};

extern template class ImmersedBody<float>;
extern template class ImmersedBody<double>;

}  // namespace bioprint
