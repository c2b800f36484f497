#include "simulate/offset_channel_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/ellipsoid_axes.hpp"
#include "simulate/immersed_body.hpp"
#include "simulate/offset_view.hpp"

namespace bioprint {

namespace {

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
    }

    OffsetChannelResult run() {
        OffsetChannelResult result{.series = {},
                                   .shape = {},
                                   .complete = false,
                                   .time_step = lu_.time,
                                   .radius_lu = radius_,
                                   .steps = 0,
                                   .nodes = lattice_.fluid_nodes()};
        const auto total = static_cast<long>(std::ceil(setup_.duration / lu_.time));
        const long stride = std::max<long>(2, total / std::max(setup_.samples, 1) / 2 * 2);
        const double started = cell_.state().ellipsoid.centre[0];
        double last = started;
        while (result.steps < total) {
            for (long i = 0; i < stride; ++i) {
                cell_.load();
                lattice_.step();
                cell_.move();
            }
            result.steps += stride;
            OffsetChannelSample sample = observe();
            const double centre = sample.path;
            sample.time = result.steps * lu_.time;
            sample.path = (centre - started) * lu_.spacing;
            sample.velocity = (centre - last) * lu_.spacing / (stride * lu_.time);
            last = centre;
            result.series.push_back(sample);
            if (setup_.drive == OffsetDrive::constant_flow_rate) {
                hold_flow_rate();
            }
            if (setup_.progress && !setup_.progress(static_cast<double>(result.steps) / total)) {
                return result;
            }
        }
        result.complete = true;
        const Vector3 centre = cell_.state().ellipsoid.centre;
        for (const Vector3& p : cell_.positions()) {
            result.shape.push_back(
                {(p[0] - centre[0]) / setup_.nodes, (p[1] - centre[1]) / setup_.nodes, p[2] / setup_.nodes});
        }
        return result;
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
    }

    /// Follows the flow rate of the start: a step of a fifth of the gap at every sample.
    void hold_flow_rate() {
        const double ratio = flow_rate_ / lattice_.flow_rate(0);
        auto force = lattice_.body_force();
        force[0] *= 1.0 + 0.2 * (ratio - 1.0);
        lattice_.set_body_force(force);
    }

    OffsetChannelSample observe() const {
        const OffsetView<Real> view(lattice_, cell_, rest_);
        OffsetChannelSample sample{};
        sample.path = view.centre()[0];
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

    const OffsetChannelSetup& setup_;
    NozzleFlow flow_;
    OffsetUnits lu_;
    double radius_;
    D3q19<Real> lattice_;
    ImmersedBody<Real> cell_;
    MirrorEllipsoid rest_;
    double flow_rate_ = 0.0;
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
