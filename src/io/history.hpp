#pragma once

#include <string>

#include "io/settings.hpp"

/// `--history`: the centred cell on its way from four nozzle radii before the lip into the strand.
namespace bioprint {

/// CSV: x [m] from the lip, time [s], stretches, von Mises stress, undisturbed fluid stress, exposure.
/// @throws UsageError, NoSteadyFlow, NotConverged  as predict() and exit_passage()
std::string history_csv(const Settings& question);

}  // namespace bioprint
