#include "simulate/exit_start.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/errors.hpp"

namespace bioprint {
namespace {

constexpr int fewest_nodes = 12;
constexpr int most_nodes = 48;
constexpr double tolerance = 1e-3;  ///< far below what the lattices differ by

int nodes_for(double nodes) {
    return std::clamp(static_cast<int>(std::lround(nodes)), fewest_nodes, most_nodes);
}

}  // namespace

ExitStart::ExitStart(const NozzleFlow& flow, double nodes_a_radius) : nodes_(nodes_for(nodes_a_radius)) {
    ExitField field = unsettled_exit_flow(flow, nodes_for(nodes_a_radius), exit_reach(flow.ink()));
    if (!field.flow.run_to_steady(tolerance, exit_step_limit)) {
        throw NotConverged("the exit flow did not become steady");
    }
    fields_ = field.flow.measure();
    lip_ = field.flow.domain().lip;
    velocity_ = field.units.velocity_lu;
    pressure_ = field.units.viscosity_lu * velocity_ / nodes_;
}

ExitStart::Plane ExitStart::interpolated(double x, double r) const {
    const double at_x = std::clamp(x * nodes_ + lip_ - 0.5, 0.0, fields_.length - 1.0);
    const double at_r = std::abs(r) * nodes_ - 0.5;
    const int i = std::min(static_cast<int>(at_x), fields_.length - 2);
    // Nearer to the axis or to the wall than any node the two next to it are extrapolated.
    const int j = std::clamp(static_cast<int>(std::floor(at_r)), 0, fields_.radius - 2);
    const auto value = [&](const std::vector<double>& field) {
        const auto along = [&](int row) {
            const double here = field[fields_.at(i, row)];
            return here + (at_x - i) * (field[fields_.at(i + 1, row)] - here);
        };
        return along(j) + (at_r - j) * (along(j + 1) - along(j));
    };
    return {.x = value(fields_.velocity_x) / velocity_,
            .r = value(fields_.velocity_r) / velocity_,
            .pressure = value(fields_.pressure) / pressure_};
}

FlowState ExitStart::at(double x, double y, double z) const {
    const double r = std::hypot(y, z);
    const double step = 0.5 / nodes_;
    const Plane here = interpolated(x, r);
    const Plane before = interpolated(x - step, r);
    const Plane behind = interpolated(x + step, r);
    const Plane inside = interpolated(x, r - step);
    const Plane outside = interpolated(x, r + step);
    const double xx = (behind.x - before.x) / (2.0 * step);
    const double xr = 0.5 * ((outside.x - inside.x) + (behind.r - before.r)) / (2.0 * step);
    const double hoop = r > 0.0 ? here.r / r : -0.5 * xx;
    const double rr = -xx - hoop;
    const double c = r > 0.0 ? y / r : 1.0;
    const double s = r > 0.0 ? z / r : 0.0;
    return {.density = 3.0 * here.pressure,
            .velocity = {here.x, c * here.r, s * here.r},
            .strain_rate = {xx, c * c * rr + s * s * hoop, s * s * rr + c * c * hoop, c * xr, s * xr,
                            c * s * (rr - hoop)}};
}

}  // namespace bioprint
