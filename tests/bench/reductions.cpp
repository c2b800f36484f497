// What each reduction of a scene saves and what it costs in accuracy, as a table in Markdown: docs/reductions.md.
// Every row runs the scene with and without the reduction, one thread, times of the processor. About a quarter of an
// hour.
//
//   bench_reductions [window|rescaled]      the page, or its line of the moving window or the rescaled flow alone

#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "bench/processor_time.hpp"
#include "bioprint/simulate/simulation.hpp"
#include "lattice/d3q19.hpp"
#include "simulate/exit_field.hpp"
#include "simulate/offset_channel_scene.hpp"
#include "simulate/offset_exit_scene.hpp"

namespace {

using namespace bioprint;

// The paper's nozzle, cell and velocity, in its thinning ink.
constexpr CrossInk ink{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75};
constexpr double nozzle_radius = 50e-6;
constexpr double velocity = 5e-3;
constexpr SimulatedCell cell{.radius = 8e-6, .shear_modulus = 1e3};

struct Measured {
    double value;
    double seconds;
};

Measured timed(const std::function<double()>& run) {
    const double start = bench::processor_seconds();
    const double value = run();
    return {.value = value, .seconds = bench::processor_seconds() - start};
}

/// @param reference  the value both are judged by; none: the value without the reduction
void print(const std::string& name, const std::string& judged, const Measured& whole, const Measured& reduced,
           std::optional<double> reference = std::nullopt) {
    const double right = reference.value_or(whole.value);
    const auto percent = [&](double value) { return 100.0 * (value / right - 1.0); };
    std::printf("| %s | %.3g s | %.3g s | %.1f | %s | ", name.c_str(), whole.seconds, reduced.seconds,
                whole.seconds / reduced.seconds, judged.c_str());
    if (reference)
        std::printf("%+.2f %% | ", percent(whole.value));
    else
        std::printf("– | ");
    std::printf("%+.2g %% |\n", percent(reduced.value));
    std::fflush(stdout);
}

Measured axis(SceneKind kind, const std::string& quantity, const SimulationOptions& options) {
    return timed([&] {
        return simulate({.kind = kind,
                         .ink = ink,
                         .nozzle_radius = nozzle_radius,
                         .velocity_average = velocity,
                         .cell = cell},
                        options)
            .at(quantity)
            .resolved;
    });
}

OffsetChannelSetup space_setup(double offset, double nodes) {
    return {.ink = ink,
            .radius = nozzle_radius,
            .velocity_average = velocity,
            .cell_radius = cell.radius,
            .shear_modulus = cell.shear_modulus,
            .offset = offset,
            .duration = 0.1,
            .settle_tolerance = 0.01,
            .hold_offset = true,
            .drive = OffsetDrive::constant_flow_rate,
            .nodes = nodes};
}

Measured space(const OffsetChannelSetup& setup) {
    return timed([&] { return run_offset_channel(setup).series.back().von_mises; });
}

/// The flow that is stepped while the cell passes the exit.
void moving_window() {
    const auto peak = [](double window) {
        return timed([&] {
            return run_offset_exit({.ink = ink,
                                    .radius = nozzle_radius,
                                    .velocity_average = velocity,
                                    .cell_radius = cell.radius,
                                    .shear_modulus = cell.shear_modulus,
                                    .offset = 1.5 * cell.radius,
                                    .settle = 0.1,
                                    .settle_tolerance = 0.01,
                                    .window = window})
                .peak_von_mises;
        });
    };
    constexpr double everything = 100.0;
    print("window of a nozzle radius before and behind the cell",
          "peak stress at the exit, 1.5 R_c off the axis", peak(everything), peak(1.0));
}

/// The flow the cell enters, settled in the units in which that takes the fewest steps and brought to those of the cell,
/// or settled in those.
void rescaled_flow() {
    const NozzleFlow flow = NozzleFlow::from_velocity(ink, nozzle_radius, velocity);
    const Scene scene{.kind = SceneKind::exit,
                      .ink = ink,
                      .nozzle_radius = nozzle_radius,
                      .velocity_average = velocity,
                      .cell = cell};
    constexpr double settled = 1e-4;
    constexpr int nodes = 38;
    const LatticeUnits wanted = units_for_cell(scene, flow, nodes, {});
    const auto peak = [&](const LatticeUnits& units) {
        return timed([&] {
            ExitField field = unsettled_exit_flow(flow, nodes, exit_reach(ink), units);
            field.flow.run_to_steady(settled, exit_step_limit);
            field.flow.rescale(wanted.velocity_lu / units.velocity_lu,
                               wanted.viscosity_lu / units.viscosity_lu);
            field.units = wanted;
            return axis_profile(field, flow).peak;
        });
    };
    print("base flow settled in its own units and rescaled", "the ink's peak stress at the exit",
          peak(wanted), peak(units_for_flow(flow, nodes)));
}

/// Steps of a bare tube; the flow it carries, of the whole section.
Measured tube_steps(bool half, double alpha, int cycles) {
    D3q19<float> lattice({.nx = 64,
                          .section = tube(37.5, half),
                          .viscosity = {.nu0 = 0.5, .time_constant = 1e4, .alpha = alpha},
                          .body_force = {1e-7, 0.0, 0.0},
                          .threads = 1});
    lattice.initialise([](double, double, double) { return FlowState{}; });
    return timed([&] {
        for (int i = 0; i < cycles; ++i) lattice.cycle();
        return (half ? 2.0 : 1.0) * lattice.flow_rate(0);
    });
}

void on_the_axis(double exit_stress) {
    const SimulationOptions standard{.estimate_error = false};
    const Measured exit = axis(SceneKind::exit, "von_mises_peak", standard);

    const Measured bare = axis(SceneKind::exit_flow, "elongational_stress_peak", standard);
    std::printf("| no cell, where the ink's stress is asked | %.3g s | %.3g s | %.1f | – | – | – |\n",
                exit.seconds, bare.seconds, exit.seconds / bare.seconds);

    SimulationOptions draft = standard;
    draft.resolution = 3.0;
    print("draft grid, 3 nodes a cell radius instead of 6", "peak stress at the exit", exit,
          axis(SceneKind::exit, "von_mises_peak", draft), exit_stress);

    SimulationOptions slow = standard;
    slow.accuracy = standard.accuracy / 4.0;
    print("lattice time step at 0.8 % compression instead of 0.2 %", "peak stress at the exit",
          axis(SceneKind::exit, "von_mises_peak", slow), exit, exit_stress);
}

void early_stop(double channel_stress) {
    const SimulationOptions standard{.estimate_error = false};
    SimulationOptions patient = standard;
    patient.settle_tolerance = 1e-5;
    print("end 0.3 % before the settled stress instead of 0.001 %", "stress in the nozzle, on the axis",
          axis(SceneKind::channel, "von_mises", patient), axis(SceneKind::channel, "von_mises", standard),
          channel_stress);
}

void in_space(double channel_stress) {
    const SimulationOptions standard{.estimate_error = false};
    print("two dimensions instead of three", "stress in the nozzle, on the axis",
          space(space_setup(0.0, 6.0)), axis(SceneKind::channel, "von_mises", standard), channel_stress);

    constexpr double offset = 3.0 * cell.radius;
    const Measured usual = space(space_setup(offset, 6.0));
    OffsetChannelSetup twice = space_setup(offset, 6.0);
    twice.single = false;
    print("single precision instead of double, in space", "stress in the nozzle, 3 R_c off the axis",
          space(twice), usual);
    OffsetChannelSetup longer = space_setup(offset, 6.0);
    longer.length = 20.0;
    print("period of 10 cell radii instead of 20", "stress in the nozzle, 3 R_c off the axis", space(longer),
          usual);
    print("draft grid in space, 3 nodes instead of 6", "stress in the nozzle, 3 R_c off the axis", usual,
          space(space_setup(offset, 3.0)));
    moving_window();
    rescaled_flow();

    constexpr int cycles = 300;
    const Measured half = tube_steps(true, 0.75, cycles);
    print("half a tube and a mirror", "flow after 600 steps from rest", tube_steps(false, 0.75, cycles),
          half);
    // What was not built, by the most that it could give: a viscosity that is never computed.
    const double newtonian = tube_steps(true, 0.0, cycles).seconds;
    std::printf(
        "\nNot built: a viscosity updated every n steps. A Newtonian ink steps %.2f times as fast as one by "
        "the Cross law\n"
        "in space; leaving out every second update would save %.0f %%.\n",
        half.seconds / newtonian, 50.0 * (1.0 - newtonian / half.seconds));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::string(argv[1]) == "window") {
        moving_window();
        return 0;
    }
    if (argc > 1 && std::string(argv[1]) == "rescaled") {
        rescaled_flow();
        return 0;
    }
    const SimulationOptions fine{.resolution = 12.0, .threads = 1};
    const Scene channel{.kind = SceneKind::exit,
                        .ink = ink,
                        .nozzle_radius = nozzle_radius,
                        .velocity_average = velocity,
                        .cell = cell};
    const SimulationResult reference = simulate(channel, fine);
    const SimulatedValue& nozzle = reference.at("von_mises_channel");
    const SimulatedValue& peak = reference.at("von_mises_peak");
    std::puts(
        "# What each reduction of a scene saves and what it costs\n\n"
        "A simulation models only what its scene requires. Each line runs one scene without and with one "
        "reduction: R 50 µm,\n"
        "5 mm/s, η0 10 Pa s, K 50 ms, α 0.75, a cell of 8 µm and 1 kPa, 6 nodes a cell radius where nothing "
        "else is said, one\n"
        "thread, processor time. `tools/bench reductions` measures and prints this page.\n");
    std::printf(
        "On the axis errors are held against the run of 12 nodes, extrapolated: %.1f ± %.1f Pa in the "
        "nozzle, %.1f ± %.1f\n"
        "Pa at the exit. Elsewhere the value with the reduction is held against the one without.\n\n",
        nozzle.value, nozzle.error, peak.value, peak.error);
    std::puts("| reduction | without | with | faster | judged by | error without | error with |");
    std::puts("| --- | --- | --- | --- | --- | --- | --- |");
    on_the_axis(peak.value);
    early_stop(nozzle.value);
    in_space(nozzle.value);
}
