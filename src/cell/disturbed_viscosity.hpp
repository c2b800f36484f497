#pragma once

#include <optional>

#include "bioprint/rheology/ink.hpp"
#include "cell/thinning_response.hpp"

/// The viscosity that a cell's disturbance meets in an ink of any law (thinning_response.hpp).
///
/// η_b is linear in the ink's viscosity, so each part of a law adds its own: the Newtonian part itself, a part that
/// thins as γ̇^−α the tabulated ratio at its local exponent.
///
///   Cross             η_inf + (η0 − η_inf) c_b(α)
///   Carreau-Yasuda    α = 1 − n, level (Kγ̇)^a/(1 + (Kγ̇)^a): the local exponent is exact, how it changes over the rates
///                     about the cell is that of the Cross law; the same law where a = 1 − n
///   power law         α = 1 − n, level 1
///   Herschel-Bulkley  the power law, and the yield stress as a part of α = 1, level 1
///
/// An ink that does not thin (n ≥ 1) is taken at its viscosity.
namespace bioprint {

class DisturbedViscosity {
  public:
    /// @param least_rate  rates below it count as it [1/s]; above zero for an ink without a viscosity at rest
    DisturbedViscosity(const Ink& ink, double least_rate);

    /// Whether the viscosity is the same at every rate.
    [[nodiscard]] bool newtonian() const { return newtonian_; }

    /// η_b [Pa s]; the arguments are those of ThinningResponse.
    [[nodiscard]] double operator()(double elongation, double disturbance) const;

  private:
    Ink ink_;
    double least_rate_;
    bool newtonian_ = false;
    std::optional<ThinningResponse> thinning_;
    std::optional<ThinningResponse> yielding_;
};

}  // namespace bioprint
