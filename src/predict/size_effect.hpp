#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "bioprint/predict/exit_passage.hpp"
#include "cell/planar_cell.hpp"

/// What the cell's own size does to its stress on and off the axis.
///
/// On the axis exit_passage.hpp knows it. Its difference to the passage of a cell without size is taken off
/// the axis in two parts, so that at offset zero the passage on the axis is met exactly:
///
///   · the uniform part of the strain: the logarithm δ(x) by which the size changes the stretch along the
///     axis, weighted by the share of the ink's rate at the place that is elongation;
///   · the part linear in position, of mean von Mises stress L. In the nozzle the ink's stress is −G r/2 in
///     every ink and at every offset, so its gradient is the same everywhere and L is the bullet's; at the
///     exit L(x) is what the passage on the axis has beyond its uniform part, L² = total² − uniform²;
///   · the slip, by which the cell stays behind the ink at its centre: the same at every offset, as it is in
///     a Newtonian ink, but never more than a fifth of the velocity.
///
/// The volume average of uniform part u and linear part is taken as
///
///   sqrt(u² + L² (1 − ½ χ u²/(u² + L²)))       χ: the part of u² that is shear in the plane of x and r
///
/// because half of the linear field lies along that shear and cancels to first order. Within 2 % of the
/// average itself.                                                       tests/verify/size_effect.cpp
namespace bioprint {

/// The volume average of the von Mises stress of a uniform and a linear part. A negative linear part is taken off: a
/// cell bent in the nozzle bears a little less than its stretch says.
double combined_stress(double uniform, double linear, double shear_part);

class SizeEffect {
  public:
    /// A cell without size.
    SizeEffect() = default;
    /// @throws UsageError, NotConverged  as exit_passage
    SizeEffect(const NozzleFlow& flow, const AxisCell& cell);

    /// The passage on the axis it was taken from.
    [[nodiscard]] const std::optional<ExitPassage>& axis() const { return axis_; }
    /// Whether the cell keeps a shape in the nozzle.
    [[nodiscard]] bool keeps_shape() const { return keeps_shape_; }

    /// L in the nozzle [Pa].
    [[nodiscard]] double nozzle_linear() const { return nozzle_linear_; }
    /// How far the cell stays behind the ink there [m/s].
    [[nodiscard]] double nozzle_slip() const { return value_.front().slip; }

    struct Effect {
        double log_stretch;  ///< δ
        double linear;       ///< L [Pa]
        double slip;         ///< [m/s]
    };
    /// At x from the lip [m].
    [[nodiscard]] Effect at(double x) const;

    /// The velocity of a cell in an ink of this velocity [m/s].
    [[nodiscard]] static double velocity(double ink, double slip) { return ink - std::min(slip, 0.2 * ink); }

    /// The strain of a cell that is longer along the axis by λ, from λ² − 1, and as much thinner.
    [[nodiscard]] static PlanarStrain lengthened(const PlanarStrain& strain, double square_stretch);

  private:
    static constexpr std::size_t knots = 139;  // 12 a radius
    std::array<Effect, knots> value_{};
    double first_ = 0.0;
    double step_ = 0.0;
    double nozzle_linear_ = 0.0;
    bool keeps_shape_ = true;
    std::optional<ExitPassage> axis_;
};

}  // namespace bioprint
