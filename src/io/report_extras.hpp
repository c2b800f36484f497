#pragma once

#include <string>

#include "io/answer_object.hpp"

/// The parts of a report that were asked for beside the prediction, each with its heading; empty where the answer has
/// none.
namespace bioprint {

/// Limits of `--check`, and whether they hold.
std::string report_checks(const Json& answer);

/// The spread of the answer, its inputs, and which of them to measure better.
std::string report_uncertainty(const Json& answer);

/// The whole way of each cell: its largest stress and where that is.
std::string report_passages(const Json& answer);

}  // namespace bioprint
