// Speed of the 3-D lattice against what the memory of this machine allows, measured in one run:
//   bandwidth in place (read, change, write back) -> bound of each kernel from the bytes it moves -> our
//   kernels on a tube of radius 38 nodes, walls included, counted on fluid nodes.
//
//   bench_lattice3d [length in nodes, a multiple of 16] [threads ...]

#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/memory_bandwidth.hpp"
#include "lattice/d3q19.hpp"

using namespace bioprint;
using bench::bandwidth;
using bench::best_seconds;

namespace {

enum class Kind { newtonian, cross, cross_coupled };

template <class Real>
void measure(const char* name, Kind kind, int length, int threads, double bytes_per_second) {
    const double radius = 38.0;
    const double nu = 0.5;
    const double time_constant = kind == Kind::newtonian ? 0.0 : 1e4;
    D3q19<Real> lattice({.nx = length,
                         .section = tube(radius, true),
                         .viscosity = {.nu0 = nu, .time_constant = time_constant, .alpha = 0.75},
                         .body_force = {1e-7, 0.0, 0.0},
                         .inflow = {},
                         .threads = threads});
    for (int row = 0; kind == Kind::cross_coupled && row < lattice.rows(); ++row) {
        lattice.set_coupling(row, d3q19::Coupling::coupled);
    }
    lattice.cycle();
    const double nodes = static_cast<double>(lattice.fluid_nodes());
    const int cycles = std::max(2, static_cast<int>(2e7 / nodes));
    const double seconds = best_seconds(5, [&] {
        for (int i = 0; i < cycles; ++i) {
            lattice.cycle();
        }
    });
    const double rate = 2.0 * cycles * nodes / seconds;
    const double bound = bytes_per_second / (lattice.bytes_per_step() / nodes);
    std::printf("%-34s %2d  %8.1f  %8.1f  %5.0f %%\n", name, threads, rate / 1e6, bound / 1e6,
                100.0 * rate / bound);
}

}  // namespace

int main(int argc, char** argv) {
    const int length = argc > 1 ? std::atoi(argv[1]) : 256;
    std::vector<int> threads{1, 2};
    if (argc > 2) {
        threads.clear();
        for (int i = 2; i < argc; ++i) {
            threads.push_back(std::atoi(argv[i]));
        }
    }
    std::printf("kernels: %s; half tube of radius 38, length %d nodes\n", d3q19::best_instruction_set(),
                length);
    std::printf("M updates/s               threads  reached     bound   share\n");
    for (const int count : threads) {
        const double bytes = bandwidth(count);
        std::printf("%-34s %2d  %8.1f GB/s\n", "memory in place", count, bytes / 1e9);
        measure<float>("float, Newtonian", Kind::newtonian, length, count, bytes);
        measure<float>("float, Cross", Kind::cross, length, count, bytes);
        measure<float>("float, Cross, force and velocity", Kind::cross_coupled, length, count, bytes);
        measure<double>("double, Newtonian", Kind::newtonian, length, count, bytes);
        measure<double>("double, Cross", Kind::cross, length, count, bytes);
        measure<double>("double, Cross, force and velocity", Kind::cross_coupled, length, count, bytes);
    }
    return 0;
}
