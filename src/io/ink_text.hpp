#pragma once

#include <string>

#include "bioprint/rheology/ink.hpp"

namespace bioprint {

/// The parameters of an ink for a person: "η0 10 Pa s, K 50 ms, α 0.75".
std::string ink_text(const Ink& ink);

}  // namespace bioprint
