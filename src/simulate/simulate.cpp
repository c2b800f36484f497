#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "bioprint/simulate/simulation.hpp"
#include "lattice/axisymmetric_kernel.hpp"
#include "simulate/scenes.hpp"

namespace bioprint {
namespace {

/// What two resolutions cannot see: the coupling's own error against the exact stiff limit at 6 and 12 nodes.
constexpr double coupling_error = 5e-3;

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
            run_exit(run);
            break;
    }
}

const SimulatedValue* find(const SimulationResult& result, const std::string& name) {
    const auto found = std::find_if(result.values.begin(), result.values.end(),
                                    [&](const SimulatedValue& v) { return v.name == name; });
    return found == result.values.end() ? nullptr : &*found;
}

/// Both runs are of second order in the spacing: a third of their difference is the finer one's error.
void estimate_errors(SimulationResult& fine, const SimulationResult& coarse, double ratio, bool with_cell) {
    for (SimulatedValue& v : fine.values) {
        if (const SimulatedValue* c = find(coarse, v.name)) {
            v.error = std::abs(v.value - c->value) / (ratio * ratio - 1.0);
            if (with_cell && v.name != "peak_position") {
                v.error = std::max(v.error, coupling_error * std::abs(v.value));
            }
        }
    }
}

// The lattice's lip acts as one a fraction of a node farther on, to first order in the spacing: the peak of
// the flow tells how far, and every place is given from the effective lip.
void correct_lip(SimulationResult& fine, const SimulationResult& coarse, double ratio, double gradient) {
    const SimulatedValue* c = find(coarse, "peak_position");
    for (SimulatedValue& v : fine.values) {
        if (c == nullptr || v.name != "peak_position") {
            continue;
        }
        const double shift = (c->value - v.value) / (ratio - 1.0);
        v.value -= shift;
        v.error = 0.2 * std::abs(shift);
        for (auto& row : fine.series.rows) {
            row[0] -= shift;
        }
        for (SimulatedValue& excess : fine.values) {
            if (excess.name == "excess_pressure") {
                excess.value -= gradient * shift;
                excess.error = std::max(excess.error, 0.2 * std::abs(gradient * shift));
            }
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

SimulationResult simulate(const Scene& scene, const SimulationOptions& options) {
    check(scene, options);
    const auto begin = std::chrono::steady_clock::now();
    const NozzleFlow flow = NozzleFlow::from_velocity(scene.ink, scene.nozzle_radius, scene.velocity_average);
    const int layers = layers_for(options.resolution, options.mesh_spacing);
    const int nodes = nodes_for(scene, layers, options.mesh_spacing);
    const int coarse_layers = std::max(2, layers / 2);
    const int coarse_nodes = layers == 2 ? nodes / 2 : nodes_for(scene, coarse_layers, options.mesh_spacing);
    RunLog fine(options, true);
    RunLog coarse(options, false);
    const bool compare = options.estimate_error && coarse_nodes < nodes;
    run_both(
        options.threads,
        [&] { run_scene({.scene = scene, .flow = flow, .layers = layers, .nodes = nodes, .log = fine}); },
        [&] {
            if (compare) {
                run_scene({.scene = scene,
                           .flow = flow,
                           .layers = coarse_layers,
                           .nodes = coarse_nodes,
                           .log = coarse});
            }
        });
    const double updates = fine.updates + coarse.updates;
    SimulationResult result = std::move(fine.result);
    if (compare) {
        const double ratio = static_cast<double>(nodes) / coarse_nodes;
        const bool with_cell = scene.kind != SceneKind::exit_flow;
        estimate_errors(result, coarse.result, ratio, with_cell);
        if (!with_cell) {
            correct_lip(result, coarse.result, ratio, flow.pressure_gradient());
        }
        result.steps += coarse.result.steps;
    }
    result.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    result.updates_per_second = updates / result.wall_time;
    return result;
}

}  // namespace bioprint
