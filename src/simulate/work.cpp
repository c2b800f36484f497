#include "bioprint/simulate/work.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/exit_field.hpp"
#include "simulate/offset_view.hpp"
#include "simulate/scenes.hpp"
#include "simulate/shear_scene.hpp"
#include "simulate/space.hpp"

namespace bioprint {
namespace {

/// Node updates of a run, at least and at most, and the nodes of its largest stage.
struct Updates {
    double least = 0.0;
    double most = 0.0;
    double nodes = 0.0;

    void add(double fewest_steps, double most_steps, double lattice) {
        least += fewest_steps * lattice;
        most += most_steps * lattice;
        nodes = std::max(nodes, lattice);
    }
    void add(const Updates& other) {
        least += other.least;
        most += other.most;
        nodes += other.nodes;  // both are held at once
    }
};

/// Node updates a second of processor time, with the cell: 63 to 240 million were seen on the axis, 37 to 120 in space and
/// 23 to 67 in the shear scene, whose fluid is in double precision; the least of them with two threads that wait for each
/// other on a busy machine.
constexpr double fastest_on_axis = 2.4e8;
constexpr double slowest_on_axis = 0.6e8;
constexpr double fastest_in_space = 1.3e8;
constexpr double slowest_in_space = 0.35e8;
constexpr double slowest_in_shear = 0.2e8;
/// Bytes a node beside those of the program, from the memory of every scene at 3, 6 and 12 nodes a cell radius.
constexpr double program = 13e6;
constexpr double exit_start = 8e6;  ///< of an exit in space: the flow in the plane that it starts from
constexpr double bytes_on_axis = 320.0;
constexpr double bytes_in_space = 161.0;
constexpr double bytes_in_shear = 300.0;  ///< in double precision

/// Steps of a flow through the exit until it is steady, over the nodes a nozzle radius: 170 to 600 in a Newtonian ink;
/// the thinner the ink at the wall, the longer. Measured at α 0 to 0.95, K u/R 1 to 1e4, 19 to 75 nodes.
constexpr double shortest_settling = 120.0;
constexpr double longest_settling = 650.0;
constexpr double settling_by_thinning = 90.0;  ///< times (η0/η_wall)^½
constexpr double least_by_thinning = 10.0;     ///< of a flow that settles all the way, times as much over …
constexpr double little_thinning = 5.0;        ///< … this

constexpr int fewest_samples = 5;  ///< of a channel on the axis
constexpr double passage_in_radii = 4.5;
constexpr double longest_strand = 200.0;       ///< radii, on the axis
constexpr double strand_in_relaxations = 5.0;  ///< a decay to 4 % takes 3.2
constexpr double fewest_samples_in_space = 24.0;
constexpr double most_samples_in_space = 8.0 * 16.0;  ///< 12.4 windows were the most seen
constexpr double longest_in_radii = 40.0;

double relaxation(const Scene& scene, double step) {
    return 2.5 * viscosity(scene.ink, 0.0) / scene.cell.shear_modulus / step;
}

void add_flow(Updates& work, const Scene& scene, const NozzleFlow& flow, int nodes) {
    const ExitReach reach = exit_reach(scene.ink);
    const double lattice = (reach.upstream + reach.downstream) * nodes * nodes;
    const double thinning = std::sqrt(scene.ink.eta0 / viscosity(scene.ink, flow.shear_rate_max()));
    const bool alone = scene.kind == SceneKind::exit_flow;
    const double least =
        shortest_settling + (alone ? least_by_thinning * std::max(0.0, thinning - little_thinning) : 0.0);
    work.add(least * nodes, (longest_settling + settling_by_thinning * thinning) * nodes, lattice);
}

Updates run_on_axis(const Scene& scene, const NozzleFlow& flow, int nodes, const SimulationOptions& options) {
    Updates work;
    if (scene.kind == SceneKind::exit_flow) {
        add_flow(work, scene, flow, nodes);
        return work;
    }
    const LatticeUnits units = units_for_cell(scene, flow, nodes, options);
    const ChannelSteps steps = channel_steps(scene, flow, units, options);
    const auto most = static_cast<double>(steps.most + steps.sample);
    const double least = options.channel_time > 0.0
                             ? static_cast<double>(steps.most)
                             : static_cast<double>(std::max(fewest_samples * steps.sample, steps.rest));
    work.add(std::min(least, most), most, static_cast<double>(channel_length(nodes)) * nodes);
    if (scene.kind == SceneKind::channel) return work;
    add_flow(work, scene, flow, nodes);
    const ExitReach reach = exit_reach(scene.ink);
    const double transit = nodes / units.velocity_lu;
    const double passage = passage_in_radii * transit;
    work.add(passage * scene.velocity_average / flow.velocity_max(), passage,
             (reach.upstream + reach.downstream) * nodes * nodes);
    const double strand =
        std::min(longest_strand * transit, strand_in_relaxations * relaxation(scene, units.time_step));
    work.add(0.0, strand, 3.0 * nodes * nodes);
    return work;
}

Updates on_axis(const Scene& scene, const SimulationOptions& options) {
    const NozzleFlow flow = NozzleFlow::from_velocity(scene.ink, scene.nozzle_radius, scene.velocity_average);
    const AxisLattices lattices = axis_lattices(scene, options);
    Updates work = run_on_axis(scene, flow, lattices.nodes, options);
    if (lattices.compare) work.add(run_on_axis(scene, flow, lattices.coarse_nodes, options));
    return work;
}

Updates run_shear(const Scene& scene, double nodes) {
    const double ratio = scene.fluid_stress / scene.cell.shear_modulus;
    const ShearSceneSteps steps = shear_scene_steps({.fluid_stress = scene.fluid_stress,
                                                     .shear_modulus = scene.cell.shear_modulus,
                                                     .shear_rate = 1.0,
                                                     .nodes = nodes,
                                                     .longest = longest_shear(ratio)});
    Updates work;
    work.add(static_cast<double>(steps.fewest), static_cast<double>(steps.most),
             static_cast<double>(steps.nodes));
    return work;
}

Updates run_in_space(const Scene& scene, double nodes, const SimulationOptions& options) {
    if (scene.kind == SceneKind::shear) return run_shear(scene, nodes);
    const NozzleFlow flow = NozzleFlow::from_velocity(scene.ink, scene.nozzle_radius, scene.velocity_average);
    const OffsetUnits units = offset_units({scene.cell.radius, scene.cell.shear_modulus, nodes}, flow);
    const double transit = scene.nozzle_radius / scene.velocity_average / units.time;
    const double given = options.channel_time / units.time;
    const OffsetChannelSteps steps =
        offset_channel_steps({.ink = scene.ink,
                              .radius = scene.nozzle_radius,
                              .velocity_average = scene.velocity_average,
                              .cell_radius = scene.cell.radius,
                              .shear_modulus = scene.cell.shear_modulus,
                              .offset = scene.offset,
                              .duration = longest_in_radii * transit * units.time,
                              .settle_tolerance = options.settle_tolerance},
                             flow, units);
    const auto sample = static_cast<double>(steps.sample);
    const double most = std::min(static_cast<double>(steps.most), most_samples_in_space * sample) + sample;
    const double radius = scene.nozzle_radius / units.spacing;
    const double section = 0.5 * std::numbers::pi * radius * radius;
    Updates work;
    work.add(given > 0.0 ? given : std::min(fewest_samples_in_space * sample, most),
             given > 0.0 ? given : most, section * std::max(16.0, 10.0 * nodes));
    if (scene.kind == SceneKind::channel) return work;
    // The flow at rest, then the cell within a window that goes with it, then the strand.
    const double length = 7.0 * radius;
    const double passage = 4.0 * transit;
    work.add(6.0 * std::max(20.0, radius), 60.0 * std::max(20.0, radius), section * length);
    work.add(passage * scene.velocity_average / flow.velocity_max(), passage,
             section * std::min(length, 2.0 * radius + 2.0 * nodes + 24.0));
    work.add(0.0, strand_in_relaxations * relaxation(scene, units.time),
             section * std::max(16.0, 10.0 * nodes));
    work.nodes = section * length;
    return work;
}

Updates in_space(const Scene& scene, const SimulationOptions& options) {
    const SpaceLattices lattices = space_lattices(scene, options);
    Updates work = run_in_space(scene, lattices.nodes, options);
    const double nodes = work.nodes;
    if (lattices.compare) work.add(run_in_space(scene, lattices.coarse_nodes, options));
    work.nodes = nodes;  // the coarse run comes after the fine one
    return work;
}

}  // namespace

SimulationWork expected_work(const Scene& scene, const SimulationOptions& options) {
    check_scene(scene, options);
    if (!needs_space(scene)) {
        const Updates work = on_axis(scene, options);
        return {.least = work.least / fastest_on_axis,
                .most = work.most / slowest_on_axis,
                .memory = program + bytes_on_axis * work.nodes};
    }
    const Updates work = in_space(scene, options);
    const bool shear = scene.kind == SceneKind::shear;
    return {.least = work.least / fastest_in_space,
            .most = work.most / (shear ? slowest_in_shear : slowest_in_space),
            .memory = program + (scene.kind == SceneKind::exit ? exit_start : 0.0) +
                      (shear ? bytes_in_shear : bytes_in_space) * work.nodes};
}

}  // namespace bioprint
