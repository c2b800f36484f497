#pragma once

#include <string>

#include "io/sweep.hpp"

/// A sweep in words, for its picture.
namespace bioprint {

/// What changes: "Over radius and velocity".
std::string sweep_title(const Sweep& sweep);

/// What all rows have in common: "R 50 µm; ink alginate-2.5: η0 10 Pa s, …"; empty when no row is a case.
std::string sweep_subtitle(const Sweep& sweep);

}  // namespace bioprint
