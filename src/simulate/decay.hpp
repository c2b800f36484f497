#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace bioprint {

/// From here the load is all but gone, in nozzle radii behind the lip: in 27 drafts, α 0 and 0.75, 0.1 to 20 mm/s, a decay
/// that began later was within 22 % of the relaxation time, one that began before 1 was up to 40 times longer.
inline constexpr double strand_at_rest = 1.25;

/// The decay time of a stress after its peak: least squares of its logarithm between half and a twentieth of the
/// peak. None when fewer than three samples lie there or they do not fall, or when the first of them is not yet where
/// the load is gone: it is the load's fading then, not the cell's relaxation.
/// @param free_from  the first sample there
std::optional<double> decay_time(const std::vector<double>& time, const std::vector<double>& stress,
                                 std::size_t free_from);

}  // namespace bioprint
