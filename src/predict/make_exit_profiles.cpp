#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/simulate/simulation.hpp"

// Writes data/exit/axis_profiles.csv to standard output: the velocity on the axis through a nozzle exit,
// simulated for the inks and speeds a print can have. About ten minutes on two cores.
//
//   f(X; α, Cu) = (u_x − u_avg)/(u_max − u_avg),   X = x/R from the lip,   Cu = K u_avg/R

using namespace bioprint;

namespace {

constexpr double radius = 50e-6;
constexpr double velocity = 5e-3;
constexpr double first = -4.0;
constexpr double last = 4.0;
constexpr double step = 0.05;

struct Line {
    std::vector<double> x;
    std::vector<double> f;
};

/// Cubic through the four points around `at` (Lagrange): the columns of the lattice are evenly spaced.
double interpolate(const Line& line, double at) {
    const auto above =
        static_cast<std::size_t>(std::upper_bound(line.x.begin(), line.x.end(), at) - line.x.begin());
    const std::size_t begin = std::clamp<std::size_t>(above, 2, line.x.size() - 2) - 2;
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + 4; ++i) {
        double weight = 1.0;
        for (std::size_t j = begin; j < begin + 4; ++j) {
            if (j != i) weight *= (at - line.x[j]) / (line.x[i] - line.x[j]);
        }
        sum += weight * line.f[i];
    }
    return sum;
}

Line simulated(double alpha, double carreau, double resolution) {
    const CrossInk ink{.eta0 = 10.0, .time_constant = carreau * radius / velocity, .alpha = alpha};
    const SimulationResult run = simulate(
        {.kind = SceneKind::exit_flow, .ink = ink, .nozzle_radius = radius, .velocity_average = velocity},
        {.resolution = resolution, .estimate_error = false});
    const NozzleFlow flow = NozzleFlow::from_velocity(ink, radius, velocity);
    const auto column = [&](const char* name) {
        const auto& names = run.series.columns;
        return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    Line line;
    for (const std::vector<double>& row : run.series.rows) {
        line.x.push_back(row.at(column("x [m]")) / radius);
        line.f.push_back((row.at(column("velocity [m/s]")) - velocity) / flow.velocity_excess());
    }
    return line;
}

}  // namespace

int main(int argc, char** argv) {
    const double resolution = argc > 1 ? std::atof(argv[1]) : 9.0;
    std::printf("alpha,Cu");
    for (double x = first; x < last + 0.5 * step; x += step) std::printf(",%.2f", x);
    std::printf("\n");
    for (const double alpha : {0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.85, 0.95}) {
        for (const double carreau : {1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4}) {
            if (alpha == 0.0 && carreau > 1e-2) continue;  // the Newtonian profile knows no Cu
            try {
                const Line line = simulated(alpha, carreau, resolution);
                std::printf("%g,%g", alpha, carreau);
                for (double x = first; x < last + 0.5 * step; x += step)
                    std::printf(",%.7g", interpolate(line, x));
                std::printf("\n");
                std::fflush(stdout);
            } catch (const Error& e) {
                std::fprintf(stderr, "alpha %g, Cu %g: %s\n", alpha, carreau, e.what());
            }
        }
    }
    return 0;
}
