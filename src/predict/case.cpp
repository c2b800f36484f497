#include "bioprint/predict/case.hpp"

#include <cmath>
#include <string_view>

#include "numerics/brief.hpp"

namespace bioprint {
namespace {

/// Suspensions that thicken reach 2; a sharper bend than this no rheometer tells from a corner.
constexpr double most_thickening = 2.0;
constexpr double sharpest_transition = 100.0;

/// Collects one sentence for each quantity out of its range.
class Findings {
  public:
    void require(bool holds, std::string_view name, double value, std::string_view remedy) {
        if (holds && std::isfinite(value)) return;
        sentences_.push_back(std::string(name) + ": got " + brief(value, 6) + "; it must be " +
                             std::string(remedy));
    }
    void add(std::string sentence) { sentences_.push_back(std::move(sentence)); }
    std::vector<std::string> take() { return std::move(sentences_); }
    [[nodiscard]] bool empty() const { return sentences_.empty(); }

  private:
    std::vector<std::string> sentences_;
};

void check_law(const CrossInk& law, Findings& findings) {
    findings.require(law.eta0 > 0.0, "eta0", law.eta0, "positive, such as 10Pa.s");
    findings.require(law.eta_inf >= 0.0 && law.eta_inf <= law.eta0, "eta-inf", law.eta_inf,
                     "between 0 and eta0");
    findings.require(law.time_constant > 0.0, "time-constant", law.time_constant,
                     "positive, such as 0.05s (for a Newtonian ink of viscosity v use alpha 0 and eta0 2v)");
    findings.require(law.alpha >= 0.0, "alpha", law.alpha, "zero or positive, such as 0.75");
}

void check_consistency(double consistency, double flow_index, Findings& findings) {
    findings.require(consistency > 0.0, "consistency", consistency, "positive, such as 10Pa.s^n");
    findings.require(flow_index > 0.0 && flow_index <= most_thickening, "flow-index", flow_index,
                     "above 0 and at most 2, such as 0.4");
}

void check_law(const PowerLawInk& law, Findings& findings) {
    check_consistency(law.consistency, law.flow_index, findings);
}

void check_law(const CarreauYasudaInk& law, Findings& findings) {
    findings.require(law.eta0 > 0.0, "eta0", law.eta0, "positive, such as 10Pa.s");
    findings.require(law.eta_inf >= 0.0 && law.eta_inf <= law.eta0, "eta-inf", law.eta_inf,
                     "between 0 and eta0");
    findings.require(law.time_constant > 0.0, "time-constant", law.time_constant, "positive, such as 0.05s");
    findings.require(law.transition > 0.0 && law.transition <= sharpest_transition, "transition",
                     law.transition, "above 0 and at most 100, such as 2");
    findings.require(law.flow_index >= 0.0 && law.flow_index <= 1.0, "flow-index", law.flow_index,
                     "between 0 and 1, such as 0.4");
}

void check_law(const HerschelBulkleyInk& law, Findings& findings) {
    findings.require(law.yield_stress >= 0.0, "yield-stress", law.yield_stress,
                     "zero or positive, such as 30Pa");
    check_consistency(law.consistency, law.flow_index, findings);
}

std::string_view drive_name(Drive drive) {
    switch (drive) {
        case Drive::flow_rate:
            return "flowrate";
        case Drive::velocity:
            return "velocity";
        case Drive::pressure_gradient:
            return "pressure-gradient";
        case Drive::pressure:
            return "pressure";
    }
    return "";
}

void check_positions(const Case& question, Findings& findings) {
    for (const CellPosition& position : question.positions) {
        findings.require(position.value >= 0.0, "offset", position.value, "zero or positive");
        if (!(position.value >= 0.0) || !std::isfinite(position.value)) continue;
        const double r = position.in_cell_radii ? position.value * question.cell.radius : position.value;
        // The touching position is allowed, however it was rounded.
        if (r + question.cell.radius > question.radius * (1.0 + 1e-12)) {
            findings.add("offset: a cell of radius " + brief(question.cell.radius) + " m at " + brief(r) +
                         " m from the axis does not fit a nozzle of radius " + brief(question.radius) +
                         " m; its centre may be at most " + brief(question.radius - question.cell.radius) +
                         " m off");
        }
    }
}

}  // namespace

std::vector<std::string> problems_of(const Ink& ink) {
    Findings findings;
    std::visit([&](const auto& law) { check_law(law, findings); }, ink);
    return findings.take();
}

std::vector<std::string> problems_of(const Case& question) {
    Findings findings;
    const CellChoice& cell = question.cell;
    findings.require(question.radius > 0.0, "radius", question.radius, "positive, such as 50um");
    if (question.length)
        findings.require(*question.length > 0.0, "length", *question.length, "positive, such as 12.7mm");
    findings.require(question.drive_value >= 0.0, drive_name(question.drive), question.drive_value,
                     "zero or positive");
    if (question.drive == Drive::pressure && !question.length) {
        findings.add("pressure: drives the flow only together with the nozzle's length; add --length");
    }
    std::visit([&](const auto& law) { check_law(law, findings); }, question.ink.law);
    findings.require(cell.radius > 0.0, "cell-radius", cell.radius, "positive, such as 8um");
    findings.require(cell.shear_modulus > 0.0, "shear-modulus", cell.shear_modulus, "positive, such as 1kPa");
    findings.require(cell.viscosity_ratio >= 0.0, "viscosity-ratio", cell.viscosity_ratio,
                     "zero or positive");
    findings.require(cell.poisson_ratio > -1.0 && cell.poisson_ratio < 0.5, "poisson-ratio",
                     cell.poisson_ratio, "above -1 and below 0.5, such as 0.48");
    for (const double threshold : question.thresholds) {
        findings.require(threshold >= 0.0, "threshold", threshold, "zero or positive, such as 2kPa");
    }
    if (question.profile_points != 0) {
        findings.require(question.profile_points >= 2 && question.profile_points <= 1000000, "profile",
                         question.profile_points, "between 2 and 1000000 points");
    }
    if (findings.empty()) {
        if (cell.radius > question.radius) {
            findings.add("cell-radius: a cell of radius " + brief(cell.radius) +
                         " m does not fit a nozzle of radius " + brief(question.radius) +
                         " m; use a wider nozzle");
        } else {
            check_positions(question, findings);
        }
    }
    return findings.take();
}

}  // namespace bioprint
