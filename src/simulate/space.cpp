#include "simulate/space.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <string_view>

#include "bioprint/flow/nozzle_flow.hpp"
#include "lattice/d3q19_kernel.hpp"
#include "simulate/lattice_units.hpp"
#include "simulate/message_number.hpp"
#include "simulate/offset_exit_scene.hpp"
#include "simulate/run_log.hpp"
#include "simulate/shear_scene.hpp"
#include "simulate/space_errors.hpp"
#include "simulate/space_limits.hpp"

namespace bioprint {
namespace {

constexpr double coarsest = 3.0;    ///< nodes a cell radius
constexpr double narrowest = 12.5;  ///< nodes a nozzle radius; at 8 a draft's stress was off by 18 to 22 %
constexpr double nodes_a_thread = 5e4;     ///< fewer lose more by waiting than a second thread wins
constexpr double longest_in_radii = 40.0;  ///< of travel until the shape must be steady
constexpr std::size_t averaged = 8;        ///< samples of a velocity
constexpr double gap_in_nodes = 1.5;       ///< between cell and wall at the start
constexpr double most_nodes = 4e7;         ///< 90 bytes each
constexpr double finest = 40.0;            ///< nodes a cell radius
/// σ_f/μ in shear. Below, the lattice resolves the cell's slow turning in ever more steps, and a draft's viscous stress
/// is 15 % off at 0.004 and 27 % at 0.003; above, elements of 3 nodes a
/// radius give a stress that is wrong by 14 % at 2.5 and by 54 % at 2.8, and from 3 on turn inside out.
constexpr double least_shear_load = 6e-3;
constexpr double most_shear_load = 2.2;
constexpr double most_shear_load_refined = 2.5;  ///< from 6 nodes on: 1.8 % off there, and at 4 inside out
constexpr double largest_volume_drift = 0.02;

struct SpaceRun {
    const Scene& scene;
    double nodes;  ///< a cell radius
    int threads;
    RunLog& log;
};

/// What the scenes tell their runner goes to the log.
SceneWatch watch_of(const SpaceRun& run) {
    return {.progress =
                [&run](const char* stage, double fraction) {
                    run.log.progress(stage, fraction);
                    return !run.log.cancelled();
                },
            .keep = [&run](const char* stage, bool finished,
                           const std::function<Record()>& state) { run.log.keep(stage, finished, state); },
            .picture =
                [&run](const char* stage, double fraction, bool finished,
                       const std::function<SimulationSnapshot()>& take) {
                    // The exit's film begins with the cell before the lip, and so does its series.
                    const bool before =
                        run.scene.kind == SceneKind::exit && std::string_view(stage) == "channel";
                    if (!before) {
                        run.log.picture(stage, fraction, finished, take);
                    }
                },
            .found = [&run](const char* stage) { return run.log.found(stage); }};
}

void leave_stretch(RunLog& log, const std::array<double, 3>& stretch) {
    log.value("stretch.0", stretch[0]);
    log.value("stretch.1", stretch[1]);
    log.value("stretch.2", stretch[2]);
}

void leave_lattice(const SpaceRun& run, const OffsetLattice& lattice) {
    LatticeReport& r = run.log.result.lattice;
    r = {.nodes_per_radius = static_cast<int>(std::lround(lattice.radius)),
         .length = lattice.length,
         .nodes_per_cell_radius = run.nodes,
         .spacing = lattice.spacing,
         .time_step = lattice.time_step,
         .velocity = lattice.velocity,
         .viscosity = lattice.viscosity,
         .wall_reynolds = lattice.wall_reynolds,
         .shear_modulus = lattice.shear_modulus,
         .binding = lattice.binding,
         .vector_width = d3q19::best_instruction_set()};
}

void warn_of_volume(RunLog& log, double volume) {
    if (std::abs(volume - 1.0) > largest_volume_drift) {
        log.warn("volume-drift", "the cell's volume changed by more than 2 %");
    }
}

void run_shear(const SpaceRun& run) {
    const Scene& scene = run.scene;
    const double rate = rate_at_stress(scene.ink, scene.fluid_stress);
    const double ratio = scene.fluid_stress / scene.cell.shear_modulus;
    const ShearSceneResult r = run_shear_scene({.fluid_stress = scene.fluid_stress,
                                                .shear_modulus = scene.cell.shear_modulus,
                                                .shear_rate = rate,
                                                .cell_radius = scene.cell.radius,
                                                .nodes = run.nodes,
                                                .longest = longest_shear(ratio),
                                                .threads = run.threads,
                                                .watch = watch_of(run)});
    RunLog& log = run.log;
    log.count(r.steps, static_cast<double>(r.nodes));
    log.result.lattice = {.length = r.length,
                          .nodes_per_cell_radius = run.nodes,
                          .spacing = scene.cell.radius / run.nodes,
                          .time_step = r.time_step,
                          .viscosity = r.viscosity,
                          .shear_modulus = r.shear_modulus,
                          .binding = "unsteadiness",
                          .vector_width = d3q19::best_instruction_set()};
    log.result.series.columns = {"time [s]",  "von_mises [Pa]", "stretch_1",
                                 "stretch_2", "stretch_3",      "angle [rad]"};
    for (const ShearSample& s : r.series) {
        log.result.series.rows.push_back(
            {s.time, s.von_mises, s.stretch[0], s.stretch[1], s.stretch[2], s.angle});
    }
    if (!r.series.empty()) {
        leave_stretch(log, r.stretch);
        log.value("angle", r.angle);
        log.value("frequency", r.frequency);
        log.value("von_mises", r.von_mises);
        log.value("viscous", r.viscous);
        warn_of_volume(log, r.volume);
    }
    if (!r.stopped.empty()) {
        log.stop(r.stopped);
    }
    if (!r.steady) {
        log.warn("shear-not-steady", "the cell's shape is not yet steady; the values are those reached");
    }
}

/// Mean of a velocity over the last samples, which the lattice's spacing makes swing.
double recent(const std::vector<OffsetChannelSample>& series, double OffsetChannelSample::*velocity) {
    const std::size_t count = std::min(averaged, series.size());
    const auto first = series.end() - static_cast<std::ptrdiff_t>(count);
    return std::accumulate(first, series.end(), 0.0,
                           [&](double sum, const OffsetChannelSample& s) { return sum + s.*velocity; }) /
           static_cast<double>(count);
}

void leave_channel(const SpaceRun& run, const OffsetChannelResult& r) {
    RunLog& log = run.log;
    log.result.series.columns = {"time [s]",
                                 "x [m]",
                                 "r [m]",
                                 "von_mises [Pa]",
                                 "fluid_stress [Pa]",
                                 "stretch_1",
                                 "stretch_2",
                                 "stretch_3",
                                 "angle [rad]",
                                 "frequency [1/s]",
                                 "volume",
                                 "viscous [Pa]",
                                 "pressure_gradient [Pa/m]"};
    for (const OffsetChannelSample& s : r.series) {
        // The ink is slower outside: the cell leans against the flow, which counts as positive as in a shear flow.
        log.result.series.rows.push_back({s.time, s.path, s.offset, s.von_mises, s.fluid_stress, s.stretch[0],
                                          s.stretch[1], s.stretch[2], -s.angle, s.frequency, s.volume,
                                          s.viscous, s.pressure_gradient});
    }
    if (r.series.empty()) {
        return;
    }
    const OffsetChannelSample& end = r.series.back();
    log.value("von_mises", end.von_mises);
    leave_stretch(log, end.stretch);
    log.value("angle", -end.angle);
    log.value("frequency", end.frequency);
    log.value("cell_velocity", recent(r.series, &OffsetChannelSample::velocity));
    log.value("radial_position", end.offset);
    log.value("migration_velocity", recent(r.series, &OffsetChannelSample::migration));
    log.result.fluid_stress = end.fluid_stress;
    log.result.shear_rate = rate_at_stress(run.scene.ink, end.fluid_stress);
    warn_of_volume(log, end.volume);
}

double longest_channel(const SpaceRun& run) {
    const double given = run.log.options().channel_time;
    return given > 0.0 ? given : longest_in_radii * run.scene.nozzle_radius / run.scene.velocity_average;
}

/// The spread over two response times of a stress that is still as far from its limit as the options allow: some
/// e² − 1 times that, less what the lattice makes it swing.
double channel_tolerance(const SpaceRun& run) {
    constexpr double spread = 4.0;
    return run.log.options().channel_time > 0.0 ? 0.0 : spread * run.log.options().settle_tolerance;
}

void warn_unless_steady(const SpaceRun& run, const OffsetChannelResult& r) {
    if (channel_tolerance(run) > 0.0 && !r.steady) {
        run.log.warn("channel-not-steady", "the cell's shape in the nozzle has no steady state within " +
                                               std::to_string(static_cast<int>(longest_in_radii)) +
                                               " radii of travel; the values are those reached there");
    }
}

void run_channel_in_space(const SpaceRun& run) {
    const Scene& scene = run.scene;
    const OffsetChannelResult r =
        run_offset_channel({.ink = scene.ink,
                            .radius = scene.nozzle_radius,
                            .velocity_average = scene.velocity_average,
                            .cell_radius = scene.cell.radius,
                            .shear_modulus = scene.cell.shear_modulus,
                            .offset = scene.offset,
                            .duration = longest_channel(run),
                            .settle_tolerance = channel_tolerance(run),
                            .drive = scene.drive == ChannelDrive::flow_rate ? OffsetDrive::constant_flow_rate
                                                                            : OffsetDrive::constant_gradient,
                            .nodes = run.nodes,
                            .inside = run.log.options().coupling == CellCoupling::inside_elements,
                            .threads = run.threads,
                            .watch = watch_of(run)});
    run.log.count(r.steps, static_cast<double>(r.nodes));
    leave_lattice(run, r.lattice);
    leave_channel(run, r);
    if (!r.stopped.empty()) {
        run.log.stop(r.stopped);
    }
    warn_unless_steady(run, r);
}

void leave_exit(const SpaceRun& run, const OffsetExitResult& r) {
    RunLog& log = run.log;
    log.result.series.columns = {"time [s]",      "x [m]",          "r [m]",     "von_mises [Pa]",
                                 "stretch_axial", "stretch_radial", "stretch_1", "stretch_2",
                                 "stretch_3",     "angle [rad]",    "volume"};
    for (const OffsetExitSample& s : r.series) {
        log.result.series.rows.push_back({s.time, s.position, s.offset, s.von_mises, s.axial, s.radial,
                                          s.stretch[0], s.stretch[1], s.stretch[2], -s.angle, s.volume});
    }
    if (r.channel_von_mises > 0.0) {
        log.value("von_mises_channel", r.channel_von_mises);
    }
    if (r.series.empty()) {
        return;
    }
    log.value("von_mises_peak", r.peak_von_mises);
    log.value("stretch_axial_min", r.axial_min);
    log.value("stretch_radial_max", r.radial_max);
    log.value("peak_position", r.peak_position);
    warn_of_volume(log, r.series.back().volume);
    if (r.relaxation_time) {
        log.value("relaxation_time", *r.relaxation_time);
    } else if (r.complete) {
        log.warn("no-relaxation-time", "the stress did not fall from a half to a twentieth of its peak");
    }
}

void run_exit_in_space(const SpaceRun& run) {
    const Scene& scene = run.scene;
    const OffsetExitResult r = run_offset_exit({.ink = scene.ink,
                                                .radius = scene.nozzle_radius,
                                                .velocity_average = scene.velocity_average,
                                                .cell_radius = scene.cell.radius,
                                                .shear_modulus = scene.cell.shear_modulus,
                                                .offset = scene.offset,
                                                .settle = longest_channel(run),
                                                .settle_tolerance = channel_tolerance(run),
                                                .nodes = run.nodes,
                                                .threads = run.threads,
                                                .watch = watch_of(run)});
    run.log.result.steps = r.steps;
    run.log.updates = r.updates;
    leave_lattice(run, r.lattice);
    if (!r.channel.series.empty()) {
        run.log.result.fluid_stress = r.channel.series.back().fluid_stress;
        run.log.result.shear_rate = rate_at_stress(scene.ink, run.log.result.fluid_stress);
    }
    leave_exit(run, r);
    if (!r.stopped.empty()) {
        run.log.stop(r.stopped);
    }
    if (!r.flow_steady) {
        run.log.warn("flow-not-steady",
                     "the flow through the exit had not come to rest before the cell was put in");
    }
    warn_unless_steady(run, r.channel);
}

void run_scene(const SpaceRun& run) {
    SimulationResult& result = run.log.result;
    result.scene = run.scene.kind;
    result.offset = run.scene.offset;
    result.drive = run.scene.drive;
    switch (run.scene.kind) {
        case SceneKind::shear:
            result.fluid_stress = run.scene.fluid_stress;
            result.shear_rate = rate_at_stress(run.scene.ink, run.scene.fluid_stress);
            return run_shear(run);
        case SceneKind::channel:
            return run_channel_in_space(run);
        case SceneKind::exit:
        case SceneKind::exit_flow:  // never has a cell off the axis
            return run_exit_in_space(run);
    }
}

/// Lattice nodes of the largest stage of a scene.
double lattice_nodes(const Scene& scene, double nodes) {
    if (scene.kind == SceneKind::shear) {
        return 0.5 * 10.0 * 15.0 * 5.0 * nodes * nodes * nodes;
    }
    const double radius = scene.nozzle_radius / scene.cell.radius * nodes;
    const double length = scene.kind == SceneKind::channel ? 10.0 * nodes : 7.0 * radius;
    return 0.5 * 3.14159 * radius * radius * length;
}

/// @throws UsageError  a load that the lattice does not follow
void check_shear_load(const Scene& scene, double nodes) {
    const double load = scene.fluid_stress / scene.cell.shear_modulus;
    const auto refuse = [&](const std::string& what, double limit, const char* more, const char* less) {
        throw UsageError("--fluid-stress: σ_f/μ is " + number(load) + ", " + what + " " + number(limit) +
                             "; take a fluid stress of " + number(limit * scene.cell.shear_modulus) +
                             " Pa or " + more + ", or a --shear-modulus of " +
                             number(scene.fluid_stress / limit) + " Pa or " + less,
                         "--fluid-stress");
    };
    if (load < least_shear_load) {
        refuse("a cell all but rigid, which bears 4.33 times the ink's stress; it is simulated from",
               least_shear_load, "more", "less");
    }
    const double most = nodes >= nodes_of_known_errors ? most_shear_load_refined : most_shear_load;
    if (load > most) {
        refuse("a cell drawn out farther than the lattice follows; it is simulated up to", most, "less",
               "more");
    }
}

/// @throws UsageError  a cell too near the wall, or a lattice that no machine at hand would hold or finish
void check_size(const Scene& scene, double nodes) {
    if (nodes > finest) {
        throw UsageError("--resolution: in three dimensions a cell radius takes up to " + number(finest) +
                             " nodes, not " + number(nodes),
                         "--resolution");
    }
    if (scene.kind == SceneKind::shear) {
        check_shear_load(scene, nodes);
        return;
    }
    const double gap = scene.nozzle_radius - scene.cell.radius - scene.offset;
    const double least = gap_in_nodes * scene.cell.radius / nodes;
    if (gap < least) {
        throw UsageError("--offset: at " + number(scene.offset) +
                             " m the cell is too near the wall to be simulated; up to " +
                             number(scene.nozzle_radius - scene.cell.radius - least) +
                             " m fit at this resolution",
                         "--offset");
    }
    const double count = lattice_nodes(scene, nodes);
    if (count > most_nodes) {
        const double fitting = nodes * std::cbrt(most_nodes / count);
        const std::string remedy =
            fitting >= coarsest
                ? "take --resolution " + number(std::floor(10.0 * fitting) / 10.0) + " or less"
                : "take a cell on the axis (--offset 0), or --simulate=shear at its local stress";
        throw UsageError("--resolution: the cell is so small beside the nozzle that " + number(count / 1e6) +
                             " million lattice nodes would be needed, and " + number(most_nodes / 1e6) +
                             " million are the limit; " + remedy,
                         "--resolution");
    }
}

/// Nodes a cell radius. In a narrow nozzle more than were asked for, for its own sake.
double nodes_for(const Scene& scene, double wanted) {
    if (scene.kind == SceneKind::shear) return wanted;
    return std::max(wanted, narrowest * scene.cell.radius / scene.nozzle_radius);
}

int threads_for(const Scene& scene, double nodes, int allowed) {
    const double useful = lattice_nodes(scene, nodes) / nodes_a_thread;
    return std::clamp(static_cast<int>(useful), 1, std::max(allowed, 1));
}

}  // namespace

bool needs_space(const Scene& scene) {
    return scene.kind == SceneKind::shear || (scene.kind != SceneKind::exit_flow && scene.offset > 0.0);
}

double longest_shear(double load) {
    return 12.0 + 18.0 * load;
}

SpaceLattices space_lattices(const Scene& scene, const SimulationOptions& options) {
    const double nodes = nodes_for(scene, options.resolution);
    const double coarse_nodes = 0.5 * nodes;
    // Near the wall the coarse lattice may leave no node between it and the cell.
    const double gap = (scene.nozzle_radius - scene.cell.radius - scene.offset) / scene.cell.radius;
    const bool room = scene.kind == SceneKind::shear || gap * coarse_nodes >= 1.0;
    return {.nodes = nodes,
            .coarse_nodes = coarse_nodes,
            .compare = options.estimate_error && 0.5 * options.resolution >= coarsest && room};
}

void check_space(const Scene& scene, const SimulationOptions& options) {
    const double nodes = nodes_for(scene, options.resolution);
    check_size(scene, nodes);
    if (scene.kind == SceneKind::shear) return;
    const NozzleFlow flow = NozzleFlow::from_velocity(scene.ink, scene.nozzle_radius, scene.velocity_average);
    check_softness(scene, flow, options);
    check_offset_softness(scene, flow, options);
    check_offset_duration(scene, flow, nodes);
}

SimulationResult simulate_in_space(const Scene& scene, const SimulationOptions& options) {
    const auto [nodes, coarse_nodes, compare] = space_lattices(scene, options);
    Keeper keeper(scene, options);
    RunLog fine(options, keeper, "fine ", true);
    const auto run = [&](double resolution, RunLog& log) {
        run_scene({.scene = scene,
                   .nodes = resolution,
                   .threads = threads_for(scene, resolution, options.threads),
                   .log = log});
    };
    run(nodes, fine);
    // A cell that migrates is compared with the coarse one at the same time.
    SimulationOptions same_time = options;
    if (scene.kind == SceneKind::channel) {
        same_time.channel_time = fine.result.series.rows.back().front();
    }
    RunLog coarse(same_time, keeper, "coarse ", false);
    // The coarse run costs a thirtieth of the fine one.
    bool compared = compare;
    if (compared) {
        try {
            run(coarse_nodes, coarse);
        } catch (const SimulationIncomplete&) {
            compared = false;  // too coarse for this cell, or cancelled: what the fine run found stands
        }
    }
    if (options.estimate_error) {
        estimate_space_errors(fine.result, compared ? &coarse.result : nullptr, scene, nodes);
    }
    if (coarse.cancelled() && !compared && coarse.updates > 0.0) {
        fine.stop(cancelled_run);
    }
    SimulationResult result = std::move(fine.result);
    result.steps += coarse.result.steps;
    keeper.close();
    result.wall_time = keeper.elapsed();
    result.updates_per_second = (fine.updates + coarse.updates) / result.wall_time;
    return result;
}

}  // namespace bioprint
