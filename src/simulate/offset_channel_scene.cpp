#include "simulate/offset_channel_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/ellipsoid_axes.hpp"
#include "simulate/immersed_body.hpp"
#include "simulate/offset_view.hpp"
#include "simulate/space_pictures.hpp"

namespace bioprint {

namespace {

constexpr std::size_t samples_a_window = 8;  ///< of settling

void check(const OffsetChannelSetup& setup) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(setup.radius) || !positive(setup.cell_radius) || !positive(setup.velocity_average) ||
        !positive(setup.shear_modulus) || !positive(setup.duration) || !(setup.offset >= 0.0)) {
        throw UsageError("the channel scene needs lengths, velocity, shear modulus and duration above 0");
    }
    if (!(setup.nodes >= 2.5 && setup.nodes <= 40.0) || !(setup.length >= 4.0 && setup.length <= 100.0)) {
        throw UsageError(
            "the channel scene resolves a cell radius by 2.5 to 40 nodes and a period of 4 to 100 cell "
            "radii");
    }
    const double gap = (setup.radius - setup.cell_radius - setup.offset) / setup.cell_radius * setup.nodes;
    if (!(gap >= 1.0)) {
        throw UsageError("the cell must start at least one lattice spacing from the nozzle's wall");
    }
}

}  // namespace

OffsetChannelSteps offset_channel_steps(const OffsetChannelSetup& setup, const NozzleFlow& flow,
                                        const OffsetUnits& units) {
    const auto most = static_cast<long>(std::ceil(setup.duration / units.time));
    const double rate = flow.shear_rate(setup.offset);
    const double eta = viscosity(setup.ink, rate);
    const double response = std::min(2.5 * eta / setup.shear_modulus, rate > 0.0 ? 2.0 / rate : 1e30);
    const long window = std::lround(2.0 * response / units.time);
    const bool settles = setup.settle_tolerance > 0.0;
    const long stride =
        settles ? window / static_cast<long>(samples_a_window) : most / std::max(setup.samples, 1);
    return {.sample = std::max<long>(2, stride / 2 * 2), .most = most};
}

namespace {

template <class Real>
class Channel {
  public:
    explicit Channel(const OffsetChannelSetup& setup)
        : setup_(setup),
          flow_(NozzleFlow::from_velocity(setup.ink, setup.radius, setup.velocity_average)),
          lu_(offset_units({setup.cell_radius, setup.shear_modulus, setup.nodes}, flow_)),
          radius_(setup.radius / lu_.spacing),
          lattice_(lattice_setup()),
          cell_(body_setup(), lattice_, {0.5 * lattice_.nx(), setup.offset / lu_.spacing, 0.0}),
          rest_(mirror_ellipsoid(cell_.state().ellipsoid)) {
        start();
        plan();
        if (const auto* values = setup.watch.kept("channel")) {
            resume(*values);
        }
    }

    OffsetChannelResult run() {
        try {
            bool ended = is_over();
            while (!ended && result_.stopped.empty()) {
                advance();
                sample();
                ended = is_over();
                const auto picture = [this] {
                    return space_picture(lattice_, cell_, scale(), result_.series.back().time);
                };
                if (!setup_.watch.attend("channel", ended ? 1.0 : fraction(), ended, picture,
                                         [this] { return record(); })) {
                    result_.stopped = cancelled_run;
                }
            }
        } catch (const NotConverged& e) {
            result_.stopped = e.what();
        }
        report();
        return std::move(result_);
    }

  private:
    D3q19Setup lattice_setup() const {
        const double nodes = setup_.length * setup_.nodes;
        return {.nx = std::max(16, static_cast<int>(std::lround(nodes / 16.0)) * 16),
                .section = tube(radius_, true),
                .viscosity = {.nu0 = lu_.nu0,
                              .nu_inf = lu_.nu0 * setup_.ink.eta_inf / setup_.ink.eta0,
                              .time_constant = setup_.ink.time_constant / lu_.time,
                              .alpha = setup_.ink.alpha},
                .body_force = {flow_.pressure_gradient() * lu_.spacing / lu_.stress, 0.0, 0.0},
                .threads = setup_.threads};
    }

    ImmersedBodySetup body_setup() const {
        return {.radius = setup_.nodes,
                .spacing = setup_.mesh_spacing,
                .inside = setup_.inside,
                .shear_modulus = setup_.shear_modulus / lu_.stress};
    }

    void start() {
        const double scale = lu_.time / lu_.spacing;
        lattice_.initialise([&](double, double y, double z) {
            const double r = std::hypot(y, z);
            const double slope = -0.5 * flow_.shear_rate(r * lu_.spacing) * lu_.time / r;
            return FlowState{.velocity = {flow_.velocity(r * lu_.spacing) * scale, 0.0, 0.0},
                             .strain_rate = {0.0, 0.0, 0.0, slope * y, slope * z, 0.0}};
        });
        flow_rate_ = lattice_.flow_rate(0);
        before_ = cell_.state().ellipsoid.centre;
        started_ = before_[0];
    }

    /// How often to sample, how long to run and how long the stress must stand still.
    void plan() {
        const OffsetChannelSteps steps = offset_channel_steps(setup_, flow_, lu_);
        total_ = steps.most;
        stride_ = steps.sample;
        const double viscous_time = radius_ * radius_ / (5.8 * lu_.nu0);
        gain_ = std::min(0.2, stride_ / (4.0 * viscous_time));
    }

    void advance() {
        for (long i = 0; i < stride_; ++i) {
            cell_.load();
            lattice_.step();
            cell_.move();
        }
        result_.steps += stride_;
    }

    void sample() {
        OffsetChannelSample sample = observe();
        const Vector3 centre = cell_.state().ellipsoid.centre;
        const double velocity = lu_.spacing / (stride_ * lu_.time);
        sample.time = result_.steps * lu_.time;
        sample.path = (centre[0] - started_) * lu_.spacing;
        sample.velocity = (centre[0] - before_[0]) * velocity;
        sample.migration = (centre[1] - before_[1]) * velocity;
        before_ = centre;
        if (setup_.hold_offset) {
            const double back = setup_.offset / lu_.spacing - centre[1];
            cell_.shift({0.0, back, 0.0});
            before_[1] += back;
        }
        result_.series.push_back(sample);
        if (setup_.drive == OffsetDrive::constant_flow_rate) {
            hold_flow_rate();
        }
    }

    /// Of the run; most settle within four windows.
    [[nodiscard]] double fraction() const {
        const auto done = static_cast<double>(result_.steps);
        const double usual = 4.0 * static_cast<double>(samples_a_window) * static_cast<double>(stride_);
        const double settling = setup_.settle_tolerance > 0.0 ? std::min(0.95, done / usual) : 0.0;
        return std::max(settling, done / static_cast<double>(total_));
    }

    [[nodiscard]] bool is_settled() const {
        const std::size_t n = result_.series.size();
        if (setup_.settle_tolerance <= 0.0 || n < 3 * samples_a_window) {
            return false;
        }
        double least = 1e300;
        double most = 0.0;
        for (std::size_t i = n - 1 - samples_a_window; i < n; ++i) {
            const OffsetChannelSample& s = result_.series[i];
            // Near the axis the ink's stress at the centre is not what loads the cell.
            const double share =
                s.von_mises / std::max(s.fluid_stress, 0.5 * s.pressure_gradient * setup_.cell_radius);
            least = std::min(least, share);
            most = std::max(most, share);
        }
        return most - least < setup_.settle_tolerance * most;
    }

    [[nodiscard]] bool is_over() {
        result_.steady = is_settled();
        result_.complete = result_.steady || result_.steps >= total_;
        return result_.complete;
    }

    /// Follows the flow rate of the start by part of the gap at every sample.
    void hold_flow_rate() {
        const double ratio = flow_rate_ / lattice_.flow_rate(0);
        auto force = lattice_.body_force();
        force[0] *= 1.0 + gain_ * (ratio - 1.0);
        lattice_.set_body_force(force);
    }

    OffsetChannelSample observe() const {
        const OffsetView<Real> view(lattice_, cell_, rest_);
        OffsetChannelSample sample{};
        sample.offset = view.centre()[1] * lu_.spacing;
        sample.von_mises = view.von_mises() * lu_.stress;
        sample.pressure_gradient = lattice_.body_force()[0] * lu_.stress / lu_.spacing;
        sample.fluid_stress = 0.5 * sample.pressure_gradient * std::abs(sample.offset);
        sample.stretch = view.stretch();
        sample.angle = view.angle();
        sample.frequency = view.frequency() / lu_.time;
        sample.viscous = view.viscous_stress() * lu_.stress;
        sample.volume = view.volume();
        return sample;
    }

    [[nodiscard]] SpaceScale scale() const {
        return {.spacing = lu_.spacing,
                .time = lu_.time,
                .stress = lu_.stress,
                .offset = -started_ * lu_.spacing,
                .centred = true};
    }

    [[nodiscard]] Record record() const {
        Record r;
        r.put(static_cast<double>(result_.steps));
        r.put(before_);
        r.put(static_cast<double>(result_.series.size()));
        for (const OffsetChannelSample& s : result_.series) {
            for (const double value :
                 {s.time, s.path, s.offset, s.velocity, s.von_mises, s.fluid_stress, s.angle, s.frequency,
                  s.viscous, s.volume, s.pressure_gradient, s.migration}) {
                r.put(value);
            }
            r.put(s.stretch);
        }
        r.put(cell_.record());
        r.put(lattice_.state());
        return r;
    }

    void resume(const std::vector<double>& values) {
        Record r(values);
        result_.steps = static_cast<long>(r.next());
        before_ = r.next_three();
        for (auto n = static_cast<long>(r.next()); n > 0; --n) {
            OffsetChannelSample s{};
            for (double* value :
                 {&s.time, &s.path, &s.offset, &s.velocity, &s.von_mises, &s.fluid_stress, &s.angle,
                  &s.frequency, &s.viscous, &s.volume, &s.pressure_gradient, &s.migration}) {
                *value = r.next();
            }
            s.stretch = r.next_three();
            result_.series.push_back(s);
        }
        cell_.restore(r.next_list());
        lattice_.restore(r.next_list());
    }

    void report() {
        result_.nodes = lattice_.fluid_nodes();
        result_.lattice = lattice_report(lu_, flow_, {setup_.cell_radius, setup_.shear_modulus, setup_.nodes},
                                         lattice_.nx());
        const Vector3 centre = cell_.state().ellipsoid.centre;
        for (const Vector3& p : cell_.positions()) {
            result_.shape.push_back(
                {(p[0] - centre[0]) / setup_.nodes, (p[1] - centre[1]) / setup_.nodes, p[2] / setup_.nodes});
        }
    }

    const OffsetChannelSetup& setup_;
    NozzleFlow flow_;
    OffsetUnits lu_;
    double radius_;
    D3q19<Real> lattice_;
    ImmersedBody<Real> cell_;
    MirrorEllipsoid rest_;
    long total_ = 0;
    long stride_ = 2;
    double gain_ = 0.0;
    double flow_rate_ = 0.0;
    double started_ = 0.0;  ///< the centre along the nozzle
    Vector3 before_{};      ///< the centre at the sample before
    OffsetChannelResult result_{};
};

}  // namespace

OffsetChannelResult run_offset_channel(const OffsetChannelSetup& setup) {
    check(setup);
    if (setup.single) {
        return Channel<float>(setup).run();
    }
    return Channel<double>(setup).run();
}

}  // namespace bioprint
