#pragma once

#include <optional>
#include <string_view>

#include "bioprint/io/quantity.hpp"
#include "io/decimal.hpp"
#include "io/units.hpp"

/// What the parsers of quantities share: the parts of one, and how each refusal is worded.
namespace bioprint {

/// What is asked for, and who asks.
struct QuantityRequest {
    Dimension dimension = Dimension::dimensionless;
    std::string_view option;
    NumberStyle style;
    bool offset = false;  ///< radii of the cell are welcome too
};

struct ParsedQuantity {
    ScannedNumber number;
    std::optional<Unit> unit;  ///< none: a number alone
};

/// @throws UsageError  no number, or a unit that is not known
ParsedQuantity parse_number_and_unit(std::string_view text, const QuantityRequest& request);

/// @throws UsageError  a double cannot hold it
double to_si(const ParsedQuantity& parsed, const ExactFactor& factor, std::string_view text,
             const QuantityRequest& request);

[[noreturn]] void fail_no_number(std::string_view text, const QuantityRequest& request);
[[noreturn]] void fail_malformed_number(std::string_view text, const QuantityRequest& request);
[[noreturn]] void fail_unknown_unit(std::string_view text, std::string_view unit,
                                    const QuantityRequest& request);
[[noreturn]] void fail_wrong_kind(std::string_view text, const Powers& powers,
                                  const QuantityRequest& request);
[[noreturn]] void fail_out_of_range(std::string_view text, const QuantityRequest& request);
/// "--radius: got 'TEXT', PROBLEM; it takes a length such as 50um"
[[noreturn]] void fail_quantity(std::string_view text, std::string_view problem,
                                const QuantityRequest& request);

}  // namespace bioprint
