#include "io/decimal.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>
#include <system_error>

#include "io/text.hpp"

namespace bioprint {

namespace {

constexpr std::uint64_t largest = std::uint64_t{1} << 60U;
constexpr int extra_digits = 40;
constexpr long largest_exponent = 99999;
constexpr std::string_view minus_sign = "\u2212";

std::optional<std::uint64_t> product(std::uint64_t a, std::uint64_t b) {
    if (b != 0 && a >= largest / b) return {};
    return a * b;
}

std::size_t sign_length(std::string_view text, bool& negative) {
    if (text.starts_with('+')) return 1;
    negative = true;
    if (text.starts_with('-')) return 1;
    if (text.starts_with(minus_sign)) return minus_sign.size();
    negative = false;
    return 0;
}

/// Digits times a number; digits as values 0–9, most significant first.
std::string times(const std::string& digits, std::uint64_t number) {
    std::string out;
    out.reserve(digits.size() + 20);
    std::uint64_t carry = 0;
    for (auto it = digits.rbegin(); it != digits.rend(); ++it) {
        carry += static_cast<std::uint64_t>(*it - '0') * number;
        out += static_cast<char>('0' + carry % 10);
        carry /= 10;
    }
    for (; carry > 0; carry /= 10) out += static_cast<char>('0' + carry % 10);
    std::reverse(out.begin(), out.end());
    return out;
}

/// Digits divided by a number, with `extra_digits` more digits and a 1 for a remainder; lowers `power` by
/// them.
std::string divided(std::string digits, std::uint64_t number, long& power) {
    if (number == 1) return digits;
    digits.append(extra_digits, '0');
    power -= extra_digits;
    std::uint64_t remainder = 0;
    for (char& digit : digits) {
        remainder = remainder * 10 + static_cast<std::uint64_t>(digit - '0');
        digit = static_cast<char>('0' + remainder / number);
        remainder %= number;
    }
    if (remainder != 0) {
        digits += '1';
        --power;
    }
    return digits;
}

}  // namespace

std::optional<ExactFactor> multiply(const ExactFactor& a, const ExactFactor& b) {
    const std::uint64_t left = std::gcd(a.numerator, b.denominator);
    const std::uint64_t right = std::gcd(b.numerator, a.denominator);
    const auto numerator = product(a.numerator / left, b.numerator / right);
    const auto denominator = product(a.denominator / right, b.denominator / left);
    if (!numerator || !denominator) return {};
    return ExactFactor{.numerator = *numerator, .denominator = *denominator, .power = a.power + b.power};
}

ExactFactor inverse(const ExactFactor& a) {
    return {.numerator = a.denominator, .denominator = a.numerator, .power = -a.power};
}

ScannedNumber scan_number(std::string_view text, char mark) {
    ScannedNumber number;
    std::size_t i = sign_length(text, number.negative);
    const std::size_t start = i;
    bool any = false;
    bool marked = false;
    for (; i < text.size(); ++i) {
        if (is_digit(text[i])) {
            any = true;
        } else if (text[i] == mark && !marked) {
            marked = true;
        } else {
            break;
        }
    }
    if (!any) return {};
    number.digits = text.substr(start, i - start);
    number.length = i;
    if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
        bool negative = false;
        std::size_t j = i + 1;
        j += sign_length(text.substr(j), negative);
        const std::size_t first = j;
        for (; j < text.size() && is_digit(text[j]); ++j) {
            number.exponent = std::min(number.exponent * 10 + (text[j] - '0'), largest_exponent);
        }
        if (j > first) number.length = j;
        if (negative) number.exponent = -number.exponent;
    }
    return number;
}

std::optional<double> scaled(const ScannedNumber& number, char mark, const ExactFactor& factor) {
    std::string digits;
    digits.reserve(number.digits.size() + 64);
    long power = number.exponent + factor.power;
    bool behind = false;
    for (const char c : number.digits) {
        if (c == mark) {
            behind = true;
            continue;
        }
        if (behind) --power;
        if (!digits.empty() || c != '0') digits += c;
    }
    if (digits.empty()) return 0.0;
    digits = divided(times(digits, factor.numerator), factor.denominator, power);
    digits += 'e';
    digits += std::to_string(power);
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value) ||
        value == 0.0) {
        return {};
    }
    return number.negative ? -value : value;
}

}  // namespace bioprint
