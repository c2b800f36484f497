#include <algorithm>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "bioprint/simulate/simulation.hpp"
#include "lattice/axisymmetric_kernel.hpp"
#include "simulate/axis_errors.hpp"
#include "simulate/scenes.hpp"
#include "simulate/space.hpp"

namespace bioprint {
namespace {

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
    const auto found =
        std::find_if(values.begin(), values.end(), [&](const SimulatedValue& v) { return v.name == name; });
    if (found == values.end()) {
        throw UsageError("this simulation has no value named " + name, name);
    }
    return *found;
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
    if (options.estimate_error) hold_against_nozzle(result, flow);
    keeper.close();
    result.wall_time = keeper.elapsed();
    result.updates_per_second = updates / result.wall_time;
    return result;
}

}  // namespace bioprint
