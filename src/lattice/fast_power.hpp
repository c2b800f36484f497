#pragma once

#include <bit>
#include <cstdint>

/// x^a for loops that must vectorise: polynomials and integer arithmetic on the exponent field, no call, no
/// branch.
///
/// log2 by its area-tangent series on [1/√2, √2), 2^x by its Taylor polynomial on [-1/2, 1/2].
/// Accuracy: 3e-13 relative for results between 1e-290 and 1e290 (tests/unit/lattice/fast_power.cpp).
namespace bioprint::lattice {

/// log2 of a normal, positive number.
[[gnu::always_inline]] inline double fast_log2(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    // Moving the binade's border from 1 to √½ keeps the mantissa near 1, where the series is short.
    const std::uint64_t shifted = bits - 0x3fe6a09e667f3bcdULL;
    // The exponent is read through the low mantissa bits of 2^52 + 2^51: AVX2 has no 64-bit integer
    // conversion.
    const double exponent =
        std::bit_cast<double>(((shifted >> 52U) ^ 0x800ULL) | 0x4338000000000000ULL) - 6755399441057792.0;
    const std::uint64_t mantissa_bits = (shifted & 0x000fffffffffffffULL) + 0x3fe6a09e667f3bcdULL;
    const double m = std::bit_cast<double>(mantissa_bits);
    const double s = (m - 1.0) / (m + 1.0);
    const double q = s * s;
    double series = 1.0 / 17.0;
    series = series * q + 1.0 / 15.0;
    series = series * q + 1.0 / 13.0;
    series = series * q + 1.0 / 11.0;
    series = series * q + 1.0 / 9.0;
    series = series * q + 1.0 / 7.0;
    series = series * q + 1.0 / 5.0;
    series = series * q + 1.0 / 3.0;
    series = series * q + 1.0;
    return exponent + 2.8853900817779268147 * s * series;
}

/// 2^x for |x| < 1000.
[[gnu::always_inline]] inline double fast_exp2(double x) {
    constexpr double shift = 6755399441055744.0;  // 2^52 + 2^51: adding it rounds to an integer
    const double rounded = x + shift;
    const double f = (x - (rounded - shift)) * 0.69314718055994530942;
    double p = 1.0 / 39916800.0;
    p = p * f + 1.0 / 3628800.0;
    p = p * f + 1.0 / 362880.0;
    p = p * f + 1.0 / 40320.0;
    p = p * f + 1.0 / 5040.0;
    p = p * f + 1.0 / 720.0;
    p = p * f + 1.0 / 120.0;
    p = p * f + 1.0 / 24.0;
    p = p * f + 1.0 / 6.0;
    p = p * f + 0.5;
    p = p * f + 1.0;
    p = p * f + 1.0;
    const std::uint64_t scale = (std::bit_cast<std::uint64_t>(rounded) << 52U) + 0x3ff0000000000000ULL;
    return p * std::bit_cast<double>(scale);
}

}  // namespace bioprint::lattice
