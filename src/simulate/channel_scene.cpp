#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/scenes.hpp"

namespace bioprint {
namespace {

constexpr double length_in_radii = 4.0;
constexpr double sample_in_transits = 0.25;  ///< of R/u
constexpr double longest_in_transits = 60.0;
constexpr int control_interval = 64;
constexpr double smallest_element = 0.85;  ///< of its undeformed volume
constexpr double largest_element = 1.15;
constexpr double largest_start_strain = 0.3;

/// The small-strain shape of a centred cell: displacements from the quadratic part of the ambient flow, κ =
/// G/(4μ).
void start_as_bullet(ImmersedCell& cell, double kappa) {
    const double radius = cell.body().mesh().radius;
    const double k = std::min(kappa, largest_start_strain / radius);
    std::vector<solid::RingPoint> position(cell.positions().begin(), cell.positions().end());
    for (auto& p : position) {
        const double z = p.x;
        const double rho = p.r;
        p.x += k * (5.0 / 24.0 * z * z - 85.0 / 48.0 * rho * rho);
        p.r -= k * 5.0 / 24.0 * rho * z;
    }
    cell.set_positions(position);
}

/// Keeps the flow rate by the body force.
class FlowRateControl {
  public:
    FlowRateControl(lattice::AxisymmetricFlow& flow, double rate, double viscosity)
        : flow_(flow), rate_(rate) {
        const int n = flow.domain().radius;
        const double viscous_time = static_cast<double>(n) * n / (5.8 * viscosity);
        gain_ = std::min(0.2, control_interval / (4.0 * viscous_time));
    }
    void apply() {
        const double lack = 1.0 - flow_.flow_rate(0) / rate_;
        flow_.set_body_force(flow_.domain().body_force * (1.0 + gain_ * lack));
    }

  private:
    lattice::AxisymmetricFlow& flow_;
    double rate_;
    double gain_;
};

/// Distance from the limit of a geometric sequence, from its last steps.
class SettlingMonitor {
  public:
    [[nodiscard]] double distance(double value) {
        const double change = std::abs(value - last_);
        const double ratio = change_ > 0.0 ? std::min(change / change_, 0.97) : 0.97;
        last_ = value;
        change_ = change;
        return change / (1.0 - ratio) / std::abs(value);
    }

  private:
    double last_ = 0.0;
    double change_ = 0.0;
};

void leave_outline(const Run& run, const ImmersedCell& cell, double centre, double spacing) {
    auto& outline = run.log.result.outline;
    outline.columns = {"x [m]", "r [m]"};
    for (const int v : cell.body().mesh().outline) {
        const auto& p = cell.positions()[static_cast<std::size_t>(v)];
        outline.rows.push_back({(p.x - centre) * spacing, p.r * spacing});
    }
}

void leave_values(const Run& run, const solid::RingShape& shape, const solid::RingShape& rest,
                  double velocity, double stress) {
    const double axial = shape.length / rest.length;
    const double radial = shape.width / rest.width;
    run.log.value("von_mises", shape.von_mises * stress);
    run.log.value("stretch.0", axial);
    run.log.value("stretch.1", radial);
    run.log.value("stretch.2", radial);
    run.log.value("cell_velocity", velocity);
    run.log.value("deformation", 1.0 - (1.0 - shape.deformation) / (1.0 - rest.deformation));
}

}  // namespace

ImmersedCellSetup cell_setup(const Run& run, const LatticeUnits& units) {
    const SimulationOptions& options = run.log.options();
    const double modulus = run.scene.cell.shear_modulus / units.stress;
    const bool bulk = options.bulk_modulus_ratio > 0.0;
    return {.radius = run.scene.cell.radius / units.spacing,
            .coupling = options.coupling == CellCoupling::at_vertices ? Coupling::vertices : Coupling::inside,
            .spacing = run.scene.cell.radius / units.spacing / run.layers,
            .shear_modulus = modulus,
            .bulk_modulus = options.bulk_modulus_ratio * modulus,
            .volume_strength = bulk ? 0.0 : 0.02};
}

ChannelState run_channel(const Run& run) {
    const LatticeUnits units = units_for_cell(run.scene, run.flow, run.nodes, run.log.options());
    const LatticeProfile profile = lattice_profile(run.flow, units);
    const int length = (static_cast<int>(length_in_radii * run.nodes) + 15) / 16 * 16;
    lattice::AxisymmetricFlow flow({.length = length,
                                    .radius = run.nodes,
                                    .lip = length,
                                    .periodic = true,
                                    .body_force = profile.pressure_gradient},
                                   units.relaxation(run.flow.ink()));
    flow.start(profile.velocity, profile.slope, 0.0);
    ImmersedCell cell(cell_setup(run, units), 0.0);
    const solid::RingShape rest = cell.shape();
    start_as_bullet(cell,
                    run.flow.pressure_gradient() * units.spacing / (4.0 * run.scene.cell.shear_modulus));
    cell.shift(0.5 * length);

    const double area = std::numbers::pi * run.nodes * run.nodes;
    FlowRateControl control(flow, units.velocity_lu * area, units.viscosity_lu);
    const double transit = run.nodes / units.velocity_lu;  // steps
    const auto interval = std::max(2L, std::lround(sample_in_transits * transit));
    const double channel_time = run.log.options().channel_time;
    const auto limit = channel_time > 0.0 ? std::max(interval, std::lround(channel_time / units.time_step))
                                          : std::lround(longest_in_transits * transit);
    SettlingMonitor monitor;
    auto& series = run.log.result.series;
    series.columns = {"time [s]", "x [m]", "von_mises [Pa]", "stretch_axial", "stretch_radial", "volume"};
    double velocity = 0.0;
    double before = cell.shape().centre;
    bool steady = false;
    solid::RingShape shape = rest;
    long n = 0;
    while (n < limit && !steady) {
        const long until = n + interval;
        for (; n < until; ++n) {
            cell.load(flow);
            flow.step();
            cell.move(flow);
            if (n % control_interval == 0 && run.scene.drive == ChannelDrive::flow_rate) {
                control.apply();
            }
        }
        shape = cell.shape();
        if (!(shape.smallest_jacobian > 0.0)) {
            run.log.count(n, static_cast<double>(length) * run.nodes);
            run.log.stop("an element of the cell turned inside out in the channel after " +
                         std::to_string(static_cast<double>(n) * units.time_step * 1e3) + " ms");
        }
        velocity = (shape.centre - before) / static_cast<double>(interval) * units.velocity;
        before = shape.centre;
        series.rows.push_back({static_cast<double>(n) * units.time_step, shape.centre * units.spacing,
                               shape.von_mises * units.stress, shape.length / rest.length,
                               shape.width / rest.width, shape.volume / rest.volume});
        const double distance = monitor.distance(shape.von_mises);
        steady = n > 4 * interval && distance < run.log.options().settle_tolerance;
        run.log.progress("channel",
                         steady ? 1.0 : std::min(0.99, static_cast<double>(n) / static_cast<double>(limit)));
        run.log.stop_if_cancelled();
    }
    run.log.count(n, static_cast<double>(length) * run.nodes);
    if (!steady && channel_time > 0.0) {
        run.log.warn("channel-not-steady", "the cell's shape is not yet steady after its time in the nozzle");
    } else if (!steady) {
        run.log.warn("channel-not-steady", "the cell's shape in the nozzle has no steady state within " +
                                               std::to_string(static_cast<int>(longest_in_transits)) +
                                               " radii of travel; the values are those reached there");
    }
    if (shape.jacobian_min < smallest_element || shape.jacobian_max > largest_element) {
        run.log.warn("distorted-elements", "elements of the cell changed their volume by more than 15 %");
    }
    if (std::abs(shape.volume / rest.volume - 1.0) > 0.02) {
        run.log.warn("volume-drift", "the cell's volume changed by more than 2 %");
    }
    leave_values(run, shape, rest, velocity, units.stress);
    leave_outline(run, cell, shape.centre, units.spacing);
    report(run, units, length);
    ChannelState state{.positions = {cell.positions().begin(), cell.positions().end()}, .steady = steady};
    for (auto& p : state.positions) {
        p.x -= shape.centre;
    }
    return state;
}

}  // namespace bioprint
