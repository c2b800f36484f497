#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "lattice/axisymmetric.hpp"

/// Speed of the axisymmetric lattice in cache beside its bound, in one run: in-place bandwidth over the same
/// storage and the bytes a node moves (nine populations read and written, the relaxation read or written).
using namespace bioprint::lattice;

namespace {

double seconds_of(const auto& work) {
    double best = 1e300;
    for (int repeat = 0; repeat < 7; ++repeat) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        best =
            std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
}

constexpr int length = 800;
constexpr int radius = 40;
constexpr int steps = 400;
constexpr double nodes = static_cast<double>(length) * radius;

double bandwidth() {
    std::vector<double> field(static_cast<std::size_t>(nodes) * 10, 1.0);
    const double time = seconds_of([&] {
        for (int n = 0; n < steps / 4; ++n) {
            for (double& x : field) {
                x = 0.999 * x + 1e-3;
            }
        }
    });
    return 16.0 * static_cast<double>(field.size()) * (steps / 4.0) / time;
}

double updates(const CrossRelaxation& ink, int interval) {
    std::vector<double> velocity(radius), slope(radius), links(radius + 1);
    for (int j = 0; j < radius; ++j) {
        const double r = (j + 0.5) / radius;
        velocity[static_cast<std::size_t>(j)] = 0.02 * (1.0 - r * r);
        slope[static_cast<std::size_t>(j)] = -0.04 * r / radius;
        links[static_cast<std::size_t>(j)] = 0.02 * (1.0 - static_cast<double>(j) * j / (radius * radius));
    }
    AxisymmetricFlow flow(
        {.length = length, .radius = radius, .lip = length / 2, .viscosity_interval = interval}, ink,
        velocity, links);
    flow.start(velocity, slope, 1e-5);
    const double time = seconds_of([&] {
        for (int n = 0; n < steps; ++n) {
            flow.step();
        }
    });
    return nodes * steps / time;
}

}  // namespace

int main() {
    const CrossRelaxation newton{.t0 = 3.0};
    const CrossRelaxation cross{.t0 = 3.0, .t_inf = 0.0, .time_constant = 3000.0, .alpha = 0.75};
    const double bytes = bandwidth();
    struct Row {
        const char* name;
        double rate, bytes_a_node;
    };
    const Row rows[] = {{"uniform viscosity", updates(newton, 1), 144.0},
                        {"Cross, viscosity every step", updates(cross, 1), 160.0},
                        {"Cross, viscosity every 4 steps", updates(cross, 4), 154.0}};
    std::printf("axisymmetric, %d x %d nodes, fp64, one thread, %s; in-place bandwidth %.1f GB/s\n", radius,
                length, kernels(newton).name, bytes * 1e-9);
    for (const Row& row : rows) {
        std::printf("%-32s %6.0f M updates/s, bound %6.0f, share %3.0f %%\n", row.name, row.rate * 1e-6,
                    bytes / row.bytes_a_node * 1e-6, 100.0 * row.rate * row.bytes_a_node / bytes);
    }
    return 0;
}
