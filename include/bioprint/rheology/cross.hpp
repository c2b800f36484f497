#pragma once

/// The Cross law of a shear-thinning bioink.
///
///   η(γ̇) = η_inf + (η0 − η_inf) / (1 + (K γ̇)^α)                     Cross 1965; Müller et al. 2020, η_inf =
///   0
///
/// γ̇ = sqrt(2 S:S) is the rate of strain [1/s], K the time constant [s]: 1/K is the rate at which half of
/// η0 − η_inf is gone. Degenerate cases: α = 0 is a Newtonian fluid of (η0 + η_inf)/2, not η0; at α = 1 the
/// stress saturates; for α > 1 it has a maximum, past which no steady flow exists.
namespace bioprint {

struct CrossInk {
    double eta0;           ///< zero-shear viscosity [Pa s], > 0
    double eta_inf = 0.0;  ///< infinite-shear viscosity [Pa s], 0 ≤ η_inf ≤ η0
    double time_constant;  ///< K [s], > 0
    double alpha;          ///< thinning exponent, ≥ 0
};

/// η at a rate of strain [1/s] ≥ 0, in Pa s.
double viscosity(const CrossInk& ink, double rate);

/// η γ̇ at a rate of strain [1/s] ≥ 0, in Pa.
double stress(const CrossInk& ink, double rate);

/// The largest rate up to which the stress still grows with the rate, in 1/s; +infinity when it always does.
double largest_stable_rate(const CrossInk& ink);

/// d ln(stress)/d ln(rate) at a rate of strain [1/s] ≥ 0: the exponent of the power law that touches the ink's curve
/// there. 1 for a Newtonian ink, 0 where the stress saturates.
double flow_index(const CrossInk& ink, double rate);

/// The rate of strain [1/s] of a stress [Pa] ≥ 0: the inverse of `stress` on its rising branch.
/// @throws NoSteadyFlow  the stress is beyond what the ink can bear, or its rate beyond 1e100/K
double rate_at_stress(const CrossInk& ink, double stress);

}  // namespace bioprint
