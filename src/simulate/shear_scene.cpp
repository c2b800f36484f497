#include "simulate/shear_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "simulate/ellipsoid_axes.hpp"
#include "simulate/immersed_body.hpp"
#include "simulate/space_pictures.hpp"

namespace bioprint {

namespace {

// The flow is creeping when steady; on the way there the fluid follows the cell to a per cent at this
// Reynolds number of the cell, γ̇ R²/ν.
constexpr double reynolds = 0.1;
// Shear modulus in lattice units: elastic waves stay slower than sound.
constexpr double stiffest = 0.02;

struct Units {
    double nu;
    double rate;     ///< γ̇ of the lattice
    double modulus;  ///< μ of the lattice
};

Units units(const ShearSceneSetup& setup) {
    const double ratio = setup.fluid_stress / setup.shear_modulus;
    // μ = ν γ̇/ratio with γ̇ = reynolds ν/R²: the viscosity that reaches the stiffest μ, within what a lattice
    // likes.
    const double square = setup.nodes * setup.nodes;
    const double nu = std::clamp(std::sqrt(stiffest * ratio * square / reynolds), 0.1, 1.0);
    const double rate = std::min(reynolds * nu / square, stiffest * ratio / nu);
    return {nu, rate, nu * rate / ratio};
}

void check(const ShearSceneSetup& setup) {
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (!positive(setup.fluid_stress) || !positive(setup.shear_modulus) || !positive(setup.shear_rate)) {
        throw UsageError("the shear scene needs a fluid stress, a shear modulus and a shear rate above 0");
    }
    if (!(setup.alpha >= 0.0 && setup.alpha <= 1.0) || !(setup.reduced_rate >= 0.0)) {
        throw UsageError("the ink of the shear scene takes an exponent from 0 to 1 and a rate of 0 or more");
    }
    if (!(setup.nodes >= 2.5 && setup.nodes <= 40.0)) {
        throw UsageError("the shear scene resolves a cell radius by 2.5 to 40 nodes");
    }
    for (const double side : setup.box) {
        if (!(side >= 3.0 && side <= 100.0)) {
            throw UsageError("the box of the shear scene is 3 to 100 cell radii wide");
        }
    }
}

constexpr std::size_t samples_a_unit = 20;  ///< of γ̇ t

class ShearRun {
  public:
    explicit ShearRun(const ShearSceneSetup& setup)
        : setup_(setup),
          lu_(units(setup)),
          lattice_(lattice_setup()),
          cell_({.radius = setup.nodes,
                 .spacing = setup.mesh_spacing,
                 .inside = setup.inside,
                 .shear_modulus = lu_.modulus},
                lattice_, {0.5 * lattice_.nx(), 0.0, 0.0}),
          rest_(mirror_ellipsoid(cell_.state().ellipsoid)),
          stress_(setup.fluid_stress / (lu_.nu * lu_.rate)),
          time_(lu_.rate / setup.shear_rate) {
        lattice_.initialise([&](double, double y, double) {
            return FlowState{.velocity = {lu_.rate * y, 0.0, 0.0},
                             .strain_rate = {0.0, 0.0, 0.0, 0.5 * lu_.rate, 0.0, 0.0}};
        });
        if (const auto* values = setup.watch.kept("shear")) {
            resume(*values);
        }
    }

    ShearSceneResult run() {
        const long sample = std::max<long>(2, std::lround(0.5 / samples_a_unit / lu_.rate) * 2);
        try {
            bool ended = is_over();
            while (!ended && result_.stopped.empty()) {
                advance(sample);
                observe();
                ended = is_over();
                const auto picture = [this] {
                    return space_picture(lattice_, cell_, scale(), result_.series.back().time);
                };
                if (!setup_.watch.attend("shear", ended ? 1.0 : fraction(), ended, picture,
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
    [[nodiscard]] D3q19Setup lattice_setup() const {
        const double r = setup_.nodes;
        const int ny = static_cast<int>(std::lround(setup_.box[1] * r));
        const double plate = 0.5 * lu_.rate * ny;
        return {.nx = std::max(16, static_cast<int>(std::lround(setup_.box[0] * r / 16.0)) * 16),
                .section = plates(ny, static_cast<int>(std::lround(0.5 * setup_.box[2] * r)), -plate, plate,
                                  Sides::mirrors),
                .viscosity = ink(),
                .threads = setup_.threads};
    }

    /// The ink whose viscosity at the undisturbed rate is `nu`.
    [[nodiscard]] LatticeViscosity ink() const {
        if (setup_.reduced_rate == 0.0) {
            return {.nu0 = lu_.nu};
        }
        return {.nu0 = lu_.nu * (1.0 + std::pow(setup_.reduced_rate, setup_.alpha)),
                .time_constant = setup_.reduced_rate / lu_.rate,
                .alpha = setup_.alpha};
    }

    [[nodiscard]] std::array<double, 3> stretches(const MirrorEllipsoid& e) const {
        return {e.semi_axes[0] / rest_.semi_axes[0], e.semi_axes[1] / rest_.semi_axes[1],
                e.semi_axes[2] / rest_.semi_axes[2]};
    }

    void advance(long steps) {
        for (long i = 0; i < steps; ++i) {
            cell_.load();
            lattice_.step();
            cell_.move();
        }
        result_.steps += steps;
    }

    /// Leaves the state of the cell in the result, so that a later break finds the last sound one there.
    void observe() {
        const SolidState state = cell_.state();
        if (!std::isfinite(state.von_mises)) {
            throw NotConverged("the shear scene lost its numbers");
        }
        const MirrorEllipsoid now = mirror_ellipsoid(state.ellipsoid);
        const Matrix3 gradient = cell_.solid().mean_gradient(cell_.positions(), cell_.velocities());
        result_.stretch = stretches(now);
        result_.angle = now.angle;
        result_.von_mises = state.von_mises * stress_;
        result_.volume = state.volume / cell_.solid().rest_volume();
        const double mean = (state.stress[0][0] + state.stress[1][1] + state.stress[2][2]) / 3.0;
        for (int k = 0; k < 3; ++k) {
            result_.elastic[k] = (component(state.stress, now.axis[k], now.axis[k]) - mean) * stress_;
        }
        result_.frequency = tank_treading_frequency(gradient, now) / time_;
        // Inside, the gradient is nearly uniform, and so is the viscosity.
        const double shear =
            component(gradient, now.axis[0], now.axis[1]) + component(gradient, now.axis[1], now.axis[0]);
        result_.viscous = ink().at(std::abs(shear)) * shear * stress_;
        add({result_.steps * time_, result_.von_mises, result_.stretch, result_.angle});
    }

    void add(const ShearSample& sample) {
        result_.series.push_back(sample);
        result_.peak_von_mises = std::max(result_.peak_von_mises, sample.von_mises);
        const std::size_t n = result_.series.size();
        if (n > 2 * samples_a_unit) {
            const ShearSample& before = result_.series[n - 1 - samples_a_unit];
            result_.steady = std::abs(sample.von_mises / before.von_mises - 1.0) < setup_.steady &&
                             std::abs(sample.angle - before.angle) < 10.0 * setup_.steady;
        }
    }

    [[nodiscard]] SpaceScale scale() const {
        const double spacing = setup_.cell_radius / setup_.nodes;
        return {.spacing = spacing,
                .time = time_,
                .stress = stress_,
                .offset = -0.5 * lattice_.nx() * spacing,
                .centred = true};
    }

    [[nodiscard]] double fraction() const { return result_.steps * lu_.rate / setup_.longest; }
    [[nodiscard]] bool is_over() const { return result_.steady || fraction() >= 1.0; }

    [[nodiscard]] Record record() const {
        Record r;
        r.put(static_cast<double>(result_.steps));
        r.put(result_.frequency);
        r.put(result_.viscous);
        r.put(result_.volume);
        r.put(result_.elastic);
        r.put(static_cast<double>(result_.series.size()));
        for (const ShearSample& s : result_.series) {
            r.put(s.time);
            r.put(s.von_mises);
            r.put(s.stretch);
            r.put(s.angle);
        }
        r.put(cell_.record());
        r.put(lattice_.state());
        return r;
    }

    void resume(const std::vector<double>& values) {
        Record r(values);
        result_.steps = static_cast<long>(r.next());
        result_.frequency = r.next();
        result_.viscous = r.next();
        result_.volume = r.next();
        result_.elastic = r.next_three();
        for (auto n = static_cast<long>(r.next()); n > 0; --n) {
            const double time = r.next();
            const double von_mises = r.next();
            const std::array<double, 3> stretch = r.next_three();
            add({time, von_mises, stretch, r.next()});
        }
        if (!result_.series.empty()) {
            result_.stretch = result_.series.back().stretch;
            result_.angle = result_.series.back().angle;
            result_.von_mises = result_.series.back().von_mises;
        }
        cell_.restore(r.next_list());
        lattice_.restore(r.next_list());
    }

    void report() {
        const double r = setup_.nodes;
        result_.box = {lattice_.nx() / r, lattice_.section().ny / r, 2 * lattice_.section().nz / r};
        result_.nodes = lattice_.fluid_nodes();
        result_.length = lattice_.nx();
        result_.time_step = time_;
        result_.viscosity = lu_.nu;
        result_.shear_modulus = lu_.modulus;
    }

    const ShearSceneSetup& setup_;
    Units lu_;
    D3q19<double> lattice_;
    ImmersedBody<double> cell_;
    MirrorEllipsoid rest_;
    double stress_;  ///< [Pa] a lattice unit
    double time_;    ///< [s] a step
    ShearSceneResult result_{};
};

}  // namespace

ShearSceneSteps shear_scene_steps(const ShearSceneSetup& setup) {
    const double rate = units(setup).rate;
    const auto side = [&](int k) {
        return std::lround(setup.box[static_cast<std::size_t>(k)] * setup.nodes);
    };
    const long length = std::max(16L, std::lround(setup.box[0] * setup.nodes / 16.0) * 16);
    return {.fewest = std::lround(std::min(2.0, setup.longest) / rate),
            .most = std::lround(setup.longest / rate),
            .nodes = length * side(1) * std::lround(0.5 * static_cast<double>(side(2)))};
}

ShearSceneResult run_shear_scene(const ShearSceneSetup& setup) {
    check(setup);
    return ShearRun(setup).run();
}

}  // namespace bioprint
