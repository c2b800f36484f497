#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "bioprint/io/number_format.hpp"
#include "io/fit_answer.hpp"

// What a fit cannot know, said before it is used.

namespace bioprint {
namespace {

/// Differences of AICc from which on a law is practically ruled out (Burnham and Anderson 2002, section 2.6).
constexpr double ruled_out = 10.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool open(const LawFit& fit, std::string_view name) {
    const FittedParameter* const p = fit.find(name);
    return p != nullptr && !p->determined;
}

/// With no thinning a constant viscosity says all the data say.
bool no_thinning(const FitAnswer& answer) {
    const LawFit* const constant = answer.fit.find({FittedLaw::newtonian, false});
    return constant != nullptr && constant->aicc && answer.chosen.aicc &&
           *constant->aicc <= *answer.chosen.aicc + 2.0;
}

/// Whether another law is so much better that this one's parameters mean little.
bool ruled_out_by_best(const FitAnswer& answer) {
    const LawFit& fit = answer.chosen;
    const LawFit& best = answer.fit.laws.front();
    return fit.aicc && best.aicc && *fit.aicc - *best.aicc > ruled_out && best.scatter < 0.95 * fit.scatter;
}

/// Why the bend of a law is not determined, and what helps.
std::string cause(const FitAnswer& answer) {
    constexpr double hardly_thinned = 0.2;  // of the largest viscosity, at the end of the points
    constexpr double large_scatter = 0.1;
    if (ruled_out_by_best(answer)) {
        return "this law does not describe the points, which scatter by " +
               percent_text(answer.chosen.scatter) + " around it; fit the one that does";
    }
    double low = infinity;
    double high = 0.0;
    for (const FitPoint& p : answer.points) {
        if (!p.used) continue;
        low = std::min(low, p.fitted);
        high = std::max(high, p.fitted);
    }
    if (low > hardly_thinned * high) {
        return "too little of the thinning branch is measured; measure at higher rates, or fit a law of "
               "fewer "
               "parameters";
    }
    if (answer.chosen.scatter > large_scatter) {
        return "the points scatter by " + percent_text(answer.chosen.scatter) +
               ", too much to tell; measure again, and more points";
    }
    return "within the scatter of " + percent_text(answer.chosen.scatter) +
           " one can stand in for another; measure more points around the bend, or fit a law of fewer "
           "parameters";
}

/// The flow index of the power law where the viscosity rises with the rate, beyond doubt.
std::optional<double> thickening(const FitAnswer& answer) {
    const LawFit* const power = answer.fit.find({FittedLaw::power_law, false});
    const LawFit* const constant = answer.fit.find({FittedLaw::newtonian, false});
    if (power == nullptr || constant == nullptr || !power->aicc || !constant->aicc) return {};
    const FittedParameter& index = *power->find("flow_index");
    if (index.low <= 1.0 || *power->aicc > *constant->aicc - 2.0) return {};
    return index.value;
}

bool can_thicken(FittedLaw law) {
    return law == FittedLaw::power_law || law == FittedLaw::herschel_bulkley;
}

Warning undetermined(const FitAnswer& answer, std::vector<std::string>& named) {
    const LawFit& fit = answer.chosen;
    const bool plateau = fit.choice.law == FittedLaw::cross || fit.choice.law == FittedLaw::carreau_yasuda;
    double highest = 0.0;
    for (const FitPoint& p : answer.points) {
        if (p.used) highest = std::max(highest, p.measured);
    }
    if (plateau && open(fit, "eta0") && open(fit, "time_constant")) {
        named = {"eta0", "time_constant"};
        std::string text = "no plateau at low shear rates: eta0 and K are not determined one by one";
        if (fit.choice.law == FittedLaw::cross && !open(fit, "alpha")) {
            const CrossConsistency m = cross_consistency(fit);
            text += ", only eta0/K^alpha = " + bare_text(m.value, 4);
            if (std::isfinite(m.standard_error)) text += " ± " + bare_text(m.standard_error, 2);
            text += " Pa s^(1-alpha)";
        }
        text += "; eta0 is at least the " + lab_text(highest, Dimension::viscosity, 3) +
                " measured. Within " + bare_text(answer.rate_low, 3) + " to " +
                bare_text(answer.rate_high, 3) +
                " 1/s any such pair gives the same viscosity; measure at lower rates, or use --law power-law";
        return {.code = "no_plateau", .message = text};
    }
    if (plateau && (open(fit, "time_constant") || open(fit, "alpha") || open(fit, "transition"))) {
        std::string list;
        for (const auto& [name, shown] : {std::pair{"eta0", "eta0"},
                                          {"time_constant", "K"},
                                          {"alpha", "alpha"},
                                          {"transition", "a"},
                                          {"flow_index", "n"}}) {
            if (!open(fit, name)) continue;
            named.emplace_back(name);
            list += (list.empty() ? "" : ", ") + std::string(shown);
        }
        return {.code = "not_determined",
                .message = "the data do not determine " + list + ": " + cause(answer)};
    }
    return {};
}

void add_undetermined(const FitAnswer& answer, std::vector<Warning>& warnings) {
    const LawFit& fit = answer.chosen;
    std::vector<std::string> named;
    if (const std::optional<double> index = thickening(answer); index && !can_thicken(fit.choice.law)) {
        warnings.push_back(
            {.code = "thickening",
             .message = "the ink thickens: its viscosity rises with the shear rate (by the power law n = " +
                        bare_text(*index, 3) + "), which the " + std::string(law_name(fit.choice.law)) +
                        " law cannot; use --law power-law"});
        return;
    }
    if (fit.choice.law != FittedLaw::newtonian && no_thinning(answer)) {
        const LawFit& constant = *answer.fit.find({FittedLaw::newtonian, false});
        const FittedParameter& eta = constant.parameters.front();
        warnings.push_back({.code = "no_thinning",
                            .message = "no thinning within the scatter: the ink is Newtonian between " +
                                       bare_text(answer.rate_low, 3) + " and " +
                                       bare_text(answer.rate_high, 3) + " 1/s, " +
                                       lab_text(eta.value, Dimension::viscosity, 3) + " ± " +
                                       lab_text(eta.standard_error, Dimension::viscosity, 3) +
                                       "; what thins is not determined, use --law newtonian"});
        return;
    }
    if (Warning warning = undetermined(answer, named); !warning.code.empty()) {
        warnings.push_back(std::move(warning));
    }
    const std::map<std::string_view, std::string_view> reasons = {
        {"eta_inf", "eta_inf is not determined: the viscosity does not level off at high rates; leave it 0"},
        {"yield_stress",
         "the yield stress is not determined: the stress does not level off at low rates; use --law "
         "power-law"},
        {"flow_index", "the flow index is not determined: the stress hardly rises with the rate"}};
    for (const FittedParameter& p : fit.parameters) {
        if (p.determined || std::find(named.begin(), named.end(), p.name) != named.end()) continue;
        const auto reason = reasons.find(p.name);
        warnings.push_back({.code = "not_determined",
                            .message = reason != reasons.end()
                                           ? std::string(reason->second)
                                           : "the data do not determine " + std::string(p.name)});
    }
}

/// Intervals whose points lie on different curves: thixotropy, slip, a sample that dried.
void add_interval_difference(const FitAnswer& answer, std::vector<Warning>& warnings) {
    struct Sum {
        double residual = 0.0;
        double count = 0.0;
    };
    std::map<std::size_t, Sum> sums;
    for (const FitPoint& p : answer.points) {
        if (!p.used) continue;
        sums[p.interval].residual += p.residual();
        sums[p.interval].count += 1.0;
    }
    if (sums.size() < 2) return;
    const auto mean = [](const auto& entry) { return entry.second.residual / entry.second.count; };
    const auto [low, high] = std::minmax_element(
        sums.begin(), sums.end(), [&](const auto& a, const auto& b) { return mean(a) < mean(b); });
    const double difference = std::exp(mean(*high) - mean(*low)) - 1.0;
    const double noise = answer.chosen.scatter / std::sqrt(std::min(low->second.count, high->second.count));
    if (difference < 0.05 || difference < 3.0 * noise) return;
    warnings.push_back(
        {.code = "intervals_differ",
         .message = "the viscosity of interval " + std::to_string(high->first) + " lies " +
                    percent_text(difference) + " above that of interval " + std::to_string(low->first) +
                    " (thixotropy, slip or drying?); fit the one that fits the print with --interval"});
}

}  // namespace

std::vector<Warning> fit_warnings(const FitAnswer& answer) {
    std::vector<Warning> warnings;
    for (const std::string& remark : answer.data.remarks)
        warnings.push_back({.code = "data", .message = remark});
    const LawFit& fit = answer.chosen;
    if (!answer.question.law && !fit.aicc) {
        warnings.push_back(
            {.code = "not_compared",
             .message = std::to_string(answer.fit.points_used) +
                        " points are too few to choose a law: this is the Cross law, as without "
                        "--law; measure more shear rates, or name another with --law"});
    }
    add_undetermined(answer, warnings);
    const LawFit& best = answer.fit.laws.front();
    if (ruled_out_by_best(answer)) {
        warnings.push_back({.code = "other_law",
                            .message = "the " + std::string(law_name(best.choice.law)) + " law" +
                                       (best.choice.fit_eta_inf ? " with eta_inf" : "") +
                                       " describes these points better: scatter " +
                                       percent_text(best.scatter) + " instead of " +
                                       percent_text(fit.scatter) + "; see the comparison, --law " +
                                       std::string(law_name(best.choice.law)) +
                                       (best.choice.fit_eta_inf ? " --eta-inf fit" : "")});
    }
    const auto lowest = std::min_element(
        answer.points.begin(), answer.points.end(), [](const FitPoint& a, const FitPoint& b) {
            return (a.used ? a.measured : infinity) < (b.used ? b.measured : infinity);
        });
    if (!fit.choice.fit_eta_inf && lowest != answer.points.end() && fit.eta_inf > lowest->measured) {
        warnings.push_back({.code = "eta_inf_above_points",
                            .message = "eta_inf is held at " + lab_text(fit.eta_inf, Dimension::viscosity) +
                                       ", above the lowest viscosity measured, " +
                                       lab_text(lowest->measured, Dimension::viscosity, 3) +
                                       ": the law cannot reach those points; give less, or --eta-inf fit"});
    }
    const auto n = static_cast<double>(answer.fit.points_used);
    // Scattered residuals correlate by 1/sqrt(n) by chance; three times that is no chance.
    if (n >= 8 && fit.scatter > 0.002 && fit.neighbour_correlation > std::max(0.5, 3.0 / std::sqrt(n))) {
        warnings.push_back(
            {.code = "systematic",
             .message = "the points leave the law's curve systematically (neighbours correlate by " +
                        bare_text(fit.neighbour_correlation, 2) +
                        "): the law does not quite fit, and the errors given are too small"});
    }
    if (n < 8 || answer.rate_high < 30.0 * answer.rate_low) {
        warnings.push_back({.code = "few_points",
                            .message = std::to_string(answer.fit.points_used) + " points over " +
                                       bare_text(std::log10(answer.rate_high / answer.rate_low), 2) +
                                       " decades of shear rate: the law outside is a guess"});
    }
    if (answer.fit.outliers_kept) {
        warnings.push_back(
            {.code = "scattered",
             .message = "more than 30 % of the points lie far from any curve: none was left out"});
    }
    const FittedParameter* const alpha = fit.find("alpha");
    if (alpha != nullptr && alpha->value > 1.0 && fit.choice.law == FittedLaw::cross && fit.eta_inf == 0.0) {
        warnings.push_back(
            {.code = "stress_maximum",
             .message = "alpha is above 1: the stress falls at high rates, and past its maximum there is no "
                        "steady flow"});
    }
    if (const std::string problem = not_predicted(fit); !problem.empty()) {
        warnings.push_back({.code = "not_predicted",
                            .message = "no prediction takes this ink: " + problem + "; fit another law"});
    }
    add_interval_difference(answer, warnings);
    return warnings;
}

}  // namespace bioprint
