#pragma once

#include <array>

#include "lattice/d2q9.hpp"

/// One collision along a stretch of a lattice row, in place.
///
/// Populations are deviations from rest. The population of direction k is read at population[k] and what
/// leaves along k is written where its opposite was read: with the right pointers this one kernel is both
/// steps of the AA pattern.
///
///   equilibrium    w (ρ' + 3 c·u), linear: a steady state is creeping flow at any lattice Reynolds number
///   relaxation     even part 1/(t + 1/2), odd part 1/(1/2 + Λ/t), t = 3 ν, Λ = 3/16
///   sources        mass −u_r/r; momentum τ_xr/r along x, τ_rr/r − 2ν u_r/r² along r, both from local moments
namespace bioprint::lattice {

/// t = 3 ν of the Cross law: t_inf + (t0 − t_inf)/(1 + (K rate)^alpha).
struct CrossRelaxation {
    double t0;
    double t_inf = 0.0;
    double time_constant = 0.0;
    double alpha = 0.0;

    [[nodiscard]] bool uniform() const { return alpha == 0.0; }
    [[nodiscard]] double uniform_t() const { return 0.5 * (t0 + t_inf); }
};

/// Λ, the product of the two relaxation times less one half each: half-way walls are exact for Poiseuille
/// flow at 3/16.
inline constexpr double magic_parameter = 3.0 / 16.0;

struct RowStretch {
    std::array<double*, D2Q9::size> population;
    double* t;              ///< relaxation of each node; untouched by an ink of uniform viscosity
    const double* force_x;  ///< force density along x of each node; null where there is none
    const double* force_r;
    double* velocity_x;  ///< where the velocity is stored; null together with the force
    double* velocity_r;
    int count;
    double inverse_radius;
    double body_force;
};

struct KernelTable {
    using Row = void (*)(const RowStretch&, const CrossRelaxation&);
    Row plain;         ///< viscosity as stored (or uniform)
    Row forced;        ///< the same with a force field in and the velocity out
    Row plain_update;  ///< and stores the viscosity of the rate it has seen
    Row forced_update;
    const char* name;
};

/// The kernels of the widest vectors this processor has.
const KernelTable& kernels(const CrossRelaxation& ink);

}  // namespace bioprint::lattice
