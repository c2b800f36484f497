#pragma once

#include <string>

#include "io/settings.hpp"

/// `--history`: every cell on its way into the strand: with a nozzle length from the entrance, where it is
/// round, else from four nozzle radii before the lip.
namespace bioprint {

/// CSV, the positions one below the other: offset, x from the lip, time, r, stretches, angle, von Mises
/// stress, undisturbed fluid stress, exposure.
/// @throws UsageError, NoSteadyFlow, NotConverged  as predict() and exit_passage()
std::string history_csv(const Settings& question);

}  // namespace bioprint
