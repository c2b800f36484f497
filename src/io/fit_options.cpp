#include <array>
#include <utility>

#include "bioprint/io/number_format.hpp"
#include "io/fit_answer.hpp"

// The ink of a fit in the words of the command line.

namespace bioprint {
namespace {

std::string option(std::string_view name, double value, std::string_view unit) {
    return std::string(name) + " " + format_shortest(fit_rounded(value)) +
           (unit == "1" ? std::string{} : std::string(unit));
}

/// In the order in which --help lists them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> names = {
    {{"eta0", "--eta0"},
     {"eta_inf", "--eta-inf"},
     {"time_constant", "-K"},
     {"alpha", "--alpha"},
     {"transition", "--transition"},
     {"yield_stress", "--yield-stress"},
     {"consistency", "--consistency"},
     {"flow_index", "--flow-index"}}};

}  // namespace

Ink fitted_ink(const LawFit& fit) {
    const auto value = [&](std::string_view name) {
        const FittedParameter* const parameter = fit.find(name);
        return parameter != nullptr ? fit_rounded(parameter->value) : 0.0;
    };
    const double eta_inf = fit.find("eta_inf") != nullptr ? value("eta_inf") : fit.eta_inf;
    switch (fit.choice.law) {
        case FittedLaw::power_law:
            return PowerLawInk{.consistency = value("consistency"), .flow_index = value("flow_index")};
        case FittedLaw::carreau_yasuda:
            return CarreauYasudaInk{.eta0 = value("eta0"),
                                    .eta_inf = eta_inf,
                                    .time_constant = value("time_constant"),
                                    .transition = value("transition"),
                                    .flow_index = value("flow_index")};
        case FittedLaw::herschel_bulkley:
            return HerschelBulkleyInk{.yield_stress = value("yield_stress"),
                                      .consistency = value("consistency"),
                                      .flow_index = value("flow_index")};
        case FittedLaw::newtonian:
            return CrossInk{.eta0 = 2.0 * value("eta0"), .time_constant = 1.0, .alpha = 0.0};
        case FittedLaw::cross:
            break;
    }
    return CrossInk{.eta0 = value("eta0"),
                    .eta_inf = eta_inf,
                    .time_constant = value("time_constant"),
                    .alpha = value("alpha")};
}

std::string fit_options_line(const FitAnswer& answer) {
    const LawFit& fit = answer.chosen;
    if (fit.choice.law == FittedLaw::newtonian) {
        return option("--eta0", 2.0 * fit.parameters.front().value, "Pa.s") + " --alpha 0";
    }
    // The Cross law is that of the ink taken by default, all of whose parameters stand here.
    std::string line =
        fit.choice.law == FittedLaw::cross ? "" : "--law " + std::string(law_name(fit.choice.law));
    for (const auto& [name, written] : names) {
        const FittedParameter* const parameter = fit.find(name);
        const bool held = name == "eta_inf" && fit.eta_inf > 0.0;
        if (parameter == nullptr && !held) continue;
        line += (line.empty() ? "" : " ") +
                option(written, parameter != nullptr ? parameter->value : fit.eta_inf, fit_unit(name));
    }
    return line;
}

}  // namespace bioprint
