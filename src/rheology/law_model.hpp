#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "bioprint/rheology/flow_curve_fit.hpp"

/// The laws as functions for a fit: ln η over L = ln γ̇ with unbounded parameters θ.
///
/// θ are logarithms, of η0 − η∞, K, α, λ, a, 1 − n (Carreau-Yasuda), k, n, τ0 and, where it is fitted, η∞ (last). Every
/// formula is evaluated without overflow.
namespace bioprint {

inline constexpr std::size_t most_law_parameters = 5;

struct LawValue {
    double log_viscosity;
    std::array<double, most_law_parameters> gradient;  ///< ∂ln η/∂θ
};

/// How a parameter of the law follows from θ: ln p, and for a Carreau-Yasuda index ln(1 − n).
struct ParameterShape {
    std::string_view name;
    bool complement = false;  ///< the value is 1 − exp(θ)
};

class LawModel {
  public:
    LawModel(LawChoice choice, double eta_inf) : choice_(choice), eta_inf_(eta_inf) {}
    [[nodiscard]] const LawChoice& choice() const { return choice_; }
    [[nodiscard]] std::span<const ParameterShape> shapes() const;
    [[nodiscard]] std::size_t parameters() const { return shapes().size(); }

    [[nodiscard]] LawValue at(std::span<const double> theta, double log_rate) const;

    /// θ outside leads nowhere: past it nothing changes any more, within any data.
    [[nodiscard]] bool allows(std::span<const double> theta, double log_rate_low, double log_rate_high) const;

    /// ln of the reported parameters (ln(1 − n) for an index of Carreau-Yasuda) from θ, and ∂/∂θ by rows.
    void report(std::span<const double> theta, std::span<double> log_values,
                std::span<double> jacobian) const;

    /// Starts over the whole space a curve like this may lie in, the best first.
    [[nodiscard]] std::vector<std::vector<double>> starts(std::span<const FlowPoint> points) const;

  private:
    [[nodiscard]] bool has_plateau() const {
        return choice_.law == FittedLaw::cross || choice_.law == FittedLaw::carreau_yasuda;
    }
    LawChoice choice_;
    double eta_inf_;
};

}  // namespace bioprint
