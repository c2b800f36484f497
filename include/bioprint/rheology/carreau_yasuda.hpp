#pragma once

/// The Carreau-Yasuda law of a shear-thinning ink with a plateau.
///
///   η(γ̇) = η_inf + (η0 − η_inf) [1 + (K γ̇)^a]^((n−1)/a)                               Carreau 1972; Yasuda 1979
///
/// n is the flow index deep in the thinning, a how sharply the plateau bends into it. Degenerate cases: n = 1 is a
/// Newtonian fluid of η0; a = 2 is Carreau's law; a = 1 − n is the Cross law with α = 1 − n; for K γ̇ ≫ 1 it is the power
/// law of k = η0 K^(n−1); at n = 0 and η_inf = 0 the stress saturates at η0/K.
namespace bioprint {

struct CarreauYasudaInk {
    double eta0;              ///< zero-shear viscosity [Pa s], > 0
    double eta_inf = 0.0;     ///< infinite-shear viscosity [Pa s], 0 ≤ η_inf ≤ η0
    double time_constant;     ///< K [s], > 0
    double transition = 2.0;  ///< a, > 0
    double flow_index;        ///< n, 0 ≤ n
};

/// η at a rate of strain [1/s] ≥ 0, in Pa s.
double viscosity(const CarreauYasudaInk& ink, double rate);

/// η γ̇ at a rate of strain [1/s] ≥ 0, in Pa.
double stress(const CarreauYasudaInk& ink, double rate);

/// +infinity: the stress always grows with the rate.
double largest_stable_rate(const CarreauYasudaInk& ink);

/// d ln(stress)/d ln(rate): 1 on the plateau, n deep in the thinning.
double flow_index(const CarreauYasudaInk& ink, double rate);

/// The rate of strain [1/s] of a stress [Pa] ≥ 0.
/// @throws NoSteadyFlow  the stress is beyond the saturation of n = 0, or the rate beyond 1e100/K
double rate_at_stress(const CarreauYasudaInk& ink, double stress);

}  // namespace bioprint
