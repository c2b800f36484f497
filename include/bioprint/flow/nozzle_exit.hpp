#pragma once

#include <optional>

#include "bioprint/flow/nozzle_flow.hpp"

/// The elongation a bioink undergoes where it leaves the nozzle: from the nozzle's profile to the plug of the
/// strand.
///
///   ε̇ = (u_max − u_avg)/(2R),   S_xx = −ε̇,  S_rr = S_θθ = ε̇/2,   σ = η(√3 ε̇) √3 ε̇            Müller et al.
///
/// An average over the transition length 2R on the axis; a compression along the flow. The peak is higher: at
/// R = 50 µm, 5 mm/s it is 1.7 times (α = 0) to 1.4 times (α = 0.75) this average by an independent
/// finite-element solution, and the average over ±R round the peak 5 % (α = 0) to 16 % (α = 0.75) lower.
namespace bioprint {

struct NozzleExit {
    double elongation_rate;      ///< ε̇ [1/s], ≥ 0
    double elongational_stress;  ///< average fluid stress of the elongation [Pa]
};

NozzleExit nozzle_exit(const NozzleFlow& flow);

/// The flow at which the elongational stress of the exit reaches `stress` [Pa] > 0; none when this ink bears
/// no such flow.
std::optional<NozzleFlow> flow_at_elongational_stress(const Ink& ink, double radius, double stress);

}  // namespace bioprint
