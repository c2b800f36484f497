#include "simulate/offset_channel_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/ellipsoid_axes.hpp"
#include "simulate/immersed_body.hpp"

namespace bioprint {

namespace {

// What closes the time step; the tightest holds.
constexpr double fastest = 0.08;   // velocity on the axis: a cell crosses no more of a spacing in a step
constexpr double reynolds = 0.5;   // γ̇ R_c²/ν at the wall: the fluid follows the cell
constexpr double stiffest = 0.02;  // μ: elastic waves stay slower than sound

struct Units {
    double spacing;  ///< [m]
    double time;     ///< [s]
    double nu0;      ///< zero-shear viscosity of the lattice
    double stress;   ///< [Pa]
};

Units units(const OffsetChannelSetup& setup, const NozzleFlow& flow) {
    const double dx = setup.cell_radius / setup.nodes;
    const double wall_rate = flow.shear_rate_max();
    const double wall_viscosity = viscosity(setup.ink, wall_rate);
    const double thinning = wall_viscosity / setup.ink.eta0;
    const double a2 = setup.nodes * setup.nodes;
    // With s = η0/μ: μ_lu = nu0 dt/s. For a given nu0 each limit bounds dt; nu0 is chosen so that the last
    // two meet.
    const double s = setup.ink.eta0 / setup.shear_modulus;
    const double nu0 = std::clamp(std::sqrt(stiffest * s * wall_rate * a2 / (reynolds * thinning)), 0.5, 4.0);
    const double dt = std::min({fastest * dx / flow.velocity_max(),
                                reynolds * thinning * nu0 / (wall_rate * a2), stiffest * s / nu0});
    return {dx, dt, nu0, setup.ink.eta0 / (nu0 * dt)};
}

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
          lu_(units(setup, flow_)),
          radius_(setup.radius / lu_.spacing),
          lattice_(lattice_setup()),
          cell_(body_setup(), lattice_, {0.5 * lattice_.nx(), setup.offset / lu_.spacing, 0.0}),
          rest_(mirror_ellipsoid(cell_.state().ellipsoid)) {
        start();
    }

    OffsetChannelResult run() {
        OffsetChannelResult result{.series = {},
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
            if (setup_.drive == ChannelDrive::constant_flow_rate) {
                hold_flow_rate();
            }
            if (setup_.progress && !setup_.progress(static_cast<double>(result.steps) / total)) {
                return result;
            }
        }
        result.complete = true;
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
        const SolidState state = cell_.state();
        if (!std::isfinite(state.von_mises) || !std::isfinite(state.volume)) {
            throw NotConverged("the channel scene lost its numbers");
        }
        const MirrorEllipsoid now = mirror_ellipsoid(state.ellipsoid);
        const Matrix3 gradient = cell_.solid().mean_gradient(cell_.positions(), cell_.velocities());
        OffsetChannelSample sample{};
        sample.path = state.ellipsoid.centre[0];
        sample.offset = state.ellipsoid.centre[1] * lu_.spacing;
        sample.von_mises = state.von_mises * lu_.stress;
        sample.pressure_gradient = lattice_.body_force()[0] * lu_.stress / lu_.spacing;
        sample.fluid_stress = 0.5 * sample.pressure_gradient * std::abs(sample.offset);
        for (int k = 0; k < 3; ++k) {
            sample.stretch[k] = now.semi_axes[k] / rest_.semi_axes[k];
        }
        sample.angle = now.angle;
        sample.frequency = tank_treading_frequency(gradient, now) / lu_.time;
        sample.viscous = viscous_stress(state.ellipsoid.centre, now) * lu_.stress;
        sample.volume = state.volume / cell_.solid().rest_volume();
        return sample;
    }

    /// Mean over the lattice nodes in the equivalent ellipsoid of the viscous shear stress in its axes.
    double viscous_stress(const Vector3& centre, const MirrorEllipsoid& ellipsoid) const {
        const Section& section = lattice_.section();
        const int reach = static_cast<int>(std::ceil(ellipsoid.semi_axes[0])) + 1;
        double sum = 0.0;
        long count = 0;
        const int y0 = static_cast<int>(std::floor(centre[1] + section.origin_y));
        const int x0 = static_cast<int>(std::floor(centre[0]));
        for (int z = 0; z < std::min(reach, section.nz); ++z) {
            for (int y = y0 - reach; y <= y0 + reach; ++y) {
                const int row = lattice_.row(y, z);
                for (int x = x0 - reach; row >= 0 && x <= x0 + reach; ++x) {
                    const Vector3 d{x + 0.5 - centre[0], section.y_of(y) - centre[1], section.z_of(z)};
                    double inside = 0.0;
                    for (int k = 0; k < 3; ++k) {
                        const Vector3& axis = ellipsoid.axis[k];
                        const double along = axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2];
                        inside += along * along / (ellipsoid.semi_axes[k] * ellipsoid.semi_axes[k]);
                    }
                    if (inside > 1.0) {
                        continue;
                    }
                    const int nx = lattice_.nx();
                    const auto s = lattice_.at(((x % nx) + nx) % nx, row).viscous_stress;
                    const Matrix3 m{{{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}}};
                    sum += component(m, ellipsoid.axis[0], ellipsoid.axis[1]);
                    ++count;
                }
            }
        }
        return count > 0 ? sum / count : 0.0;
    }

    const OffsetChannelSetup& setup_;
    NozzleFlow flow_;
    Units lu_;
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
