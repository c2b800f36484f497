#pragma once

#include <string>

#include "io/fit_answer.hpp"
#include "io/table.hpp"

/// A fit for a person at a shell: what was read, the parameters with their errors, the laws side by side, what to do
/// next.
namespace bioprint {

std::string fit_table(const FitAnswer& answer, TableStyle style);

}  // namespace bioprint
