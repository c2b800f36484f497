#pragma once

#include <optional>
#include <vector>

namespace bioprint {

/// The decay time of a stress after its peak: least squares of its logarithm between half and a twentieth of the
/// peak. None when fewer than three samples lie there or they do not fall.
std::optional<double> decay_time(const std::vector<double>& time, const std::vector<double>& stress);

}  // namespace bioprint
