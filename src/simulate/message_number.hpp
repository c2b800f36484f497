#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace bioprint {

/// A value in a message, to three digits: what a user is told to change need not be known better.
inline std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value);
    return text.data();
}

}  // namespace bioprint
