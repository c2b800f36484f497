#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "bioprint/rheology/ink.hpp"
#include "bioprint/simulate/simulation.hpp"
#include "lattice/axisymmetric_kernel.hpp"
#include "simulate/scenes.hpp"
#include "simulate/space.hpp"

namespace bioprint {
namespace {

/// What two resolutions cannot see: the coupling's own error against the exact stiff limit at 6 and 12 nodes.
constexpr double coupling_error = 5e-3;
/// The same of a centred cell in a thinning ink, for each unit of thinning (one less the index at the wall) and of the
/// root of G R_c/μ, times nodes a cell radius: at α 0.75 and 6 nodes, 4.2 % at 0.70 and 2.8 % at 0.27 against 12 nodes;
/// 1.3 % at 0.01, where the first term alone counts.
constexpr double thinning_error = 0.3;
/// Of the shift of the lip.
constexpr double lip_uncertainty = 0.2;
/// Relative errors times nodes a cell radius (squared for the flow), the largest seen on the reference cases.
constexpr double draft_cell_error = 0.35;
constexpr double draft_deformation_error = 1.45;  ///< of a cell that is hardly deformed
/// By how much those grow with G R_c/μ from where on: at 1.2, in a cell of half the nozzle's radius, a stress was 24 % off
/// at 6 nodes.
constexpr double draft_softness = 8.0;
constexpr double draft_softness_from = 0.7;
constexpr double draft_flow_error = 0.05;
/// Of the nozzle's pressure gradient, times nodes a nozzle radius squared: what the extrapolation leaves in a thinning ink.
constexpr double gradient_error = 0.3;

/// Around a stiff cell the viscosity of a thinning ink jumps by the contrast c within less than a spacing. Runs at 3, 6
/// and 12 nodes, G R_c/μ 0.001 to 0.05, c from 2 to 300: stresses of a draft are off by up to 0.35 ln c (nozzle) and
/// 0.65 of that (exit) over the nodes a cell radius.
constexpr double channel_contrast = 1.0;
constexpr double exit_contrast = 0.65;
/// What is left after a comparison of two resolutions, for each unit by which those exceed one.
constexpr double contrast_error = 0.6;
/// Spacings by which the peak of a draft lies too far downstream: 0.5 at α 0, 1.4 at 0.75, 2.0 at 0.9.
constexpr double draft_shift = 0.5;
constexpr double draft_shift_of_alpha = 1.7;

/// The contrast as it tells on a stress; below one it does not.
double contrast_of(const Scene& scene, const NozzleFlow& flow, const std::string& name) {
    const bool peak = name == "von_mises_peak";
    if (!peak && name != "von_mises" && name != "von_mises_channel") return 0.0;
    Scene place = scene;
    place.kind = peak ? SceneKind::exit : SceneKind::channel;
    return (peak ? exit_contrast : channel_contrast) * std::log(viscosity_contrast(place, flow));
}

double draft_error(const Scene& scene, const NozzleFlow& flow, const SimulatedValue& v,
                   const LatticeReport& lattice) {
    const double nodes = lattice.nodes_per_cell_radius;
    if (scene.kind == SceneKind::exit_flow) return draft_flow_error / (nodes * nodes) * std::abs(v.value);
    if (v.name == "peak_position") {
        return (draft_shift + draft_shift_of_alpha * cross_law(scene.ink).alpha) * lattice.spacing;
    }
    const double relative = v.name == "deformation" ? draft_deformation_error : draft_cell_error;
    const double pull = flow.pressure_gradient() * scene.cell.radius / scene.cell.shear_modulus;
    const double softness = 1.0 + draft_softness * std::max(0.0, pull - draft_softness_from);
    return relative * std::max({1.0, softness, contrast_of(scene, flow, v.name)}) / nodes * std::abs(v.value);
}

void run_scene(const Run& run) {
    run.log.result.scene = run.scene.kind;
    switch (run.scene.kind) {
        case SceneKind::exit_flow:
            run_exit_flow(run);
            break;
        case SceneKind::channel:
            run_channel(run);
            break;
        case SceneKind::exit:
        case SceneKind::shear:  // in space, as is a cell off the axis
            run_exit(run);
            break;
    }
}

const SimulatedValue* find(const SimulationResult& result, const std::string& name) {
    const auto found = std::find_if(result.values.begin(), result.values.end(),
                                    [&](const SimulatedValue& v) { return v.name == name; });
    return found == result.values.end() ? nullptr : &*found;
}

/// How a value converges with the lattice spacing, as measured on three resolutions.
enum class Convergence { second_order, first_order, not_extrapolated };

Convergence convergence(SceneKind scene, const std::string& name) {
    if (scene == SceneKind::exit_flow) {
        return Convergence::second_order;
    }
    // In straining flow the coupled cell acts as one 0.14 spacings larger; in the channel no excess is seen.
    const bool strained = name == "von_mises_peak" || name == "stretch_axial_min" ||
                          name == "stretch_radial_max" || name == "peak_position";
    return strained ? Convergence::first_order : Convergence::not_extrapolated;
}

/// What is left after a first-order extrapolation whose coarse run is not yet asymptotic.
double least_strained_error(const SimulationResult& fine, const SimulatedValue& v) {
    if (v.name == "peak_position") {
        return 0.3 * fine.lattice.spacing;
    }
    // A stretch is known by its distance from one, a stress by itself.
    return 0.1 / fine.lattice.nodes_per_cell_radius *
           (v.name == "von_mises_peak" ? std::abs(v.value) : std::abs(v.value - 1.0));
}

/// Of a value that is not extrapolated, relative.
double least_error(const SimulationResult& fine, const SimulatedValue& v, const Scene& scene,
                   const NozzleFlow& flow) {
    if (!v.name.starts_with("von_mises")) return coupling_error;
    const double thinning = 1.0 - flow_index(flow.ink(), flow.shear_rate_max());
    const double pull = flow.pressure_gradient() * scene.cell.radius / scene.cell.shear_modulus;
    return coupling_error * (1.0 + thinning) +
           thinning_error * thinning * std::sqrt(std::min(pull, 1.0)) / fine.lattice.nodes_per_cell_radius;
}

void extrapolate(SimulationResult& fine, const SimulationResult& coarse, const Scene& scene,
                 const NozzleFlow& flow, double ratio) {
    for (SimulatedValue& v : fine.values) {
        const SimulatedValue* c = find(coarse, v.name);
        if (c == nullptr) {
            continue;
        }
        const double difference = v.value - c->value;
        switch (convergence(fine.scene, v.name)) {
            case Convergence::second_order:
                v.value += difference / (ratio * ratio - 1.0);
                v.error = std::abs(difference) / (ratio * ratio - 1.0);
                if (v.name == "pressure_gradient") {
                    v.error = std::max(v.error, gradient_error * std::abs(v.value) /
                                                    std::pow(fine.lattice.nodes_per_radius, 2.0));
                }
                break;
            case Convergence::first_order:
                v.value += difference / (ratio - 1.0);
                v.error = std::max(0.5 * std::abs(difference) / (ratio - 1.0), least_strained_error(fine, v));
                break;
            case Convergence::not_extrapolated:
                v.error = std::max(std::abs(difference) / (ratio * ratio - 1.0),
                                   least_error(fine, v, scene, flow) * std::abs(v.value));
                break;
        }
    }
}

/// A run without a coarser one beside it: relative errors fall with the cell's radius in nodes.
void assume_errors(SimulationResult& result, const Scene& scene, const NozzleFlow& flow) {
    // No reference case is drawn out like that: nothing is known of such a value's error.
    const bool drawn_out =
        std::any_of(result.warnings.begin(), result.warnings.end(),
                    [](const SimulationWarning& warning) { return warning.code == "strong-deformation"; });
    for (SimulatedValue& v : result.values) {
        v.error = draft_error(scene, flow, v, result.lattice);
        if (drawn_out) v.error = std::max(v.error, std::abs(v.value));
    }
}

/// Where the contrast is large neither of two lattices resolves the ink around the cell, and their difference does not
/// tell how far both are off.
void allow_for_contrast(SimulationResult& result, const Scene& scene, const NozzleFlow& flow) {
    for (SimulatedValue& v : result.values) {
        const double excess = contrast_of(scene, flow, v.name) - 1.0;
        const double least = contrast_error * excess / result.lattice.nodes_per_cell_radius;
        v.error = std::max(v.error, least * std::abs(v.value));
    }
}

// The lattice's lip acts as one a fraction of a node farther on, to first order in the spacing: the peak of
// the flow tells how far, and every place is given from the effective lip.
void correct_lip(SimulationResult& fine, const SimulationResult& coarse, double ratio, double gradient) {
    const SimulatedValue* peak = find(fine, "peak_position");
    const SimulatedValue* coarse_peak = find(coarse, "peak_position");
    if (peak == nullptr || coarse_peak == nullptr) {
        return;
    }
    const double shift = (coarse_peak->resolved - peak->resolved) / (ratio - 1.0);
    for (auto& row : fine.series.rows) {
        row[0] -= shift;
    }
    for (SimulatedValue& v : fine.values) {
        if (v.name == "peak_position") {
            v.value = v.resolved - shift;
            v.error = lip_uncertainty * std::abs(shift);
        } else if (v.name == "excess_pressure") {
            v.value = v.resolved - gradient * shift;
            v.error = std::max(v.error, lip_uncertainty * gradient * std::abs(shift));
        }
    }
}

/// Runs `coarse` beside `fine` when two threads are allowed, after it otherwise; the first error wins.
template <class Fine, class Coarse>
void run_both(int threads, const Fine& fine, const Coarse& coarse) {
    if (threads < 2) {
        fine();
        coarse();
        return;
    }
    std::exception_ptr failure;
    std::thread beside([&] {
        try {
            coarse();
        } catch (...) {
            failure = std::current_exception();
        }
    });
    try {
        fine();
    } catch (...) {
        beside.join();
        throw;
    }
    beside.join();
    if (failure) {
        std::rethrow_exception(failure);
    }
}

}  // namespace

const SimulatedValue& SimulationResult::at(const std::string& name) const {
    const SimulatedValue* value = find(*this, name);
    if (value == nullptr) {
        throw UsageError("this simulation has no value named " + name, name);
    }
    return *value;
}

void report(const Run& run, const LatticeUnits& units, int length) {
    LatticeReport& r = run.log.result.lattice;
    r.nodes_per_radius = run.nodes;
    r.length = length;
    r.nodes_per_cell_radius = run.scene.cell.radius / units.spacing;
    r.spacing = units.spacing;
    r.time_step = units.time_step;
    r.velocity = units.velocity_lu;
    r.viscosity = units.viscosity_lu;
    r.wall_reynolds = units.wall_reynolds;
    r.shear_modulus = run.scene.cell.shear_modulus / units.stress;
    r.binding = units.binding;
    r.vector_width = lattice::kernels(units.relaxation(run.flow.ink())).name;
}

namespace {

constexpr int smallest_nodes = 12;  ///< a nozzle radius

}  // namespace

AxisLattices axis_lattices(const Scene& scene, const SimulationOptions& options) {
    const bool with_cell = scene.kind != SceneKind::exit_flow;
    const int wanted = layers_for(options.resolution, options.mesh_spacing);
    // Two resolutions a factor of two apart need twice the smallest lattice.
    const bool two = with_cell && options.estimate_error && wanted / 2 >= 2;
    const int nodes = std::max(nodes_for(scene, wanted, options.mesh_spacing), two ? 2 * smallest_nodes : 0);
    // A narrow nozzle's smallest lattice resolves the cell better than was asked for; the mesh follows.
    const int layers = with_cell
                           ? layers_for(nodes * scene.cell.radius / scene.nozzle_radius, options.mesh_spacing)
                           : wanted;
    const int coarse_layers = layers / 2;
    const int coarse_nodes = with_cell ? nodes_for(scene, coarse_layers, options.mesh_spacing)
                                       : std::max(smallest_nodes, nodes / 2);
    return {.layers = layers,
            .nodes = nodes,
            .coarse_layers = coarse_layers,
            .coarse_nodes = coarse_nodes,
            // A cell takes two layers of elements at least.
            .compare = options.estimate_error && (!with_cell || coarse_layers >= 2) && coarse_nodes < nodes};
}

void check_scene(const Scene& scene, const SimulationOptions& options) {
    check(scene, options);
    if (needs_space(scene)) return check_space(scene, options);
    const NozzleFlow flow = NozzleFlow::from_velocity(scene.ink, scene.nozzle_radius, scene.velocity_average);
    if (scene.kind == SceneKind::exit_flow) {
        (void)axis_lattices(scene, options);
        return;
    }
    check_softness(scene, flow, options);
    const AxisLattices lattices = axis_lattices(scene, options);
    (void)units_for_cell(scene, flow, lattices.nodes, options);
    if (lattices.compare) (void)units_for_cell(scene, flow, lattices.coarse_nodes, options);
}

SimulationResult simulate(const Scene& scene, const SimulationOptions& options) {
    check_scene(scene, options);
    if (needs_space(scene)) {
        return simulate_in_space(scene, options);
    }
    const NozzleFlow flow = NozzleFlow::from_velocity(scene.ink, scene.nozzle_radius, scene.velocity_average);
    const bool with_cell = scene.kind != SceneKind::exit_flow;
    const auto [layers, nodes, coarse_layers, coarse_nodes, compare] = axis_lattices(scene, options);
    Keeper keeper(scene, options);
    RunLog fine(options, keeper, "fine ", true);
    RunLog coarse(options, keeper, "coarse ", false);
    const Run finer{.scene = scene, .flow = flow, .layers = layers, .nodes = nodes, .log = fine};
    const Run coarser{
        .scene = scene, .flow = flow, .layers = coarse_layers, .nodes = coarse_nodes, .log = coarse};
    run_both(
        options.threads, [&] { run_scene(finer); },
        [&, compared = compare] {
            if (compared) run_scene(coarser);
        });
    const double updates = fine.updates + coarse.updates;
    SimulationResult result = std::move(fine.result);
    if (compare) {
        const double ratio = static_cast<double>(nodes) / coarse_nodes;
        extrapolate(result, coarse.result, scene, flow, ratio);
        if (with_cell) allow_for_contrast(result, scene, flow);
        if (!with_cell) {
            correct_lip(result, coarse.result, ratio, flow.pressure_gradient());
        }
        result.steps += coarse.result.steps;
    } else if (options.estimate_error) {
        assume_errors(result, scene, flow);
    }
    keeper.close();
    result.wall_time = keeper.elapsed();
    result.updates_per_second = updates / result.wall_time;
    return result;
}

}  // namespace bioprint
