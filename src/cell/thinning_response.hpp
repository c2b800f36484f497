#pragma once

#include <array>
#include <cstddef>

/// How a shear-thinning ink resists the flow a cell causes in it.
///
/// A sphere whose inside moves with the rate d in an ink moving with the rate e bears the stress 2η e + 3η (e
/// − d) when the ink is Newtonian: the first part is the undisturbed stress, the second the traction of the
/// disturbance. In a thinning ink the disturbance meets the viscosity of the rates that it makes itself. From
/// the power of its tractions, with the Newtonian disturbance field ε' as the trial field (exact to first
/// order in the thinning),
///
///   η_b ∫ 2 ε':ε' dV = ∫ 2 [η(|e+ε'|) (e+ε') − η(|e|) e] : ε' dV        over the ink outside the sphere
///
/// and the disturbance part is taken with η_b instead of η. Nothing is fitted. For the Cross law η_b = η_inf
/// + (η0 − η_inf) c_b, and c_b is tabulated over the ratio of e to d − e and the size of both, once for each
/// α. The field is that of uniaxial elongation; for other flows the sizes of the two tensors are used.
///
/// Accuracy of the table against the integral: 8e-3 α, 4e-2 α for ink nearly at rest around the cell;
/// (K γ̇)^α up to 30, above which the ratio to the undisturbed viscosity is kept
/// (tests/verify/thinning_response.cpp). Cost: 10 µs to build, 0.1 µs a call.
namespace bioprint {

class ThinningResponse {
  public:
    /// @param alpha          exponent of the Cross law, ≥ 0
    /// @param time_constant  K [s], > 0
    ThinningResponse(double alpha, double time_constant);

    /// c_b: what takes the place of 1/(1 + (K γ̇)^α).
    /// @param elongation   size of e as an elongation rate, e = size·diag(1, −½, −½) [1/s]
    /// @param disturbance  size of d − e in the same measure; its sign says whether the cell runs ahead of
    /// the ink
    [[nodiscard]] double operator()(double elongation, double disturbance) const;

    /// η_b over the viscosity at the rate √3·sqrt(elongation² + disturbance²), for any ink that thins there with
    /// the local exponent level·α, as a Cross ink of (K γ̇)^α = level/(1 − level) does. 1 where nothing moves.
    /// @param level  0 on the plateau to 1 in the power law
    [[nodiscard]] double relative(double elongation, double disturbance, double level) const;

    /// The same by the integral itself.
    [[nodiscard]] double integral(double elongation, double disturbance) const;

  private:
    [[nodiscard]] double ratio(double angle, double level) const;

    static constexpr std::size_t angles = 16;
    static constexpr std::size_t levels = 6;
    double alpha_;
    double time_constant_;
    std::array<std::array<double, angles>, levels> series_{};  ///< Chebyshev
};

}  // namespace bioprint
