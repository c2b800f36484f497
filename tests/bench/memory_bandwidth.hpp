#pragma once

#include <algorithm>
#include <chrono>

#include "lattice/huge_buffer.hpp"

/// What the memory of this machine allows, to hold a kernel's speed against.
namespace bioprint::bench {

/// The shortest of some runs: the others met somebody else.
template <class Work>
double best_seconds(int repeats, const Work& work) {
    double best = 1e30;
    for (int i = 0; i < repeats; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        best = std::min(best, taken.count());
    }
    return best;
}

/// Bytes a second read and written back, in place.
inline double bandwidth(int threads) {
    constexpr long count = 96L << 20;
    static const HugeBuffer buffer(count * sizeof(float));
    auto* const data = static_cast<float*>(buffer.data());
    const double seconds = best_seconds(5, [&] {
#pragma omp parallel for simd num_threads(threads) schedule(static)
        for (long i = 0; i < count; ++i) {
            data[i] = data[i] * 0.5F + 1.0F;
        }
    });
    return 2.0 * count * sizeof(float) / seconds;
}

}  // namespace bioprint::bench
