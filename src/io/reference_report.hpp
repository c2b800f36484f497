#pragma once

#include <string>

#include "io/settings.hpp"

/// What `--verbose` adds: the fast routes of an answer against adaptive quadrature, with its own error
/// estimate.
namespace bioprint {

std::string reference_report(const Settings& question);

}  // namespace bioprint
