// CPU time of the passages and of a population, the fastest of several passes.
#include <cmath>
#include <cstdio>
#include <ctime>

#include "bioprint/predict/exit_passage.hpp"
#include "bioprint/predict/population.hpp"
#include "bioprint/predict/streamline_passage.hpp"

namespace {

template <typename F>
void measure(const char* name, int calls, F&& f) {
    double best = 1e300;
    volatile double sink = 0.0;
    for (int pass = 0; pass < 7; ++pass) {
        const std::clock_t start = std::clock();
        for (int i = 0; i < calls; ++i) sink = sink + f();
        best = std::fmin(best, 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / calls);
    }
    std::printf("%-52s %10.1f us\n", name, best);
}

}  // namespace

int main() {
    using namespace bioprint;
    for (const double alpha : {0.0, 0.75}) {
        const NozzleFlow flow = NozzleFlow::from_velocity(
            CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}, 50e-6, 5e-3);
        const AxisCell cell{.radius = 8e-6, .shear_modulus = 1000.0};
        const AxisEffects none{
            .volume_average = false, .quadratic_flow = false, .disturbed_viscosity = false};
        std::printf("alpha %.2f\n", alpha);
        measure("  exit on the axis", 100,
                [&] { return exit_passage(flow, {.cell = cell}).passage.peak.von_mises; });
        measure("  exit on the axis, ellipsoid alone", 100,
                [&] { return exit_passage(flow, {.cell = cell, .effects = none}).passage.peak.von_mises; });
        measure("  streamline at R/2 from the entrance of 5 mm", 20, [&] {
            return streamline_passage(flow, {.start_radius = 25e-6, .shear_modulus = 1000.0, .length = 5e-3})
                .exit_peak;
        });
        measure("  population", 2, [&] {
            return population(flow, {.cell_radius = 8e-6, .shear_modulus = 1000.0, .length = 5e-3})
                .peak_stress.mean;
        });
    }
    return 0;
}
