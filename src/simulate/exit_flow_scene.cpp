#include <cmath>

#include "simulate/exit_field.hpp"
#include "simulate/pictures.hpp"
#include "simulate/scenes.hpp"

namespace bioprint {
namespace {

/// Far enough from the inflow and from the exit to read the nozzle's own flow, in radii.
constexpr double from_inflow = 0.75;
constexpr double reading_length = 0.5;
constexpr double steady_tolerance = 2e-6;

}  // namespace

void run_exit_flow(const Run& run) {
    const ExitReach reach = exit_reach(run.flow.ink());
    const ExitField field = settle_exit_flow(run.flow, run.nodes, reach, steady_tolerance, run.log);
    const AxisProfile axis = axis_profile(field, run.flow);
    const auto first = static_cast<std::size_t>(std::lround(from_inflow * run.nodes));
    const auto second = first + static_cast<std::size_t>(std::lround(reading_length * run.nodes));
    const double gradient = (axis.pressure[first] - axis.pressure[second]) / (axis.x[second] - axis.x[first]);
    run.log.value("pressure_gradient", gradient);
    run.log.value("velocity_max", axis.velocity[first]);
    run.log.value("radial_velocity_max", largest_radial_velocity(field));
    run.log.value("elongational_stress_peak", axis.peak);
    run.log.value("elongational_stress_average", axis.average);
    run.log.value("excess_pressure", axis.pressure[first] + gradient * axis.x[first]);
    run.log.value("peak_position", axis.peak_position);
    auto& series = run.log.result.series;
    series.columns = {"x [m]", "velocity [m/s]", "elongation_rate [1/s]", "elongational_stress [Pa]",
                      "pressure [Pa]"};
    for (std::size_t i = 0; i < axis.x.size(); ++i) {
        series.rows.push_back({axis.x[i], axis.velocity[i], axis.rate[i], axis.stress[i], axis.pressure[i]});
    }
    run.log.picture("flow", 1.0, true, [&] {
        return SimulationSnapshot{
            .stage = "flow",
            .cell = std::nullopt,
            .flow = flow_picture(field.flow, field.units,
                                 {.offset = -static_cast<double>(field.flow.domain().lip)})};
    });
    report(run, field.units, field.flow.domain().length);
}

}  // namespace bioprint
