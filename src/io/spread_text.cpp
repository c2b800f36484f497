#include "io/spread_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "bioprint/errors.hpp"
#include "io/decimal.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr std::array<std::string_view, 3> signs = {"±", "+/-", "+-"};

struct Parts {
    std::string value;
    std::string deviation;
};

std::optional<Parts> split(std::string_view text) {
    for (const std::string_view sign : signs) {
        const std::size_t at = text.find(sign);
        if (at == std::string_view::npos) continue;
        return Parts{.value = std::string(trimmed(text.substr(0, at))),
                     .deviation = std::string(trimmed(text.substr(at + sign.size())))};
    }
    return std::nullopt;
}

/// What stands behind the number.
std::string_view unit_in(std::string_view text, NumberStyle style) {
    return trimmed(text.substr(scan_number(text, style.decimal_comma ? ',' : '.').length));
}

}  // namespace

bool has_spread(std::string_view text) {
    return std::any_of(signs.begin(), signs.end(),
                       [&](std::string_view sign) { return text.find(sign) != std::string_view::npos; });
}

std::optional<SpreadQuantity> parse_spread(std::string_view text, Dimension dimension,
                                           std::string_view origin, NumberStyle style) {
    const std::optional<Parts> parts = split(text);
    if (!parts) return std::nullopt;
    const std::string name(origin);
    const auto refuse = [&](const std::string& problem) {
        throw UsageError(name + ": got " + in_quotes(text) + ", " + problem +
                             "; behind the ± it takes a standard deviation, as in 10±1 or 10±5%",
                         name);
    };
    if (parts->deviation.empty()) refuse("with nothing behind the ±");
    if (has_spread(parts->deviation)) refuse("with two ±");
    const std::string_view behind = unit_in(parts->deviation, style);
    const std::string_view front = unit_in(parts->value, style);
    const bool relative = behind == "%";
    SpreadQuantity result{.value = 0.0, .deviation = 0.0};
    const bool borrowed = front.empty() && !behind.empty() && !relative;
    result.value = parse_quantity(borrowed ? parts->value + " " + std::string(behind) : parts->value,
                                  dimension, origin, style);
    if (relative) {
        result.deviation = std::abs(result.value) *
                           parse_quantity(parts->deviation, Dimension::dimensionless, origin, style);
    } else {
        result.deviation = parse_quantity(
            behind.empty() && !front.empty() ? parts->deviation + " " + std::string(front) : parts->deviation,
            dimension, origin, style);
    }
    if (!(result.deviation >= 0.0)) refuse("with a negative standard deviation");
    return result;
}

}  // namespace bioprint
