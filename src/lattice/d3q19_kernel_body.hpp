// The row operations of the 3-D lattice, included once by each instruction-set specific translation unit,
// which defines BIOPRINT_KERNEL_TABLE. Everything here has internal linkage.

#include "lattice/cross_power.hpp"
#include "lattice/d3q19_kernel.hpp"

namespace bioprint::d3q19 {
namespace {

enum class Fluid { newtonian, cross };

/// One time step of collision on a row.
///
///   f± = (f_q ± f_q̄)/2,   post = f − λ+ (f+ − w δρ) − λ− (f− − 3w c·u) + (1 − λ−/2) 3w c·F
///
/// u = Σ c f + F/2. The rate of strain comes from the second moments' deviator N = Σ cc f − …:
/// S = −(3/2) λ+ N, with the relaxation rate of the step before.
template <class Real, Fluid fluid, Coupling coupling>
void collide(const RowTask<Real>& task, const FluidConstants<Real>& constants) {
    const Real third = Real(1.0 / 3.0);
    const Real half = Real(0.5);
    const Real w0 = Real(1.0 / 3.0);
    const Real w1 = Real(1.0 / 18.0);
    const Real w2 = Real(1.0 / 36.0);
    const Real magic = constants.magic;
    const Real t0 = constants.t0;
    const Real t_inf = constants.t_inf;
    const Real rate_factor = constants.rate_factor;
    const Real half_alpha = constants.half_alpha;
    const Real body_x = constants.body_force[0];
    const Real body_y = constants.body_force[1];
    const Real body_z = constants.body_force[2];
    Real* const f0 = task.f[0];
    Real* const f1 = task.f[1];
    Real* const f2 = task.f[2];
    Real* const f3 = task.f[3];
    Real* const f4 = task.f[4];
    Real* const f5 = task.f[5];
    Real* const f6 = task.f[6];
    Real* const f7 = task.f[7];
    Real* const f8 = task.f[8];
    Real* const f9 = task.f[9];
    Real* const f10 = task.f[10];
    Real* const f11 = task.f[11];
    Real* const f12 = task.f[12];
    Real* const f13 = task.f[13];
    Real* const f14 = task.f[14];
    Real* const f15 = task.f[15];
    Real* const f16 = task.f[16];
    Real* const f17 = task.f[17];
    Real* const f18 = task.f[18];
    Real* const t_row = task.t;
    const Real* const force_x = task.force[0];
    const Real* const force_y = task.force[1];
    const Real* const force_z = task.force[2];
    Real* const out_x = task.velocity[0];
    Real* const out_y = task.velocity[1];
    Real* const out_z = task.velocity[2];
    const long nodes = task.blocks * 16;

#pragma omp simd
    for (long x = 0; x < nodes; ++x) {
        const Real a0 = f0[x];
        const Real a1 = f1[x], a2 = f2[x], a3 = f3[x], a4 = f4[x], a5 = f5[x], a6 = f6[x];
        const Real a7 = f7[x], a8 = f8[x], a9 = f9[x], a10 = f10[x], a11 = f11[x], a12 = f12[x];
        const Real a13 = f13[x], a14 = f14[x], a15 = f15[x], a16 = f16[x], a17 = f17[x], a18 = f18[x];

        const Real p_x = a1 + a2, m_x = a1 - a2;
        const Real p_y = a3 + a4, m_y = a3 - a4;
        const Real p_z = a5 + a6, m_z = a5 - a6;
        const Real p_xy = a7 + a8, m_xy = a7 - a8;
        const Real p_yx = a9 + a10, m_yx = a9 - a10;
        const Real p_xz = a11 + a12, m_xz = a11 - a12;
        const Real p_zx = a13 + a14, m_zx = a13 - a14;
        const Real p_yz = a15 + a16, m_yz = a15 - a16;
        const Real p_zy = a17 + a18, m_zy = a17 - a18;

        const Real s_xy = p_xy + p_yx, s_xz = p_xz + p_zx, s_yz = p_yz + p_zy;
        const Real density = a0 + (p_x + p_y + p_z) + (s_xy + s_xz + s_yz);
        const Real j_x = m_x + (m_xy + m_yx) + (m_xz + m_zx);
        const Real j_y = m_y + (m_xy - m_yx) + (m_yz + m_zy);
        const Real j_z = m_z + (m_xz - m_zx) + (m_yz - m_zy);

        Real g_x = body_x, g_y = body_y, g_z = body_z;
        if constexpr (coupling == Coupling::coupled) {
            g_x += force_x[x];
            g_y += force_y[x];
            g_z += force_z[x];
        }
        const Real u_x = j_x + half * g_x, u_y = j_y + half * g_y, u_z = j_z + half * g_z;
        if constexpr (coupling != Coupling::none) {
            out_x[x] = u_x;
            out_y[x] = u_y;
            out_z[x] = u_z;
        }

        Real t = t0;
        if constexpr (fluid == Fluid::cross) {
            const Real xx = p_x + s_xy + s_xz, yy = p_y + s_xy + s_yz, zz = p_z + s_xz + s_yz;
            const Real mean = third * (xx + yy + zz);
            const Real n_xx = xx - mean, n_yy = yy - mean, n_zz = zz - mean;
            const Real n_xy = p_xy - p_yx, n_xz = p_xz - p_zx, n_yz = p_yz - p_zy;
            const Real square =
                n_xx * n_xx + n_yy * n_yy + n_zz * n_zz + 2 * (n_xy * n_xy + n_xz * n_xz + n_yz * n_yz);
            const Real tau = t_row[x] + half;
            t = t_inf + (t0 - t_inf) / (1 + power(rate_factor * square / (tau * tau), half_alpha));
            t_row[x] = t;
        }
        const Real even = 1 / (t + half);
        const Real odd = t / (half * t + magic);
        const Real e = half * even, o = half * odd;
        const Real d = even * density;
        // 3 (λ− u + (1 − λ−/2) F): what each pair's odd part relaxes to, without its weight.
        const Real h_x = 3 * (odd * u_x + (1 - o) * g_x);
        const Real h_y = 3 * (odd * u_y + (1 - o) * g_y);
        const Real h_z = 3 * (odd * u_z + (1 - o) * g_z);

        f0[x] = a0 - even * (a0 - w0 * density);
        const auto pair = [=](Real * to_q, Real * to_opposite, Real plus, Real minus, Real a, Real b, Real w,
                              Real h) __attribute__((always_inline)) {
            const Real relaxed_even = e * plus - w * d;
            const Real relaxed_odd = o * minus - w * h;
            *to_q = a - relaxed_even - relaxed_odd;
            *to_opposite = b - relaxed_even + relaxed_odd;
        };
        pair(f2 + x, f1 + x, p_x, m_x, a1, a2, w1, h_x);
        pair(f4 + x, f3 + x, p_y, m_y, a3, a4, w1, h_y);
        pair(f6 + x, f5 + x, p_z, m_z, a5, a6, w1, h_z);
        pair(f8 + x, f7 + x, p_xy, m_xy, a7, a8, w2, h_x + h_y);
        pair(f10 + x, f9 + x, p_yx, m_yx, a9, a10, w2, h_x - h_y);
        pair(f12 + x, f11 + x, p_xz, m_xz, a11, a12, w2, h_x + h_z);
        pair(f14 + x, f13 + x, p_zx, m_zx, a13, a14, w2, h_x - h_z);
        pair(f16 + x, f15 + x, p_yz, m_yz, a15, a16, w2, h_y + h_z);
        pair(f18 + x, f17 + x, p_zy, m_zy, a17, a18, w2, h_y - h_z);
    }
}

template <class Real>
void link(const LinkTask<Real>& task) {
    Real* const destination = task.destination;
    const Real* const near = task.near;
    const Real* const far = task.far;
    const Real* const back = task.back;
    const Real kappa = task.kappa;
    if (task.wall != nullptr) {
        const Real* const wall = task.wall;
#pragma omp simd
        for (long x = 0; x < task.nodes; ++x) {
            destination[x] = near[x] + kappa * (far[x] - back[x]) - wall[x];
        }
        return;
    }
    const Real wall = task.wall_constant;
#pragma omp simd
    for (long x = 0; x < task.nodes; ++x) {
        destination[x] = near[x] + kappa * (far[x] - back[x]) - wall;
    }
}

template <class Real>
constexpr Kernels<Real> make_kernels() {
    return {
        {collide<Real, Fluid::newtonian, Coupling::none>, collide<Real, Fluid::newtonian, Coupling::observed>,
         collide<Real, Fluid::newtonian, Coupling::coupled>},
        {collide<Real, Fluid::cross, Coupling::none>, collide<Real, Fluid::cross, Coupling::observed>,
         collide<Real, Fluid::cross, Coupling::coupled>},
        link<Real>};
}

}  // namespace

extern const Kernels<float> BIOPRINT_KERNEL_TABLE(float);
extern const Kernels<double> BIOPRINT_KERNEL_TABLE(double);
// Each of the three sources that include this body defines its own table once.
// NOLINTBEGIN(misc-definitions-in-headers)
constexpr Kernels<float> BIOPRINT_KERNEL_TABLE(float) = make_kernels<float>();
constexpr Kernels<double> BIOPRINT_KERNEL_TABLE(double) = make_kernels<double>();
// NOLINTEND(misc-definitions-in-headers)

}  // namespace bioprint::d3q19
