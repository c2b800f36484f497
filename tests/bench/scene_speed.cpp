// Speed of whole scenes against what the memory of this machine allows, in one run:
//   bandwidth in place (read, change, write back) -> the bound of a step from the bytes it moves -> the steps of
//   the scenes as they run, with walls, the cell's forces and its motion, counted on fluid nodes.
// In space: a shear-thinning ink in half a tube of 37.5 nodes radius around a cell of 6 (channel), and nozzle and
// strand behind it (exit), in single precision. On the axis: the ink alone on a plane that fits the cache, double
// precision. Shares of the trial's rates are printed beside (two threads 190 M updates/s in space with a bare
// tube, one thread 140 on the axis).
//
//   bench_scene_speed [threads ...]

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "bench/memory_bandwidth.hpp"
#include "lattice/axisymmetric.hpp"
#include "simulate/immersed_body.hpp"

using namespace bioprint;
using bench::bandwidth;
using bench::best_seconds;

namespace {

constexpr double tube_radius = 37.5;
constexpr double cell_radius = 6.0;
constexpr double cell_offset = 18.0;

enum class Place { channel, exit };

D3q19Setup tube_setup(Place place, int threads) {
    constexpr double time_constant = 1e4;
    constexpr double force = 1e-7;
    D3q19Setup setup{.nx = 64,
                     .section = tube(tube_radius, true),
                     .viscosity = {.nu0 = 0.5, .time_constant = time_constant, .alpha = 0.75},
                     .body_force = {force, 0.0, 0.0},
                     .threads = threads};
    if (place == Place::exit) {
        setup.nx = 288;
        setup.slip_begin = 112;
        setup.slip_end = setup.nx;
        setup.ends = Ends::inflow_outflow;
        setup.body_force = {};
        setup.inflow = [](double y, double z) {
            return 0.01 * (1.0 - (y * y + z * z) / (tube_radius * tube_radius));
        };
    }
    return setup;
}

void print(const char* name, int threads, double rate, double bound, double trial) {
    std::printf("%-44s %2d  %8.1f  %8.1f  %5.0f %%  %5.0f %%\n", name, threads, rate / 1e6, bound / 1e6,
                100.0 * rate / bound, 100.0 * rate / trial);
}

void measure_tube(const char* name, Place place, bool with_cell, int threads, double bytes_per_second) {
    D3q19<float> lattice(tube_setup(place, threads));
    ImmersedBody<float> cell({.radius = cell_radius, .shear_modulus = 1e-3}, lattice,
                             {0.5 * lattice.nx(), cell_offset, 0.0});
    const auto step = [&] {
        if (with_cell) cell.load();
        lattice.step();
        if (with_cell) cell.move();
    };
    step();
    step();
    const double nodes = static_cast<double>(lattice.fluid_nodes());
    const int steps = std::max(4, static_cast<int>(4e7 / nodes) / 2 * 2);
    const double seconds = best_seconds(5, [&] {
        for (int i = 0; i < steps; ++i) step();
    });
    constexpr double trial_one = 101e6;
    constexpr double trial_two = 190e6;
    print(name, threads, steps * nodes / seconds, bytes_per_second / (lattice.bytes_per_step() / nodes),
          threads == 1 ? trial_one : trial_two);
}

/// The plane of the trial, 40 × 800 nodes, on one thread.
void measure_plane() {
    constexpr int length = 800;
    constexpr int radius = 40;
    constexpr int steps = 400;
    constexpr double nodes = static_cast<double>(length) * radius;
    constexpr double bytes_a_node = 160.0;  // nine populations and the relaxation, read and written
    constexpr double trial = 140e6;
    std::vector<double> field(static_cast<std::size_t>(nodes) * 10, 1.0);
    const double streamed = best_seconds(7, [&] {
        for (int n = 0; n < steps / 4; ++n) {
            for (double& x : field) x = 0.999 * x + 1e-3;
        }
    });
    const double bytes_per_second = 16.0 * static_cast<double>(field.size()) * (steps / 4.0) / streamed;
    std::vector<double> velocity, slope, links;
    for (int j = 0; j <= radius; ++j) {
        const double r = (j + 0.5) / radius;
        if (j < radius) {
            velocity.push_back(0.02 * (1.0 - r * r));
            slope.push_back(-0.04 * r / radius);
        }
        links.push_back(0.02 * (1.0 - static_cast<double>(j) * j / (radius * radius)));
    }
    lattice::AxisymmetricFlow flow({.length = length, .radius = radius, .lip = length / 2},
                                   {.t0 = 3.0, .t_inf = 0.0, .time_constant = 3000.0, .alpha = 0.75},
                                   velocity, links);
    flow.start(velocity, slope, 1e-5);
    const double seconds = best_seconds(7, [&] {
        for (int n = 0; n < steps; ++n) flow.step();
    });
    print("axis: exit flow, 40 x 800, in cache, fp64", 1, nodes * steps / seconds,
          bytes_per_second / bytes_a_node, trial);
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<int> thread_counts;
    for (int i = 1; i < argc; ++i) thread_counts.push_back(std::atoi(argv[i]));
    if (thread_counts.empty()) thread_counts = {1, 2};
    std::printf("kernels: %s\n", d3q19::best_instruction_set());
    std::printf("%-44s %2s  %8s  %8s  %7s  %7s\n", "scene, shear-thinning ink", "", "M upd/s", "bound",
                "share", "of trial");
    for (const int threads : thread_counts) {
        const double bytes_per_second = bandwidth(threads);
        std::printf("in-place bandwidth, %d threads: %.1f GB/s\n", threads, bytes_per_second / 1e9);
        measure_tube("space: tube, walls, no cell, fp32", Place::channel, false, threads, bytes_per_second);
        measure_tube("space: channel, walls and cell, fp32", Place::channel, true, threads, bytes_per_second);
        measure_tube("space: exit, free slip and cell, fp32", Place::exit, true, threads, bytes_per_second);
    }
    measure_plane();
    return 0;
}
