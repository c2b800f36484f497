#include "simulate/offset_exit_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/offset_channel_scene.hpp"
#include "simulate/offset_view.hpp"

namespace bioprint {

namespace {

// Nozzle before the cell's start and strand behind its end, in radii: the flow there is developed.
constexpr double margin_before = 1.5;
constexpr double margin_behind = 1.5;

OffsetChannelResult settle(const OffsetExitSetup& setup) {
    return run_offset_channel({.ink = setup.ink,
                               .radius = setup.radius,
                               .velocity_average = setup.velocity_average,
                               .cell_radius = setup.cell_radius,
                               .shear_modulus = setup.shear_modulus,
                               .offset = setup.offset,
                               .duration = setup.settle,
                               .nodes = setup.nodes,
                               .mesh_spacing = setup.mesh_spacing,
                               .single = setup.single,
                               .samples = 10,
                               .threads = setup.threads});
}

template <class Real>
class Exit {
  public:
    Exit(const OffsetExitSetup& setup, const OffsetChannelResult& channel)
        : setup_(setup),
          flow_(NozzleFlow::from_velocity(setup.ink, setup.radius, setup.velocity_average)),
          lu_(offset_units({setup.cell_radius, setup.shear_modulus, setup.nodes}, flow_)),
          radius_(setup.radius / lu_.spacing),
          lip_(static_cast<int>(std::lround((margin_before + setup.approach) * radius_))),
          lattice_(lattice_setup()),
          cell_({.radius = setup.nodes,
                 .spacing = setup.mesh_spacing,
                 .shear_modulus = setup.shear_modulus / lu_.stress},
                lattice_, {0.0, 0.0, 0.0}),
          rest_(mirror_ellipsoid(cell_.state().ellipsoid)) {
        std::vector<Vector3> positions;
        const double offset = channel.series.back().offset / lu_.spacing;
        for (const auto& p : channel.shape) {
            positions.push_back({lip_ - setup.approach * radius_ + p[0] * setup.nodes,
                                 offset + p[1] * setup.nodes, p[2] * setup.nodes});
        }
        cell_.set_positions(positions);
        start();
    }

    OffsetExitResult run(const OffsetChannelResult& channel) {
        OffsetExitResult result{.series = {},
                                .channel_von_mises = channel.series.back().von_mises,
                                .peak_von_mises = 0.0,
                                .peak_position = 0.0,
                                .flow_steady = bring_to_rest(),
                                .complete = false,
                                .time_step = lu_.time,
                                .steps = 0,
                                .nodes = lattice_.fluid_nodes()};
        const double path = (setup_.approach + setup_.travel) * radius_;
        // A cell is never slower than a third of the average: past this many steps it is stuck.
        const auto most = static_cast<long>(3.0 * path * lu_.spacing / (setup_.velocity_average * lu_.time));
        const long stride = std::max<long>(2, most / 3 / std::max(setup_.samples, 1) / 2 * 2);
        double fraction = 0.0;
        while (fraction < 1.0 && result.steps < most) {
            for (long i = 0; i < stride; ++i) {
                cell_.load();
                lattice_.step();
                cell_.move();
            }
            result.steps += stride;
            const OffsetExitSample sample = observe(result.steps * lu_.time);
            result.series.push_back(sample);
            if (sample.von_mises > result.peak_von_mises) {
                result.peak_von_mises = sample.von_mises;
                result.peak_position = sample.position;
            }
            fraction = (sample.position / lu_.spacing + setup_.approach * radius_) / path;
            if (setup_.progress && !setup_.progress(std::min(fraction, 1.0))) {
                return result;
            }
        }
        result.complete = fraction >= 1.0;
        return result;
    }

  private:
    D3q19Setup lattice_setup() const {
        const double wanted = lip_ + (setup_.travel + margin_behind) * radius_;
        const int nx = static_cast<int>(std::ceil(wanted / 16.0)) * 16;
        return {.nx = nx,
                .section = tube(radius_, true),
                .viscosity = {.nu0 = lu_.nu0,
                              .nu_inf = lu_.nu0 * setup_.ink.eta_inf / setup_.ink.eta0,
                              .time_constant = setup_.ink.time_constant / lu_.time,
                              .alpha = setup_.ink.alpha},
                .ends = Ends::inflow_outflow,
                .inflow = [this](double y, double z) { return profile(std::hypot(y, z)); },
                .slip_begin = lip_,
                .slip_end = nx,
                .threads = setup_.threads};
    }

    [[nodiscard]] double profile(double r) const {
        return flow_.velocity(std::min(r * lu_.spacing, setup_.radius)) * lu_.time / lu_.spacing;
    }

    /// The developed flow up to the lip, the plug behind it.
    void start() {
        const double gradient = flow_.pressure_gradient() * lu_.spacing / lu_.stress;
        const double plug = setup_.velocity_average * lu_.time / lu_.spacing;
        lattice_.initialise([&](double x, double y, double z) {
            FlowState state{.velocity = {plug, 0.0, 0.0}};
            if (x < lip_) {
                const double r = std::hypot(y, z);
                const double slope = -0.5 * flow_.shear_rate(r * lu_.spacing) * lu_.time / r;
                state.density = 3.0 * gradient * (lip_ - x);
                state.velocity[0] = profile(r);
                state.strain_rate = {0.0, 0.0, 0.0, slope * y, slope * z, 0.0};
            }
            return state;
        });
    }

    /// Steps without the cell until the largest elongation on the axis stands still.
    bool bring_to_rest() {
        const int row = lattice_.row(lattice_.section().ny / 2, 0);
        const int stride = std::max(20, static_cast<int>(radius_));
        double before = 0.0;
        int still = 0;
        for (int round = 0; round < 200; ++round) {
            for (int i = 0; i < stride; ++i) {
                lattice_.cycle();
            }
            double peak = 0.0;
            for (int x = lip_ / 2; x < lip_ + 2 * static_cast<int>(radius_); ++x) {
                peak = std::max(peak, std::abs(lattice_.at(x, row).viscous_stress[0]));
            }
            // Twice in a row: sound makes the peak swing through its final value.
            still = std::abs(peak - before) < 2e-3 * peak ? still + 1 : 0;
            if (still == 3) {
                return true;
            }
            before = peak;
        }
        return false;
    }

    OffsetExitSample observe(double time) const {
        const OffsetView<Real> view(lattice_, cell_, rest_);
        return {.time = time,
                .position = (view.centre()[0] - lip_) * lu_.spacing,
                .offset = view.centre()[1] * lu_.spacing,
                .von_mises = view.von_mises() * lu_.stress,
                .stretch = view.stretch(),
                .angle = view.angle(),
                .viscous = view.viscous_stress() * lu_.stress,
                .volume = view.volume()};
    }

    const OffsetExitSetup& setup_;
    NozzleFlow flow_;
    OffsetUnits lu_;
    double radius_;
    int lip_;
    D3q19<Real> lattice_;
    ImmersedBody<Real> cell_;
    MirrorEllipsoid rest_;
};

}  // namespace

OffsetExitResult run_offset_exit(const OffsetExitSetup& setup) {
    if (!(setup.approach >= 0.5 && setup.approach <= 10.0) ||
        !(setup.travel >= 0.5 && setup.travel <= 20.0)) {
        throw UsageError("the exit scene starts 0.5 to 10 radii before the lip and ends 0.5 to 20 behind it");
    }
    const OffsetChannelResult channel = settle(setup);
    if (setup.single) {
        return Exit<float>(setup, channel).run(channel);
    }
    return Exit<double>(setup, channel).run(channel);
}

}  // namespace bioprint
