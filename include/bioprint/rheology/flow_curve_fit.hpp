#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Parameters of a viscosity law from a measured flow curve.
///
///   Newtonian         η = η0
///   power law         η = k γ̇^(n−1)
///   Cross             η = η∞ + (η0 − η∞) / (1 + (K γ̇)^α)
///   Carreau-Yasuda    η = η∞ + (η0 − η∞) (1 + (λ γ̇)^a)^((n−1)/a)
///   Herschel-Bulkley  η = τ0/γ̇ + k γ̇^(n−1)
///
/// Least squares of ln η over ln γ̇: a rheometer's error is relative, and a curve spans decades. Every law starts from a
/// grid over its parameters, so that the minimum does not depend on a guess. Outliers are found by robust fits of all
/// laws and left out of each, so that the laws are compared over the same points (AICc). Standard errors come from the
/// scatter of the points themselves; the intervals are Student's, in the logarithm of a parameter.
///
/// Degenerate cases are named, not hidden: without a plateau η0 and K are known only as η0/K^α; without thinning K and
/// α are not known at all. Such a parameter has `determined` false.
///
/// Accuracy: exact curves are recovered to 1e-8; of noisy ones the intervals hold the truth as often as they say.
/// tests/unit/rheology/flow_curve_fit.cpp, tests/verify/fit_coverage.cpp
namespace bioprint {

struct FlowPoint {
    double rate;          ///< γ̇ [1/s], > 0
    double viscosity;     ///< η [Pa s], > 0
    double weight = 1.0;  ///< as many points of this relative error as this one stands for
};

enum class FittedLaw { newtonian, power_law, cross, carreau_yasuda, herschel_bulkley };
std::string_view law_name(FittedLaw law);

/// A law, and whether its viscosity at infinite rate is fitted too.
struct LawChoice {
    FittedLaw law = FittedLaw::cross;
    bool fit_eta_inf = false;
    bool operator==(const LawChoice&) const = default;
};

struct FittedParameter {
    std::string_view name;  ///< "eta0", "time_constant", …: as a preset calls it
    double value;           ///< SI
    double standard_error;  ///< SI; infinite when the data say nothing
    double low;             ///< of the 95 % interval
    double high;
    bool determined;  ///< the interval spans less than a factor of 7
};

/// One law fitted to the points in use.
struct LawFit {
    LawChoice choice;
    double eta_inf;  ///< held, or fitted [Pa s]; 0 for a law without
    std::vector<FittedParameter> parameters;
    /// By rows, of the logarithms; of Carreau-Yasuda's n of −ln(1 − n), which grows with it. Not finite entries are 0.
    std::vector<double> correlation;
    std::vector<double> fitted;  ///< η at every point, used or not [Pa s]
    double scatter;              ///< standard deviation of ln η: the relative error of a point
    double rms;                  ///< root mean square of ln η
    double aic;
    std::optional<double> aicc;  ///< none for too few points
    /// Of the residuals of neighbours in rate; near 0 for scatter, towards 1 where the law bends otherwise.
    double neighbour_correlation;
    bool converged;

    [[nodiscard]] const FittedParameter* find(std::string_view name) const;
};

struct FlowCurveFitOptions {
    double eta_inf = 0.0;  ///< held where it is not fitted [Pa s]
    /// Largest share of the points that may be outliers; with more, none is dropped.
    double outlier_share = 0.3;
};

struct FlowCurveFit {
    std::vector<LawFit> laws;    ///< best first by AICc; those with too few points left out
    std::vector<bool> used;      ///< per point; false: an outlier
    bool outliers_kept = false;  ///< there were too many to be called so
    std::size_t points_used = 0;

    [[nodiscard]] const LawFit* find(LawChoice choice) const;
};

/// @param points  in any order; at least 3 different rates
/// @throws UsageError  too few points or rates for any law, or a value that is not positive and finite
FlowCurveFit fit_flow_curve(std::span<const FlowPoint> points, const FlowCurveFitOptions& options = {});

/// η0/K^α of a Cross fit, what remains known without a plateau: the viscosity at 1/s of the power law behind it.
struct CrossConsistency {
    double value;           ///< [Pa s^(1−α)]
    double standard_error;  ///< the same
};
CrossConsistency cross_consistency(const LawFit& cross);

}  // namespace bioprint
