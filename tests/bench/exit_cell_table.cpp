#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bioprint/simulate/simulation.hpp"

/// Writes tests/reference/exit_cell_simulated.csv: the centred cell through the exit, for the ellipsoid to be
/// held against.   exit_cell_table [nodes a cell radius, 12] [case…]
int main(int count, char** arguments) {
    using namespace bioprint;
    struct Case {
        double alpha, velocity, modulus;
        double channel_time = 0.0;  ///< where the channel shape has no steady state worth waiting for [s]
        double cell_radius = 8e-6;
    };
    const std::vector<Case> cases{{0.0, 5e-3, 1e3},
                                  {0.75, 5e-3, 1e3},
                                  {0.3, 5e-3, 1e3},
                                  {0.45, 5e-3, 1e3},
                                  {0.6, 5e-3, 1e3},
                                  {0.15, 5e-3, 1e3},
                                  {0.75, 1e-2, 1e3},
                                  {0.75, 2e-2, 1e3},
                                  {0.75, 5e-2, 1e3},
                                  {0.75, 1e-1, 1e3},
                                  {0.0, 1e-2, 1e3, 0.06},
                                  {0.75, 5e-3, 5e2},
                                  {0.75, 5e-3, 5e3},
                                  {0.75, 5e-3, 5e4},
                                  {0.0, 5e-3, 5e3},
                                  {0.0, 5e-3, 5e4},
                                  {0.0, 5e-3, 5e2, 0.06},
                                  // the corners: fast, soft, stiff, large and small cells
                                  {0.0, 8e-3, 1e3},
                                  {0.0, 1.1e-2, 1e3, 0.06},
                                  {0.0, 1.5e-2, 1e3, 0.04},
                                  {0.0, 2e-2, 1e3, 0.03},
                                  {0.0, 5e-2, 1e4},
                                  {0.0, 1e-1, 5e4},
                                  {0.0, 5e-3, 1e3, 0.0, 1e-5},
                                  {0.75, 5e-3, 1e3, 0.0, 1e-5},
                                  {0.0, 5e-3, 1e3, 0.0, 5e-6},
                                  {0.3, 1e-1, 1e4},
                                  {0.45, 5e-2, 2e3},
                                  {0.6, 1e-1, 1e3},
                                  {0.75, 1e-1, 5e2},
                                  {0.75, 1e-1, 5e4},
                                  {0.45, 5e-3, 5e4},
                                  {0.6, 5e-3, 5e2}};
    SimulationOptions options{.resolution = count > 1 ? std::atof(arguments[1]) : 12.0, .threads = 2};
    std::puts(
        "alpha,velocity [m/s],shear_modulus [Pa],von_mises_channel [Pa],von_mises_channel error,"
        "von_mises_peak [Pa],von_mises_peak error,von_mises_peak resolved,stretch_axial_min,"
        "stretch_axial_min error,stretch_radial_max,stretch_radial_max error,peak_position [m],"
        "relaxation_time [s],steady channel,nodes a cell radius,cell_radius [m]");
    std::vector<std::size_t> chosen;
    for (int i = 2; i < count; ++i) chosen.push_back(static_cast<std::size_t>(std::atoi(arguments[i])));
    for (std::size_t i = 0; i < cases.size() && count <= 2; ++i) chosen.push_back(i);
    for (const std::size_t i : chosen) {
        const Case& c = cases.at(i);
        options.channel_time = c.channel_time;
        const Scene scene{.kind = SceneKind::exit,
                          .ink = {.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = c.alpha},
                          .nozzle_radius = 50e-6,
                          .velocity_average = c.velocity,
                          .cell = {.radius = c.cell_radius, .shear_modulus = c.modulus}};
        try {
            const SimulationResult r = simulate(scene, options);
            bool steady = true;
            bool relaxes = true;
            for (const auto& w : r.warnings) {
                steady = steady && w.code != "channel-not-steady";
                relaxes = relaxes && w.code != "no-relaxation-time";
            }
            const auto& channel = r.at("von_mises_channel");
            const auto& peak = r.at("von_mises_peak");
            const auto& axial = r.at("stretch_axial_min");
            const auto& radial = r.at("stretch_radial_max");
            std::printf("%g,%g,%g,%.5g,%.2g,%.5g,%.2g,%.5g,%.5f,%.2g,%.5f,%.2g,%.4g,", c.alpha, c.velocity,
                        c.modulus, channel.value, channel.error, peak.value, peak.error, peak.resolved,
                        axial.value, axial.error, radial.value, radial.error, r.at("peak_position").value);
            if (relaxes) {
                std::printf("%.4g", r.at("relaxation_time").value);
            }
            std::printf(",%d,%.2f,%g\n", steady ? 1 : 0, r.lattice.nodes_per_cell_radius, c.cell_radius);
        } catch (const Error& e) {
            std::fprintf(stderr, "%g,%g,%g: %s\n", c.alpha, c.velocity, c.modulus, e.what());
        }
        std::fflush(stdout);
    }
    return 0;
}
