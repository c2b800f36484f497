#include "simulate/shear_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "simulate/ellipsoid_axes.hpp"
#include "simulate/immersed_body.hpp"

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
    if (!(setup.nodes >= 2.5 && setup.nodes <= 40.0)) {
        throw UsageError("the shear scene resolves a cell radius by 2.5 to 40 nodes");
    }
    for (const double side : setup.box) {
        if (!(side >= 3.0 && side <= 100.0)) {
            throw UsageError("the box of the shear scene is 3 to 100 cell radii wide");
        }
    }
}

}  // namespace

ShearSceneResult run_shear_scene(const ShearSceneSetup& setup) {
    check(setup);
    const Units lu = units(setup);
    const double r = setup.nodes;
    const int nx = std::max(16, static_cast<int>(std::lround(setup.box[0] * r / 16.0)) * 16);
    const int ny = static_cast<int>(std::lround(setup.box[1] * r));
    const int nz = static_cast<int>(std::lround(0.5 * setup.box[2] * r));
    const double plate = 0.5 * lu.rate * ny;
    D3q19<double> lattice({.nx = nx,
                           .section = plates(ny, nz, -plate, plate, Sides::mirrors),
                           .viscosity = {.nu0 = lu.nu},
                           .threads = setup.threads});
    lattice.initialise([&](double, double y, double) {
        return FlowState{.velocity = {lu.rate * y, 0.0, 0.0},
                         .strain_rate = {0.0, 0.0, 0.0, 0.5 * lu.rate, 0.0, 0.0}};
    });
    ImmersedBody<double> cell(
        {.radius = r, .spacing = setup.mesh_spacing, .inside = setup.inside, .shear_modulus = lu.modulus},
        lattice, {0.5 * nx, 0.0, 0.0});

    const double stress = setup.fluid_stress / (lu.nu * lu.rate);  // Pa a lattice unit
    const double time = lu.rate / setup.shear_rate;                // s a step
    const MirrorEllipsoid rest = mirror_ellipsoid(cell.state().ellipsoid);
    const auto stretches = [&](const MirrorEllipsoid& e) {
        return std::array<double, 3>{e.semi_axes[0] / rest.semi_axes[0], e.semi_axes[1] / rest.semi_axes[1],
                                     e.semi_axes[2] / rest.semi_axes[2]};
    };
    ShearSceneResult result{};
    result.box = {nx / r, ny / r, 2 * nz / r};
    result.nodes = lattice.fluid_nodes();
    const long sample = std::max<long>(2, std::lround(0.05 / lu.rate / 2) * 2);
    const long samples_a_unit = 20;
    SolidState state = cell.state();
    while (result.steps * lu.rate < setup.longest) {
        for (long i = 0; i < sample; ++i) {
            cell.load();
            lattice.step();
            cell.move();
        }
        result.steps += sample;
        state = cell.state();
        if (!std::isfinite(state.von_mises)) {
            throw NotConverged("the shear scene lost its numbers");
        }
        const MirrorEllipsoid now = mirror_ellipsoid(state.ellipsoid);
        result.series.push_back({result.steps * time, state.von_mises * stress, stretches(now), now.angle});
        result.peak_von_mises = std::max(result.peak_von_mises, state.von_mises * stress);
        const std::size_t n = result.series.size();
        if (n > 2 * samples_a_unit) {
            const double before = result.series[n - 1 - samples_a_unit].von_mises;
            const double angle = result.series[n - 1 - samples_a_unit].angle;
            result.steady = std::abs(result.series.back().von_mises / before - 1.0) < setup.steady &&
                            std::abs(now.angle - angle) < 10.0 * setup.steady;
            if (result.steady) {
                break;
            }
        }
    }
    const MirrorEllipsoid end = mirror_ellipsoid(state.ellipsoid);
    const Matrix3 gradient = cell.solid().mean_gradient(cell.positions(), cell.velocities());
    result.stretch = stretches(end);
    result.angle = end.angle;
    result.von_mises = state.von_mises * stress;
    result.volume = state.volume / cell.solid().rest_volume();
    const double mean = (state.stress[0][0] + state.stress[1][1] + state.stress[2][2]) / 3.0;
    for (int k = 0; k < 3; ++k) {
        result.elastic[k] = (component(state.stress, end.axis[k], end.axis[k]) - mean) * stress;
    }
    result.frequency = tank_treading_frequency(gradient, end) / time;
    result.viscous =
        lu.nu *
        (component(gradient, end.axis[0], end.axis[1]) + component(gradient, end.axis[1], end.axis[0])) *
        stress;
    return result;
}

}  // namespace bioprint
