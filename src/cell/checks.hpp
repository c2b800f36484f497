#pragma once

#include <cmath>
#include <string>

#include "bioprint/errors.hpp"

/// What the public functions of this room ask of their arguments.
namespace bioprint {

inline void require_not_negative(double value, const char* name) {
    if (!(value >= 0.0) || !std::isfinite(value)) {
        throw UsageError(std::string("cell: the ") + name + " must be a finite number, zero or more");
    }
}

inline void require_positive(double value, const char* name) {
    if (!(value > 0.0) || !std::isfinite(value)) {
        throw UsageError(std::string("cell: the ") + name + " must be a finite number above zero");
    }
}

}  // namespace bioprint
