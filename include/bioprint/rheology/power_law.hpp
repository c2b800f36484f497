#pragma once

/// The power law of an ink that has no plateau where it is used (Ostwald, de Waele).
///
///   τ(γ̇) = k γ̇^n,   η(γ̇) = k γ̇^(n−1)
///
/// Degenerate cases: n = 1 is a Newtonian fluid of k; for n < 1 the viscosity grows beyond every bound as the rate
/// vanishes, so an ink at rest has none (+infinity here).
namespace bioprint {

struct PowerLawInk {
    double consistency;  ///< k [Pa s^n], > 0
    double flow_index;   ///< n, > 0
};

/// η at a rate of strain [1/s] ≥ 0, in Pa s; +infinity at rest for n < 1.
double viscosity(const PowerLawInk& ink, double rate);

/// η γ̇ at a rate of strain [1/s] ≥ 0, in Pa.
double stress(const PowerLawInk& ink, double rate);

/// +infinity: the stress always grows with the rate.
double largest_stable_rate(const PowerLawInk& ink);

/// d ln(stress)/d ln(rate): n.
double flow_index(const PowerLawInk& ink, double rate);

/// The rate of strain [1/s] of a stress [Pa] ≥ 0.
/// @throws NoSteadyFlow  the rate is beyond 1e100/s
double rate_at_stress(const PowerLawInk& ink, double stress);

}  // namespace bioprint
