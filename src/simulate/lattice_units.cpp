#include "simulate/lattice_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulate/message_number.hpp"

namespace bioprint {
namespace {

constexpr double sound_squared = 1.0 / 3.0;
constexpr double largest_wall_reynolds = 5.0;
constexpr double largest_reynolds = 1.0;
constexpr double largest_modulus = 0.2 * sound_squared;
constexpr double largest_velocity = 0.05;
constexpr double softest_cell = 2.5;  ///< G R_c/μ: 2 settles on every lattice, 3.2 breaks on the finest
/// Of the ink around the cell in lattice units: a thinner one hardly damps the waves of a stiff cell.
constexpr double smallest_viscosity = 0.05;
constexpr double most_steps = 1e5;   ///< for each nozzle radius of the way
constexpr double rigid_load = 0.01;  ///< G R_c/μ below which a softer cell bears the same stress
constexpr int smallest_radius = 12;
constexpr int largest_radius = 2000;
constexpr double usual_confinement = 0.16;
constexpr double largest_confinement = 0.6;
/// The steady flow settles soonest when viscous and pressure diffusion take equally long: measured, c = 0.25
/// N.
constexpr double settling_viscosity = 0.25;

LatticeUnits make(const NozzleFlow& flow, int nodes, double velocity_lu, double viscosity_lu) {
    LatticeUnits u{};
    u.radius = nodes;
    u.spacing = flow.radius() / nodes;
    u.velocity_lu = velocity_lu;
    u.viscosity_lu = viscosity_lu;
    u.velocity = flow.velocity_average() / velocity_lu;
    u.time_step = u.spacing / u.velocity;
    u.stress = cross_law(flow.ink()).eta0 / (viscosity_lu * u.time_step);
    const double wall = viscosity(flow.ink(), flow.shear_rate_max()) / cross_law(flow.ink()).eta0;
    u.wall_reynolds = velocity_lu * nodes / (viscosity_lu * wall);
    return u;
}

/// The largest stress that the flow puts on a cell: in the nozzle across its radius, at the exit on a rigid
/// sphere.
double largest_stress(const Scene& scene, const NozzleFlow& flow) {
    const double channel = flow.pressure_gradient() * scene.cell.radius;
    const double rate = flow.velocity_excess() / scene.nozzle_radius;
    const double exit = 2.5 * std::sqrt(3.0) * stress(flow.ink(), std::sqrt(3.0) * rate);
    return scene.kind == SceneKind::channel ? channel : std::max(channel, exit);
}

/// The least viscosity of the ink that touches the cell, over η0.
double viscosity_around(const Scene& scene, const NozzleFlow& flow) {
    double rate = flow.shear_rate(std::min(scene.cell.radius, scene.nozzle_radius));
    if (scene.kind == SceneKind::exit) {
        rate = std::max(rate, std::sqrt(3.0) * flow.velocity_excess() / scene.nozzle_radius);
    }
    return viscosity(flow.ink(), rate) / cross_law(flow.ink()).eta0;
}

}  // namespace

lattice::CrossRelaxation LatticeUnits::relaxation(const Ink& any) const {
    const CrossInk& ink = cross_law(any);
    const double t0 = 3.0 * viscosity_lu;
    return {.t0 = t0,
            .t_inf = t0 * ink.eta_inf / ink.eta0,
            .time_constant = ink.time_constant / time_step,
            .alpha = ink.alpha};
}

LatticeUnits LatticeUnits::with(double new_velocity, double new_viscosity, const NozzleFlow& flow) const {
    return make(flow, radius, new_velocity, new_viscosity);
}

LatticeProfile lattice_profile(const NozzleFlow& flow, const LatticeUnits& units) {
    LatticeProfile p;
    const int n = units.radius;
    double flux = 0.0;
    for (int j = 0; j < n; ++j) {
        const double r = (j + 0.5) * units.spacing;
        p.velocity.push_back(flow.velocity(r) / units.velocity);
        p.slope.push_back(-flow.shear_rate(r) * units.time_step);
        flux += (2.0 * j + 1.0) * p.velocity.back() / (static_cast<double>(n) * n);
    }
    const double exact = units.velocity_lu / flux;
    for (double& u : p.velocity) {
        u *= exact;
    }
    for (int j = 0; j < n; ++j) {
        p.links.push_back(flow.velocity(j * units.spacing) / units.velocity * exact);
    }
    p.links.push_back(0.0);
    p.pressure_gradient = flow.pressure_gradient() * units.spacing / units.stress;
    return p;
}

int layers_for(double resolution, double mesh_spacing) {
    return std::max(2, static_cast<int>(std::lround(resolution / mesh_spacing)));
}

int nodes_for(const Scene& scene, int layers, double mesh_spacing) {
    // Without a cell to resolve, the nozzle is given what it gets around a cell of the usual size.
    const double cell =
        scene.kind == SceneKind::exit_flow ? usual_confinement * scene.nozzle_radius : scene.cell.radius;
    const double nodes = layers * mesh_spacing * scene.nozzle_radius / cell;
    if (nodes > largest_radius) {
        throw UsageError(
            "the cell is " + number(scene.nozzle_radius / cell) + " times smaller than the nozzle: " +
                number(nodes) + " nodes a nozzle radius are more than " + number(largest_radius) +
                "; take --resolution " + number(largest_radius * cell / scene.nozzle_radius) + " or less",
            "--resolution");
    }
    return std::max(smallest_radius, static_cast<int>(std::lround(nodes)));
}

namespace {

/// Units by the limits of lattice_units.hpp, however many steps they take.
LatticeUnits within_limits(const Scene& scene, const NozzleFlow& flow, int nodes,
                           const SimulationOptions& options) {
    const double stiffness = std::max(1.0, options.bulk_modulus_ratio);
    const double wall = viscosity(flow.ink(), flow.shear_rate_max()) / cross_law(flow.ink()).eta0;
    const double reynolds = std::min(largest_reynolds, largest_wall_reynolds * wall);
    // Stresses in lattice units are this times Re ν0²/N².
    const double unit = cross_law(flow.ink()).eta0 * flow.velocity_average() / flow.radius();
    const double n2 = static_cast<double>(nodes) * nodes;
    struct Limit {
        double viscosity;
        const char* name;
    };
    const std::array<Limit, 3> limits{{
        {std::sqrt(options.accuracy * sound_squared * unit / largest_stress(scene, flow) * n2 / reynolds),
         "compression"},
        {std::sqrt(largest_modulus * unit / (stiffness * scene.cell.shear_modulus) * n2 / reynolds),
         "elastic waves"},
        {largest_velocity * nodes / reynolds, "velocity"},
    }};
    const Limit& tightest =
        *std::min_element(limits.begin(), limits.end(),
                          [](const Limit& a, const Limit& b) { return a.viscosity < b.viscosity; });
    // A stiff cell in a slow flow: the viscosity is kept and the flow slowed until the limits hold again.
    const double least = smallest_viscosity / viscosity_around(scene, flow);
    if (tightest.viscosity < least) {
        const double slower = std::pow(tightest.viscosity / least, 2.0);
        LatticeUnits units = make(flow, nodes, slower * reynolds * least / nodes, least);
        units.binding = std::string(tightest.name) + ", viscosity";
        return units;
    }
    LatticeUnits units = make(flow, nodes, reynolds * tightest.viscosity / nodes, tightest.viscosity);
    units.binding =
        reynolds < largest_reynolds ? std::string("unsteadiness, ") + tightest.name : tightest.name;
    return units;
}

double steps_a_radius(const LatticeUnits& units) {
    return units.radius / units.velocity_lu;
}

/// The stiffest softer cell whose run takes no more than `most_steps` a radius; 0 when there is none.
double stiffest_modulus(Scene scene, const NozzleFlow& flow, int nodes, const SimulationOptions& options) {
    constexpr int tenths_of_decades = 120;
    for (int i = 0; i < tenths_of_decades; ++i) {
        scene.cell.shear_modulus *= std::pow(10.0, -0.1);
        if (steps_a_radius(within_limits(scene, flow, nodes, options)) <= most_steps)
            return scene.cell.shear_modulus;
    }
    return 0.0;
}

[[noreturn]] void refuse_duration(const Scene& scene, const NozzleFlow& flow, const LatticeUnits& units,
                                  const SimulationOptions& options) {
    const std::string steps = number(steps_a_radius(units)) +
                              " steps for each nozzle radius of its way, and " + number(most_steps) +
                              " are the limit; ";
    const double modulus = stiffest_modulus(scene, flow, units.radius, options);
    const double load = flow.pressure_gradient() * scene.cell.radius / modulus;
    if (modulus > 0.0 && load < rigid_load) {
        throw UsageError("--shear-modulus: a cell of " + number(scene.cell.shear_modulus) +
                             " Pa in this slow flow would take " + steps + "one of " + number(modulus) +
                             " Pa fits and bears the same stress, for it is all but rigid as well (G R_c/μ " +
                             number(load) + ")",
                         "--shear-modulus");
    }
    const double wall = viscosity(flow.ink(), flow.shear_rate_max()) / cross_law(flow.ink()).eta0;
    throw UsageError("--alpha: the ink's viscosity falls to " + number(wall) +
                         " of its largest at the wall, and a cell would take " + steps +
                         "lower --alpha, --velocity or --time-constant, or ask for --simulate=exit-flow",
                     "--alpha");
}

}  // namespace

LatticeUnits units_for_cell(const Scene& scene, const NozzleFlow& flow, int nodes,
                            const SimulationOptions& options) {
    LatticeUnits units = within_limits(scene, flow, nodes, options);
    if (steps_a_radius(units) > most_steps) refuse_duration(scene, flow, units, options);
    return units;
}

double viscosity_contrast(const Scene& scene, const NozzleFlow& flow) {
    return 1.0 / viscosity_around(scene, flow);
}

LatticeUnits units_for_flow(const NozzleFlow& flow, int nodes) {
    const double apparent = flow.pressure_gradient() * flow.radius() * flow.radius() /
                            (8.0 * flow.velocity_average() * cross_law(flow.ink()).eta0);
    LatticeUnits units = make(flow, nodes, largest_velocity, settling_viscosity * nodes / apparent);
    units.binding = "settling";
    return units;
}

void check(const Scene& scene, const SimulationOptions& options) {
    const auto positive = [](double value, const char* option, const char* what) {
        if (!(value > 0.0) || !std::isfinite(value)) {
            throw UsageError(std::string(option) + ": " + what + " must be positive", option);
        }
    };
    if (scene.kind != SceneKind::shear) {
        positive(scene.nozzle_radius, "--radius", "the nozzle's radius");
        positive(scene.velocity_average, "--velocity", "the average velocity");
    }
    if (!(options.resolution >= 3.0) || options.resolution > 100.0) {
        throw UsageError(
            "--resolution: a cell radius takes 3 to 100 nodes, not " + number(options.resolution),
            "--resolution");
    }
    if (scene.kind == SceneKind::exit_flow) {
        return;
    }
    positive(scene.cell.radius, "--cell-radius", "the cell's radius");
    positive(scene.cell.shear_modulus, "--shear-modulus", "the shear modulus");
    if (scene.kind == SceneKind::shear) {
        positive(scene.fluid_stress, "--fluid-stress", "the ink's stress");
        return;
    }
    if (scene.cell.radius > largest_confinement * scene.nozzle_radius) {
        throw UsageError("--cell-radius: a cell of " + number(scene.cell.radius) +
                             " m is too large for this nozzle; the simulation takes up to " +
                             number(largest_confinement * scene.nozzle_radius) + " m",
                         "--cell-radius");
    }
}

void check_softness(const Scene& scene, const NozzleFlow& flow, const SimulationOptions& options) {
    const double softness = flow.pressure_gradient() * scene.cell.radius / scene.cell.shear_modulus;
    if (options.channel_time > 0.0 || softness <= softest_cell) return;
    throw UsageError(
        "this cell is too soft to keep a shape in this nozzle: G R_c/μ is " + number(softness) +
            " and runs above " + number(softest_cell) +
            " find no steady one; say how long it stays in the nozzle with --channel-time, or take a "
            "shear modulus of " +
            number(scene.cell.shear_modulus * softness / softest_cell) + " Pa or more",
        "--channel-time");
}

}  // namespace bioprint
