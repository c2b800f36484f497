#include "io/reference_report.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/flow/flow_check.hpp"
#include "bioprint/io/number_format.hpp"
#include "bioprint/predict/prediction.hpp"

namespace bioprint {
namespace {

double relative(double value, double reference) {
    return reference == 0.0 ? std::abs(value) : std::abs(value / reference - 1.0);
}

}  // namespace

std::string reference_report(const Settings& settings) {
    const Case question = settings.make_case();
    const Prediction prediction = predict(question);
    const NozzleFlow flow =
        NozzleFlow::from_wall_rate(question.ink.law, question.radius, prediction.nozzle.shear_rate_max);
    const FlowCheck check = check_flow(flow);
    std::string report =
        "flow against adaptive quadrature: u_avg differs by " +
        bare_text(relative(prediction.nozzle.velocity_average, check.velocity_average), 2) +
        ", u_max - u_avg by " + bare_text(relative(flow.velocity_excess(), check.velocity_excess), 2) +
        " (relative); the quadrature's own error estimate is " + bare_text(check.relative_error, 2) + "\n";
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.model != Model::roscoe_shear || flow.shear_rate(cell.offset) == 0.0) continue;
        const ShearLoad load{.fluid_stress = cell.fluid_stress,
                             .shear_rate = flow.shear_rate(cell.offset),
                             .shear_modulus = question.cell.shear_modulus,
                             .viscosity_ratio = question.cell.viscosity_ratio};
        const ShearResidual residual = shear_residual(load, roscoe_shear(load));
        report +=
            "cell at " + bare_text(cell.offset * 1e6, 2) + " um: Roscoe's equations hold to " +
            bare_text(
                std::max({std::abs(residual.shape), std::abs(residual.torque), std::abs(residual.load)}), 2) +
            "; the quadrature's own error estimate is " + bare_text(residual.quadrature_error, 2) + "\n";
    }
    return report;
}

}  // namespace bioprint
