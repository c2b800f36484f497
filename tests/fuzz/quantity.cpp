// Any bytes as a quantity, a list or offsets: a finite number or a UsageError whose message is UTF-8.

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "bioprint/io/quantity.hpp"
#include "io/text.hpp"

using namespace bioprint;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

void check_number(double value, Dimension dimension) {
    require(std::isfinite(value) && !(value == 0.0 && std::signbit(value)));
    const auto text = format_shortest(value);
    require(parse_quantity(text, dimension, "") == value);
    const auto [number, unit] = format_lab(value, dimension);
    require(number != "-0" && number != "n/a");
}

void check_message(std::string_view message) {
    while (!message.empty()) {
        const auto length = utf8_length(message);
        require(length > 0 && (length > 1 || message[0] >= ' '));
        message.remove_prefix(length);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const auto dimension = static_cast<Dimension>((data[0] & 15U) % 9U);
    const NumberStyle style{.decimal_comma = (data[0] & 16U) != 0};
    const unsigned mode = data[0] >> 5U;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (mode == 0) {
            for (const double value : parse_quantity_list(text, dimension, "--x", style)) {
                require(std::isfinite(value));
            }
        } else if (mode == 1) {
            for (const auto& offset : parse_offsets(text, "--offset", style))
                require(std::isfinite(offset.value));
        } else {
            check_number(parse_quantity(text, dimension, "--x", style), dimension);
        }
    } catch (const UsageError& error) {
        check_message(error.what());
    }
    return 0;
}
