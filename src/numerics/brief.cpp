#include "numerics/brief.hpp"

#include <array>
#include <charconv>

namespace bioprint {

std::string brief(double value, int digits) {
    std::array<char, 48> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

}  // namespace bioprint
