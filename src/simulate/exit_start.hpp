#pragma once

#include "lattice/axisymmetric.hpp"
#include "lattice/d3q19.hpp"
#include "simulate/exit_field.hpp"

/// The flow through the exit without a cell, settled in the plane and read anywhere in space: what a lattice in
/// three dimensions starts from, a hundred times cheaper than to settle there.
///
/// The two lattices differ by their discretisation errors alone (the lip by half a spacing), so what is left to
/// settle in space, sound above all, is a hundredth of what a developed profile and a plug leave.
namespace bioprint {

class ExitStart {
  public:
    /// @throws NotConverged  the flow did not become steady
    explicit ExitStart(const NozzleFlow& flow, double nodes_a_radius);

    /// At x behind the lip and (y, z) from the axis, in nozzle radii. Velocities are in average velocities,
    /// lengths in radii, and the density is three times the pressure over η0 u_avg/R.
    [[nodiscard]] FlowState at(double x, double y, double z) const;

  private:
    struct Plane {
        double x, r, pressure;
    };
    [[nodiscard]] Plane interpolated(double x, double r) const;

    int lip_;
    double nodes_, velocity_, pressure_;
    lattice::AxisymmetricFields fields_;
};

}  // namespace bioprint
