#pragma once

#include "bioprint/rheology/ink.hpp"

/// Steady, fully developed flow of an ink through a long cylinder (no inertia, no slip at the wall).
///
/// The stress is linear in the radius, τ(r) = G r/2, so the rate of strain is the natural variable of the
/// profile: with q = τ/τ_w (w: wall),
///
///   u_avg = R/3 ∫ (1 − q³) dγ̇          u_max         = R   ∫ (1 − q) dγ̇
///   γ̇_avg =     ∫ (1 − q²) dγ̇          u_max − u_avg = R/3 ∫ (1 − q)² (2 + q) dγ̇        γ̇ from 0 to γ̇_w
///
/// Every integrand is positive, so even u_max − u_avg, on which the exit elongation rests, keeps full
/// relative accuracy for inks that flow almost as a plug.
///
/// The same integrals serve an ink with a yield stress: where τ ≤ τ_y, inside the plug of radius R τ_y/τ_w, the rate is
/// zero and adds nothing.
///
/// Accuracy: 1e-11 relative. Cross: K·rate from 1e-12 to 1e12, α from 0 to 1 (tests/verify/nozzle_flow.cpp);
/// Carreau-Yasuda: the same range, flow index 0 to 1, transition 0.2 to 20; power law and Herschel-Bulkley: closed
/// forms, rates and φ/(1−φ) from 1e-12 to 1e12 (tests/verify/nozzle_laws.cpp).
/// Cost: about 5 µs; 0.1 to 1 ms for Carreau-Yasuda.
/// Source: Müller, Bächer, Gekle, Phys. Fluids 2020 (the profile); the positive forms are this project's.
namespace bioprint {

class NozzleFlow {
  public:
    /// Each drives the flow by one quantity; radius [m] > 0.
    /// @throws NoSteadyFlow  past the stress maximum of a Cross ink with α > 1, past the saturation at α = 1, or with a
    ///                       pressure gradient below which an ink with a yield stress does not flow
    static NozzleFlow from_flow_rate(const Ink& ink, double radius, double flow_rate);         // [m³/s]
    static NozzleFlow from_velocity(const Ink& ink, double radius, double velocity_average);   // [m/s]
    static NozzleFlow from_pressure_gradient(const Ink& ink, double radius, double gradient);  // [Pa/m]

    /// Driven by the rate of strain at the wall [1/s], ≥ 0: the one that needs no root.
    static NozzleFlow from_wall_rate(const Ink& ink, double radius, double rate);

    [[nodiscard]] const Ink& ink() const { return ink_; }
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

    /// The radius within which the ink is not sheared [m]: R τ_y/τ_w, 0 without a yield stress, R at rest.
    [[nodiscard]] double plug_radius() const;

    /// Profiles at a radial position r [m], 0 ≤ r ≤ R.
    [[nodiscard]] double stress(double r) const { return wall_stress_ * (r / radius_); }  ///< [Pa]
    [[nodiscard]] double shear_rate(double r) const;                                      ///< [1/s]
    [[nodiscard]] double velocity(double r) const;                                        ///< [m/s]

  private:
    NozzleFlow(const Ink& ink, double radius, double wall_rate);
    Ink ink_;
    double radius_;
    double wall_rate_ = 0.0;
    double wall_stress_ = 0.0;
    double velocity_average_ = 0.0;
    double velocity_max_ = 0.0;
    double velocity_excess_ = 0.0;
    double rate_average_ = 0.0;
};

}  // namespace bioprint
