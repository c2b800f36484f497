#include "lattice/axisymmetric_kernel.hpp"

#include "lattice/fast_power.hpp"

namespace bioprint::lattice {
namespace {

/// What a kernel does beside colliding.
struct Plain {
    static constexpr bool uniform = false, forced = false, update = false;
};
struct Forced {
    static constexpr bool uniform = false, forced = true, update = false;
};
struct PlainUpdate {
    static constexpr bool uniform = false, forced = false, update = true;
};
struct ForcedUpdate {
    static constexpr bool uniform = false, forced = true, update = true;
};
struct UniformPlain {
    static constexpr bool uniform = true, forced = false, update = false;
};
struct UniformForced {
    static constexpr bool uniform = true, forced = true, update = false;
};

template <class Task>
[[gnu::always_inline]] inline void collide(const RowStretch& row, const CrossRelaxation& ink) {
    double* const p0 = row.population[0];
    double* const p1 = row.population[1];
    double* const p2 = row.population[2];
    double* const p3 = row.population[3];
    double* const p4 = row.population[4];
    double* const p5 = row.population[5];
    double* const p6 = row.population[6];
    double* const p7 = row.population[7];
    double* const p8 = row.population[8];
    double* const tp = row.t;
    const double* const gx = row.force_x;
    const double* const gr = row.force_r;
    double* const vx = row.velocity_x;
    double* const vr = row.velocity_r;
    const double s = row.inverse_radius;
    const double g = row.body_force;
    const double hoop_factor = s * s / 3.0;
    const double uniform_t = ink.uniform_t();
    const double t_inf = ink.t_inf;
    const double t_span = ink.t0 - ink.t_inf;
    const double k2 = ink.time_constant * ink.time_constant;
    const double half_alpha = 0.5 * ink.alpha;
    const int n = row.count;
#pragma GCC ivdep
    for (int i = 0; i < n; ++i) {
        const double t = Task::uniform ? uniform_t : tp[i];
        const double f0 = p0[i];
        const double e1 = p1[i] + p2[i], o1 = p1[i] - p2[i];
        const double e3 = p3[i] + p4[i], o3 = p3[i] - p4[i];
        const double e5 = p5[i] + p6[i], o5 = p5[i] - p6[i];
        const double e7 = p7[i] + p8[i], o7 = p7[i] - p8[i];
        const double diagonal = e5 + e7;
        const double m0 = f0 + e1 + e3 + diagonal;
        const double n_rr = e3 + diagonal - m0 * (1.0 / 3.0);
        const double n_xr = e5 - e7;

        // One division serves both relaxation rates and the implicit hoop stress.
        const double a_even = t + 0.5;
        const double a_odd = 0.5 * t + magic_parameter;
        const double a_hoop = 1.0 + t * hoop_factor;
        const double both = a_even * a_odd;
        const double inverse = 1.0 / (both * a_hoop);
        const double lp = a_odd * a_hoop * inverse;
        const double k = t * lp;
        double fx = g - k * n_xr * s;
        double fr = -k * n_rr * s;
        if constexpr (Task::forced) {
            fx += gx[i];
            fr += gr[i];
        }
        const double ur = (o3 + o5 - o7 + 0.5 * fr) * (both * inverse);
        const double ux = o1 + o5 + o7 + 0.5 * fx;
        fr -= 2.0 * t * hoop_factor * ur;
        if constexpr (Task::forced) {
            vx[i] = ux;
            vr[i] = ur;
        }
        const double source = -ur * s;
        const double lm = t * a_even * a_hoop * inverse;
        const double even = lp * (m0 + 0.5 * source) + source * (1.0 - 0.5 * lp);
        const double odd_x = 3.0 * (lm * ux + fx * (1.0 - 0.5 * lm));
        const double odd_r = 3.0 * (lm * ur + fr * (1.0 - 0.5 * lm));
        const double keep = 1.0 - lp;
        const double he = 0.5 * keep;
        const double ho = 0.5 * (1.0 - lm);
        const double even1 = even * D2Q9::straight, even5 = even * D2Q9::diagonal;
        const double a1 = he * e1 + even1, b1 = ho * o1 + D2Q9::straight * odd_x;
        const double a3 = he * e3 + even1, b3 = ho * o3 + D2Q9::straight * odd_r;
        const double a5 = he * e5 + even5, b5 = ho * o5 + D2Q9::diagonal * (odd_x + odd_r);
        const double a7 = he * e7 + even5, b7 = ho * o7 + D2Q9::diagonal * (odd_x - odd_r);
        p0[i] = keep * f0 + even * D2Q9::rest;
        p2[i] = a1 + b1;
        p1[i] = a1 - b1;
        p4[i] = a3 + b3;
        p3[i] = a3 - b3;
        p6[i] = a5 + b5;
        p5[i] = a5 - b5;
        p8[i] = a7 + b7;
        p7[i] = a7 - b7;
        if constexpr (Task::update) {
            const double n_xx = e1 + diagonal - m0 * (1.0 / 3.0);
            const double hoop = ur * s;
            const double rate2 =
                4.5 * lp * lp * (n_xx * n_xx + n_rr * n_rr + 2.0 * n_xr * n_xr) + 2.0 * hoop * hoop;
            const double thinning = fast_exp2(half_alpha * fast_log2(k2 * rate2 + 1e-280));
            tp[i] = t_inf + t_span / (1.0 + thinning);
        }
    }
}

#if defined(__x86_64__)
#define BIOPRINT_AVX512 \
    [[gnu::target("avx512f,avx512dq,avx512vl,avx2,fma,prefer-vector-width=512"), gnu::flatten]]
#define BIOPRINT_AVX2 [[gnu::target("avx2,fma"), gnu::flatten]]
template <class Task>
BIOPRINT_AVX512 void collide_avx512(const RowStretch& row, const CrossRelaxation& ink) {
    collide<Task>(row, ink);
}
template <class Task>
BIOPRINT_AVX2 void collide_avx2(const RowStretch& row, const CrossRelaxation& ink) {
    collide<Task>(row, ink);
}
#endif
template <class Task>
void collide_any(const RowStretch& row, const CrossRelaxation& ink) {
    collide<Task>(row, ink);
}

struct Tables {
    KernelTable cross;
    KernelTable uniform;
};

const Tables& tables() {
#if defined(__x86_64__)
    static const Tables avx512{{collide_avx512<Plain>, collide_avx512<Forced>, collide_avx512<PlainUpdate>,
                                collide_avx512<ForcedUpdate>, "avx512"},
                               {collide_avx512<UniformPlain>, collide_avx512<UniformForced>,
                                collide_avx512<UniformPlain>, collide_avx512<UniformForced>, "avx512"}};
    static const Tables avx2{{collide_avx2<Plain>, collide_avx2<Forced>, collide_avx2<PlainUpdate>,
                              collide_avx2<ForcedUpdate>, "avx2"},
                             {collide_avx2<UniformPlain>, collide_avx2<UniformForced>,
                              collide_avx2<UniformPlain>, collide_avx2<UniformForced>, "avx2"}};
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl")) {
        return avx512;
    }
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
        return avx2;
    }
#endif
    static const Tables any{{collide_any<Plain>, collide_any<Forced>, collide_any<PlainUpdate>,
                             collide_any<ForcedUpdate>, "portable"},
                            {collide_any<UniformPlain>, collide_any<UniformForced>, collide_any<UniformPlain>,
                             collide_any<UniformForced>, "portable"}};
    return any;
}

}  // namespace

const KernelTable& kernels(const CrossRelaxation& ink) {
    return ink.uniform() ? tables().uniform : tables().cross;
}

}  // namespace bioprint::lattice
