#pragma once

#include <array>
#include <cstddef>

#include "bioprint/cell/transient.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "predict/exit_axis.hpp"

/// The undisturbed flow about a nozzle's end off the axis, from the one on it: an interpolated stream
/// function.
///
///   ψ(x, r) = u_avg r²/2 + f(X/s) D(r),   D = ∫_0^r (u − u_avg) r' dr',   s = 1 − c r²/R²
///
/// f is the profile on the axis (exit_axis.hpp), u that of the nozzle. It conserves mass exactly, is the
/// nozzle's flow far upstream, the plug far downstream, and the finite-element velocity on the axis. s makes
/// the change sharper towards the lip: c = 0.605 − 0.23 (1 − n_e) brings the largest radial velocity to within 2 % of
/// the finite-element one at α 0, 0.3 and 0.75, 15 to 20 % further in than that. At the wall itself the ink slips
/// over the last half radius; no cell reaches it.
namespace bioprint {

class ExitField {
  public:
    explicit ExitField(const NozzleFlow& flow);

    struct Point {
        double axial_velocity;   ///< [m/s]
        double radial_velocity;  ///< [m/s]
        Tensor gradient;         ///< in the directions x, r, θ [1/s]
        double rate;             ///< sqrt(2 S:S) [1/s]
        double shear_share;      ///< part of rate² that is shear in the plane of x and r
    };

    /// At x from the lip and r from the axis [m].
    [[nodiscard]] Point at(double x, double r) const;

    /// The stream function at x and r [m³/s]: the flux within r over 2π.
    [[nodiscard]] double stream(double x, double r) const;

    [[nodiscard]] double radius() const { return radius_; }

    /// The radius at x of the streamline that comes from `radius` in the nozzle [m].
    [[nodiscard]] double streamline(double radius, double x) const;

    /// ∫_0^r u r' dr' in the nozzle [m³/s]: the flux within r over 2π.
    [[nodiscard]] double nozzle_flux(double r) const {
        return 0.5 * velocity_average_ * r * r + excess(r).value;
    }

  private:
    struct Excess {
        double value;  ///< D(r)
        double slope;
        double bend;
    };
    [[nodiscard]] Excess excess(double r) const;

    static constexpr std::size_t size = 65;
    ExitAxis axis_;
    double radius_;
    double velocity_average_;
    double sharpening_;  ///< c
    std::array<Excess, size> knots_{};
};

}  // namespace bioprint
