#pragma once

#include <string_view>

#include "bioprint/io/quantity.hpp"

namespace bioprint {

/// The dimension of the number at a dotted path of the answer; dimensionless when it has none.
Dimension dimension_of_path(std::string_view path);

}  // namespace bioprint
