#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bioprint/io/quantity.hpp"
#include "io/decimal.hpp"

/// The table of units and the grammar that combines them.
///
///   unit    = ["1"] ["/"] factor { ("." | "*" | "·" | "-" | space | "/") factor }
///   factor  = [prefix] name [ ["^"] whole power from -9 to 9 ] | "s" "^" "n"
///
/// A slash divides by the one factor behind it.
namespace bioprint {

/// Powers of the base units; the cell's radius counts as one, so that 3Rc is known and yet no length.
struct Powers {
    int kilogram = 0;
    int metre = 0;
    int second = 0;
    int cell_radius = 0;
    int second_to_n = 0;  ///< s^n, n the flow index: a unit of its own, because n is not known here
    bool operator==(const Powers&) const = default;
};

struct Unit {
    ExactFactor factor;  ///< to SI
    Powers powers;
};

/// The unit `text` means, or nothing when it is not known.
std::optional<Unit> parse_unit(std::string_view text);

Powers powers_of(Dimension dimension);

/// "a time", "an area", …; "a quantity of another kind" for what has no name here.
std::string_view kind_name(const Powers& powers);

/// Everyday spellings of a dimension's units, the usual ones first.
std::span<const std::string_view> usual_units(Dimension dimension);

}  // namespace bioprint
