#pragma once

#include "bioprint/rheology/cross.hpp"

/// Steady, fully developed flow of a Cross ink through a long cylinder (no inertia, no slip at the wall).
///
/// The stress is linear in the radius, τ(r) = G r/2, so the rate of strain is the natural variable of the
/// profile: with x = Kγ̇, t(x) = Kτ/η0 and q = t/t_w (w: wall),
///
///   u_avg         = R/(3K) ∫ (1 − q³) dx          u_max         = R/K  ∫ (1 − q) dx
///   γ̇_avg         = 1/K    ∫ (1 − q²) dx          u_max − u_avg = R/(3K) ∫ (1 − q)² (2 + q) dx,     x from 0
///   to x_w
///
/// Every integrand is positive, so even u_max − u_avg, on which the exit elongation rests, keeps full
/// relative accuracy for inks that flow almost as a plug.
///
/// Accuracy: 1e-11 relative for K·rate from 1e-12 to 1e12 and α from 0 to 1. tests/verify/nozzle_flow.cpp
/// Cost: about 5 µs.
/// Source: Müller, Bächer, Gekle, Phys. Fluids 2020 (the profile); the positive forms are this project's.
namespace bioprint {

class NozzleFlow {
  public:
    /// Each drives the flow by one quantity; radius [m] > 0.
    /// @throws NoSteadyFlow  past the stress maximum of an ink with α > 1, or past the saturation at α = 1
    static NozzleFlow from_flow_rate(const CrossInk& ink, double radius, double flow_rate);         // [m³/s]
    static NozzleFlow from_velocity(const CrossInk& ink, double radius, double velocity_average);   // [m/s]
    static NozzleFlow from_pressure_gradient(const CrossInk& ink, double radius, double gradient);  // [Pa/m]

    /// Driven by the rate of strain at the wall [1/s], ≥ 0: the one that needs no root.
    static NozzleFlow from_wall_rate(const CrossInk& ink, double radius, double rate);

    [[nodiscard]] const CrossInk& ink() const { return ink_; }
    [[nodiscard]] double radius() const { return radius_; }                      ///< [m]
    [[nodiscard]] double flow_rate() const;                                      ///< [m³/s]
    [[nodiscard]] double pressure_gradient() const;                              ///< G = −dp/dx [Pa/m]
    [[nodiscard]] double velocity_average() const { return velocity_average_; }  ///< [m/s]
    [[nodiscard]] double velocity_max() const { return velocity_max_; }          ///< on the axis [m/s]
    [[nodiscard]] double velocity_excess() const { return velocity_excess_; }    ///< u_max − u_avg [m/s]
    [[nodiscard]] double shear_rate_max() const { return wall_rate_; }           ///< at the wall [1/s]
    [[nodiscard]] double shear_rate_average() const { return rate_average_; }    ///< over the area [1/s]
    [[nodiscard]] double stress_max() const { return wall_stress_; }             ///< at the wall [Pa]
    [[nodiscard]] double stress_average() const { return 2.0 / 3.0 * wall_stress_; }  ///< over the area [Pa]

    /// Profiles at a radial position r [m], 0 ≤ r ≤ R.
    [[nodiscard]] double stress(double r) const { return wall_stress_ * (r / radius_); }  ///< [Pa]
    [[nodiscard]] double shear_rate(double r) const;                                      ///< [1/s]
    [[nodiscard]] double velocity(double r) const;                                        ///< [m/s]

  private:
    NozzleFlow(const CrossInk& ink, double radius, double wall_rate);
    CrossInk ink_;
    double radius_;
    double wall_rate_ = 0.0;
    double wall_stress_ = 0.0;
    double velocity_average_ = 0.0;
    double velocity_max_ = 0.0;
    double velocity_excess_ = 0.0;
    double rate_average_ = 0.0;
};

}  // namespace bioprint
