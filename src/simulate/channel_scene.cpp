#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulate/pictures.hpp"
#include "simulate/scenes.hpp"

namespace bioprint {
namespace {

constexpr double length_in_radii = 4.0;
constexpr double sample_in_transits = 0.25;  ///< of R/u
constexpr double longest_in_transits = 60.0;
constexpr double sample_in_relaxations = 0.05;  ///< of the cell's relaxation time
constexpr double longest_in_relaxations = 6.0;
constexpr double rest_in_relaxations = 0.5;
constexpr double most_transits = 240.0;  ///< however slowly the cell relaxes
constexpr int control_interval = 64;
constexpr double smallest_element = 0.85;  ///< of its undeformed volume
constexpr double largest_element = 1.15;
constexpr double largest_deformation = 0.1;
constexpr double largest_volume_drift = 0.02;
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
    [[nodiscard]] std::vector<double> state() const { return {last_, change_}; }
    void restore(std::span<const double> state) {
        last_ = state[0];
        change_ = state[1];
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
            .volume_strength = bulk ? 0.0 : 0.08};
}

ChannelSteps channel_steps(const Scene& scene, const NozzleFlow& flow, const LatticeUnits& units,
                           const SimulationOptions& options) {
    const double transit = units.radius / units.velocity_lu;  // steps
    // A fast print's cell relaxes over many transits; samples too close together could not tell its slow end.
    const double relaxation = 2.5 * viscosity(flow.ink(), 0.0) / scene.cell.shear_modulus / units.time_step;
    const double longest =
        std::min(std::max(longest_in_transits * transit, longest_in_relaxations * relaxation),
                 most_transits * transit);
    const long sample = std::max(
        2L, std::lround(std::min(std::max(sample_in_transits * transit, sample_in_relaxations * relaxation),
                                 longest / 40.0)));
    const long most = options.channel_time > 0.0
                          ? std::max(sample, std::lround(options.channel_time / units.time_step))
                          : std::lround(longest);
    return {.sample = sample,
            .most = most,
            .rest = std::min(std::lround(rest_in_relaxations * relaxation), most / 8)};
}

int channel_length(int nodes) {
    return (static_cast<int>(length_in_radii * nodes) + 15) / 16 * 16;
}

namespace {

/// The cell in its periodic stretch of nozzle, sample after sample.
class ChannelRun {
  public:
    ChannelRun(const Run& run, const LatticeUnits& units);

    void until_settled();
    ChannelState finish();

  private:
    void advance();
    void sample();
    [[nodiscard]] Record record() const;
    [[nodiscard]] SimulationSnapshot picture() const;
    void resume(const std::vector<double>& values);

    const Run& run_;
    LatticeUnits units_;
    lattice::AxisymmetricFlow flow_;
    ImmersedCell cell_;
    solid::RingShape rest_, shape_;
    FlowRateControl control_;
    SettlingMonitor monitor_;
    long interval_ = 0;
    long limit_ = 0;
    long rest_needed_ = 0;  ///< steps without change that count as steady: more than a turning point takes
    long calm_ = 0;         ///< steps since the stress last changed
    long steps_ = 0;
    double before_ = 0.0;  ///< the centre at the last sample
    double velocity_ = 0.0;
    bool steady_ = false;
};

lattice::AxisymmetricFlow periodic_nozzle(const Run& run, const LatticeUnits& units) {
    const LatticeProfile profile = lattice_profile(run.flow, units);
    const int length = channel_length(run.nodes);
    lattice::AxisymmetricFlow flow({.length = length,
                                    .radius = run.nodes,
                                    .lip = length,
                                    .periodic = true,
                                    .body_force = profile.pressure_gradient},
                                   units.relaxation(run.flow.ink()));
    flow.start(profile.velocity, profile.slope, 0.0);
    return flow;
}

ChannelRun::ChannelRun(const Run& run, const LatticeUnits& units)
    : run_(run),
      units_(units),
      flow_(periodic_nozzle(run, units)),
      cell_(cell_setup(run, units), 0.0),
      rest_(cell_.shape()),
      shape_(rest_),
      control_(flow_, units.velocity_lu * std::numbers::pi * run.nodes * run.nodes, units.viscosity_lu) {
    const double gradient = run.flow.pressure_gradient() * units.spacing;
    start_as_bullet(cell_, gradient / (4.0 * run.scene.cell.shear_modulus));
    cell_.shift(0.5 * flow_.domain().length);
    before_ = cell_.shape().centre;
    const ChannelSteps steps = channel_steps(run.scene, run.flow, units, run.log.options());
    interval_ = steps.sample;
    limit_ = steps.most;
    rest_needed_ = steps.rest;
    run.log.result.series = {
        .columns = {"time [s]", "x [m]", "von_mises [Pa]", "stretch_axial", "stretch_radial", "volume"},
        .rows = {}};
    if (const auto* values = run.log.found("channel")) {
        resume(*values);
    }
}

Record ChannelRun::record() const {
    Record r;
    r.put(static_cast<double>(steps_));
    r.put(before_);
    r.put(velocity_);
    r.put(steady_ ? 1.0 : 0.0);
    r.put(static_cast<double>(calm_));
    r.put(monitor_.state());
    r.put(cell_.state());
    r.put(flow_.state());
    for (const auto& row : run_.log.result.series.rows) {
        r.put(row);
    }
    return r;
}

/// The stretch of nozzle about the cell.
SimulationSnapshot ChannelRun::picture() const {
    const int first = static_cast<int>(std::floor(shape_.centre)) - flow_.domain().length / 2;
    return {.stage = "channel",
            .time = static_cast<double>(steps_) * units_.time_step,
            .cell = cell_picture(cell_, units_, {}),
            .flow = flow_picture(flow_, units_, {.first = first})};
}

void ChannelRun::resume(const std::vector<double>& values) {
    Record r(values);
    steps_ = static_cast<long>(r.next());
    before_ = r.next();
    velocity_ = r.next();
    steady_ = r.next() != 0.0;
    calm_ = static_cast<long>(r.next());
    monitor_.restore(r.next_list());
    cell_.restore(r.next_list());
    flow_.restore(r.next_list());
    for (long n = 0; n < steps_ / interval_; ++n) {
        const auto row = r.next_list();
        run_.log.result.series.rows.emplace_back(row.begin(), row.end());
    }
    shape_ = cell_.shape();
    run_.log.count(steps_, static_cast<double>(flow_.domain().length) * run_.nodes);
}

void ChannelRun::advance() {
    const long until = steps_ + interval_;
    for (; steps_ < until; ++steps_) {
        cell_.load(flow_);
        flow_.step();
        if (!cell_.move(flow_)) {
            run_.log.stop("the cell broke down in the channel after " +
                          std::to_string(static_cast<double>(steps_) * units_.time_step * 1e3) + " ms");
        }
        if (steps_ % control_interval == 0 && run_.scene.drive == ChannelDrive::flow_rate) {
            control_.apply();
        }
    }
}

void ChannelRun::sample() {
    shape_ = cell_.shape();
    if (!(shape_.smallest_jacobian > 0.0)) {
        run_.log.stop("an element of the cell turned inside out in the channel after " +
                      std::to_string(static_cast<double>(steps_) * units_.time_step * 1e3) + " ms");
    }
    velocity_ = (shape_.centre - before_) / static_cast<double>(interval_) * units_.velocity;
    before_ = shape_.centre;
    run_.log.result.series.rows.push_back({static_cast<double>(steps_) * units_.time_step,
                                           shape_.centre * units_.spacing, shape_.von_mises * units_.stress,
                                           shape_.length / rest_.length, shape_.width / rest_.width,
                                           shape_.volume / rest_.volume});
    const double distance = monitor_.distance(shape_.von_mises);
    calm_ = distance < run_.log.options().settle_tolerance ? calm_ + interval_ : 0;
    steady_ = steps_ > 4 * interval_ && calm_ >= rest_needed_;
}

void ChannelRun::until_settled() {
    const double nodes = static_cast<double>(flow_.domain().length) * run_.nodes;
    while (steps_ < limit_ && !steady_) {
        advance();
        run_.log.count(interval_, nodes);
        sample();
        const bool ended = steady_ || steps_ >= limit_;
        const double done =
            ended ? 1.0 : std::min(0.99, static_cast<double>(steps_) / static_cast<double>(limit_));
        run_.log.progress("channel", done);
        if (run_.scene.kind == SceneKind::channel) {
            run_.log.picture("channel", done, ended, [&] { return picture(); });
        }
        run_.log.keep("channel", ended, [&] { return record(); });
        run_.log.stop_if_cancelled();
    }
}

ChannelState ChannelRun::finish() {
    if (!steady_) {
        run_.log.warn("channel-not-steady",
                      run_.log.options().channel_time > 0.0
                          ? "the cell's shape is not yet steady after its time in the nozzle"
                          : "the cell's shape in the nozzle has no steady state within " +
                                std::to_string(std::lround(static_cast<double>(limit_) * units_.velocity_lu /
                                                           run_.nodes)) +
                                " radii of travel; the values are those reached there");
    }
    if (shape_.jacobian_min < smallest_element || shape_.jacobian_max > largest_element) {
        run_.log.warn("distorted-elements", "elements of the cell changed their volume by more than 15 %");
    }
    if (shape_.deformation > largest_deformation) {
        run_.log.warn(
            "strong-deformation",
            "the cell is folded or drawn out so far that the mesh follows it only roughly; compare with a "
            "finer resolution");
    }
    if (std::abs(shape_.volume / rest_.volume - 1.0) > largest_volume_drift) {
        run_.log.warn("volume-drift", "the cell's volume changed by more than 2 %");
    }
    leave_values(run_, shape_, rest_, velocity_, units_.stress);
    leave_outline(run_, cell_, shape_.centre, units_.spacing);
    report(run_, units_, flow_.domain().length);
    ChannelState state{.positions = {cell_.positions().begin(), cell_.positions().end()}, .steady = steady_};
    for (auto& p : state.positions) {
        p.x -= shape_.centre;
    }
    return state;
}

}  // namespace

ChannelState run_channel(const Run& run) {
    ChannelRun channel(run, units_for_cell(run.scene, run.flow, run.nodes, run.log.options()));
    channel.until_settled();
    return channel.finish();
}

}  // namespace bioprint
