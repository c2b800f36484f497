#pragma once

#include <string>

/// Numbers in messages: few digits, no locale.
namespace bioprint {

/// `value` with at most `digits` significant digits: "496.2", "5e-05".
std::string brief(double value, int digits = 4);

}  // namespace bioprint
