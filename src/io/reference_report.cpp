#include "io/reference_report.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/flow/flow_check.hpp"
#include "bioprint/io/number_format.hpp"
#include "bioprint/predict/prediction.hpp"

namespace bioprint {
namespace {

std::string brief(double value) {
    return format_lab(value, Dimension::dimensionless, 2).number;
}

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
        brief(relative(prediction.nozzle.velocity_average, check.velocity_average)) + ", u_max - u_avg by " +
        brief(relative(flow.velocity_excess(), check.velocity_excess)) +
        " (relative); the quadrature's own error estimate is " + brief(check.relative_error) + "\n";
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.model != Model::roscoe_shear || flow.shear_rate(cell.offset) == 0.0) continue;
        const ShearLoad load{.fluid_stress = cell.fluid_stress,
                             .shear_rate = flow.shear_rate(cell.offset),
                             .shear_modulus = question.cell.shear_modulus,
                             .viscosity_ratio = question.cell.viscosity_ratio};
        const ShearResidual residual = shear_residual(load, roscoe_shear(load));
        report +=
            "cell at " + brief(cell.offset * 1e6) + " um: Roscoe's equations hold to " +
            brief(std::max({std::abs(residual.shape), std::abs(residual.torque), std::abs(residual.load)})) +
            "; the quadrature's own error estimate is " + brief(residual.quadrature_error) + "\n";
    }
    return report;
}

}  // namespace bioprint
