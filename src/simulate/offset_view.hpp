#pragma once

#include <array>

#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/ellipsoid_axes.hpp"
#include "simulate/immersed_body.hpp"
#include "simulate/offset_channel_scene.hpp"

/// What the scenes with a cell beside the axis share: their lattice units, and what is read off the cell.
namespace bioprint {

struct OffsetUnits {
    double spacing;  ///< [m]
    double time;     ///< [s] a step
    double nu0;      ///< zero-shear viscosity of the lattice
    double stress;   ///< [Pa] a lattice unit
    const char* binding;
};

struct OffsetCell {
    double radius;         ///< [m]
    double shear_modulus;  ///< [Pa]
    double nodes;          ///< a radius
};

/// The longest time step three limits allow: the cell crosses less than a tenth of a spacing in a step, the
/// fluid follows the cell (Reynolds number of the cell at the wall's rate and viscosity ½), elastic waves are
/// slower than sound.
OffsetUnits offset_units(const OffsetCell& cell, const NozzleFlow& flow);
OffsetLattice lattice_report(const OffsetUnits& units, const NozzleFlow& flow, const OffsetCell& cell,
                             int length);

/// Of a run in the channel, known before it.
struct OffsetChannelSteps {
    long sample;  ///< between two looks at the cell; a run that settles takes 3 to 4 windows of 8 of them
    long most;    ///< until it ends in any case
};
OffsetChannelSteps offset_channel_steps(const OffsetChannelSetup& setup, const NozzleFlow& flow,
                                        const OffsetUnits& units);

/// One look at a body and the fluid inside it; lattice units.
template <class Real>
class OffsetView {
  public:
    /// @throws NotConverged  the body's numbers are not finite
    OffsetView(const D3q19<Real>& lattice, const ImmersedBody<Real>& body, const MirrorEllipsoid& rest);

    [[nodiscard]] const Vector3& centre() const { return state_.ellipsoid.centre; }
    [[nodiscard]] double von_mises() const { return state_.von_mises; }
    [[nodiscard]] std::array<double, 3> stretch() const;
    [[nodiscard]] double angle() const { return now_.angle; }
    /// Widths along the nozzle and across it in the mirror plane, over those at rest.
    [[nodiscard]] double axial_stretch() const;
    [[nodiscard]] double radial_stretch() const;
    [[nodiscard]] double frequency() const;
    [[nodiscard]] double volume() const { return state_.volume / body_.solid().rest_volume(); }
    /// Mean over the lattice nodes in the equivalent ellipsoid of the viscous shear stress in its axes.
    [[nodiscard]] double viscous_stress() const;

  private:
    const D3q19<Real>& lattice_;
    const ImmersedBody<Real>& body_;
    const MirrorEllipsoid& rest_;
    SolidState state_;
    MirrorEllipsoid now_;
};

extern template class OffsetView<float>;
extern template class OffsetView<double>;

}  // namespace bioprint
