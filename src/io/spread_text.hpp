#pragma once

#include <optional>
#include <string_view>

#include "bioprint/io/quantity.hpp"

/// Quantities with their standard deviation: `0.75±0.05`, `10+-1.5Pa.s`, `50um+/-2um`, `10Pa.s±15%`.
///
/// A percentage is of the value. Where one of the two numbers has no unit it has that of the other.
namespace bioprint {

struct SpreadQuantity {
    double value;      ///< SI
    double deviation;  ///< SI, >= 0
};

bool has_spread(std::string_view text);

/// Nothing when the text has no such sign.
/// @throws UsageError  no quantities of that dimension, or a negative deviation
std::optional<SpreadQuantity> parse_spread(std::string_view text, Dimension dimension,
                                           std::string_view origin, NumberStyle style = {});

}  // namespace bioprint
