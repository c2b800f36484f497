#include "lattice/d3q19_kernel.hpp"

#include <initializer_list>
#include <type_traits>

namespace bioprint::d3q19 {

extern const Kernels<float> baseline_kernels_float;
extern const Kernels<double> baseline_kernels_double;
#ifdef BIOPRINT_X86_KERNELS
extern const Kernels<float> avx2_kernels_float;
extern const Kernels<double> avx2_kernels_double;
extern const Kernels<float> avx512_kernels_float;
extern const Kernels<double> avx512_kernels_double;
#endif

namespace {

bool has(InstructionSet set) {
#ifdef BIOPRINT_X86_KERNELS
    if (set == InstructionSet::avx512) {
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
               __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("fma");
    }
    if (set == InstructionSet::avx2) {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    }
#endif
    return set == InstructionSet::baseline;
}

InstructionSet best() {
    for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2}) {
        if (has(set)) {
            return set;
        }
    }
    return InstructionSet::baseline;
}

template <class Real>
const Kernels<Real>* pick(const Kernels<float>& in_float, const Kernels<double>& in_double) {
    if constexpr (std::is_same_v<Real, float>) {
        return &in_float;
    } else {
        return &in_double;
    }
}

}  // namespace

template <class Real>
const Kernels<Real>* kernels(InstructionSet set) {
    const InstructionSet wanted = set == InstructionSet::best ? best() : set;
    if (!has(wanted)) {
        return nullptr;
    }
#ifdef BIOPRINT_X86_KERNELS
    if (wanted == InstructionSet::avx512) {
        return pick<Real>(avx512_kernels_float, avx512_kernels_double);
    }
    if (wanted == InstructionSet::avx2) {
        return pick<Real>(avx2_kernels_float, avx2_kernels_double);
    }
#endif
    return pick<Real>(baseline_kernels_float, baseline_kernels_double);
}

template const Kernels<float>* kernels<float>(InstructionSet);
template const Kernels<double>* kernels<double>(InstructionSet);

const char* best_instruction_set() {
    switch (best()) {
        case InstructionSet::avx512:
            return "AVX-512";
        case InstructionSet::avx2:
            return "AVX2";
        default:
            return "baseline";
    }
}

}  // namespace bioprint::d3q19
