#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

/// Decimal numbers in text, and their exact product with a fraction.
namespace bioprint {

/// numerator/denominator · 10^power; both numbers below 2^60 so that a digit times either fits 64 bits.
struct ExactFactor {
    std::uint64_t numerator = 1;
    std::uint64_t denominator = 1;
    int power = 0;
};

/// The product, or nothing when it leaves 2^60.
std::optional<ExactFactor> multiply(const ExactFactor& a, const ExactFactor& b);
/// 1/a.
ExactFactor inverse(const ExactFactor& a);

/// A number at the start of a text, found by `scan_number`.
struct ScannedNumber {
    bool negative = false;
    std::string_view digits;  ///< with the decimal mark, without sign and exponent
    long exponent = 0;        ///< clamped to ±99999
    std::size_t length = 0;   ///< bytes of the text it covers; 0 when there is no number
};

/// The longest decimal number `text` starts with: sign (+, - or U+2212), digits with at most one `mark`,
/// exponent.
ScannedNumber scan_number(std::string_view text, char mark);

/// The double nearest to number · factor; nothing when it is not zero but a double cannot hold it.
///
/// The product is formed on decimal digits (multiplication exact, division to 40 digits more with the
/// remainder kept as a trailing 1), so only the final conversion rounds.
std::optional<double> scaled(const ScannedNumber& number, char mark, const ExactFactor& factor);

}  // namespace bioprint
