#pragma once

/// The Herschel-Bulkley law of an ink that flows past a yield stress only, and is rigid below it.
///
///   τ(γ̇) = τ_y + k γ̇^n   for γ̇ > 0,        γ̇ = 0   for τ ≤ τ_y                     Herschel and Bulkley 1926
///
/// Nothing is regularised: below the yield stress the rate is zero, and so the viscosity τ/γ̇ is +infinity. Degenerate
/// cases: n = 1 is Bingham's plastic, τ_y = 0 the power law.
namespace bioprint {

struct HerschelBulkleyInk {
    double yield_stress;  ///< τ_y [Pa], ≥ 0
    double consistency;   ///< k [Pa s^n], > 0
    double flow_index;    ///< n, > 0
};

/// η = τ/γ̇ at a rate of strain [1/s] ≥ 0, in Pa s; +infinity at rest.
double viscosity(const HerschelBulkleyInk& ink, double rate);

/// τ at a rate of strain [1/s] ≥ 0, in Pa; the yield stress at rest, which bears anything up to it.
double stress(const HerschelBulkleyInk& ink, double rate);

/// +infinity: the stress always grows with the rate.
double largest_stable_rate(const HerschelBulkleyInk& ink);

/// d ln(stress)/d ln(rate): 0 at the yield stress, n far above it.
double flow_index(const HerschelBulkleyInk& ink, double rate);

/// The rate of strain [1/s] of a stress [Pa] ≥ 0: 0 up to the yield stress.
/// @throws NoSteadyFlow  the rate is beyond 1e100/s
double rate_at_stress(const HerschelBulkleyInk& ink, double stress);

}  // namespace bioprint
