#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "bioprint/errors.hpp"
#include "bioprint/io/quantity.hpp"

using namespace bioprint;

namespace {

std::vector<double> numbers(std::string_view text, NumberStyle style = {}) {
    return parse_quantity_list(text, Dimension::dimensionless, "--alpha", style);
}

std::vector<double> lengths(std::string_view text) {
    return parse_quantity_list(text, Dimension::length, "--radius");
}

std::string refusal(std::string_view text) {
    try {
        parse_quantity_list(text, Dimension::length, "--radius");
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

using Values = std::vector<double>;

}  // namespace

TEST_CASE("quantity list: elements come in order") {
    CHECK(numbers("0,0.3,0.75") == Values{0, 0.3, 0.75});
    CHECK(numbers("0.75") == Values{0.75});
    CHECK(numbers(" 1 , 2 ") == Values{1, 2});
    CHECK(numbers("0,3;0,75", {.decimal_comma = true}) == Values{0.3, 0.75});
}

TEST_CASE("quantity list: a number without a unit takes the next unit to its right") {
    CHECK(lengths("10,20,50um") == Values{1e-5, 2e-5, 5e-5});
    CHECK(lengths("10um,1,2 mm") == Values{1e-5, 1e-3, 2e-3});
    CHECK(lengths("5um,0") == Values{5e-6, 0});
    CHECK(refusal("10um,20").find("'20' has no unit and others do") != std::string::npos);
}

TEST_CASE("quantity list: a range contains both ends") {
    CHECK(numbers("0:0.75:0.15") == Values{0, 0.15, 0.3, 0.45, 0.6, 0.75});
    CHECK(numbers("0.1:0.5:0.1") == Values{0.1, 0.2, 0.3, 0.4, 0.5});
    CHECK(numbers("-0.3:0.3:0.1") == Values{-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3});
    CHECK(numbers("3:1:-1") == Values{3, 2, 1});
    CHECK(numbers("2:2:0") == Values{2});
    CHECK(lengths("10:50:20um") == Values{1e-5, 3e-5, 5e-5});
    CHECK(lengths("10um:0.05mm:20um") == Values{1e-5, 3e-5, 5e-5});
}

TEST_CASE("quantity list: a range whose step does not divide it stops short of its end") {
    CHECK(numbers("0:1:0.3") == Values{0, 0.3, 0.6, 0.9});
    CHECK(numbers("0:1:3") == Values{0});
}

TEST_CASE("quantity list: ranges of tenths and thousandths hit every short decimal exactly") {
    const auto values = numbers("-1000:1000:0.1");
    REQUIRE(values.size() == 20001);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const long tenths = static_cast<long>(i) - 10000;
        CHECK(values[i] == static_cast<double>(tenths) / 10.0);
    }
    CHECK(numbers("0:999.999:0.001").size() == 1'000'000);
}

TEST_CASE("quantity list: malformed lists and ranges are refused") {
    for (const auto* text :
         {"", " ", ",", "1,", ",1", "1,,2", "1:2", "1:2:3:4", "1::2", ":", "1:2,3:1", "0:1:0", "0:1:-1",
          "1:0:1", "0:1:1e-7", "0:1e308:1e-300", "1,nan", "1m,2s", "0:10s:1um"}) {
        CAPTURE(text);
        CHECK(refusal(text) != "accepted");
    }
    CHECK(refusal("0:1:0") ==
          "--radius: got '0:1:0', a range whose step is 0; it takes a length such as 50um");
}

TEST_CASE("quantity list: a list and a range do not mix") {
    for (const char* const text :
         {"0.05um,0.1um:0.3um:0.1um", "1um,2um:4um:1um", "1,2,3:5:1um", "1:3:1.5,4um"}) {
        CAPTURE(text);
        CHECK(refusal(text).find("which mixes a list and a range; write every value out") !=
              std::string::npos);
    }
    CHECK(refusal("0:0,3:0,1um").find("which has a comma; decimals") != std::string::npos);
    CHECK(numbers("0,1:0,3:0,1", {.decimal_comma = true}) == Values{0.1, 0.2, 0.3});
}

TEST_CASE("offsets: lengths and cell radii may be mixed in a list") {
    const auto offsets = parse_offsets("0,1.5Rc,3Rc,20um");
    REQUIRE(offsets.size() == 4);
    CHECK(offsets[0].value == 0);
    CHECK(offsets[1].value == 1.5);
    CHECK(offsets[1].in_cell_radii);
    CHECK(offsets[2].value == 3);
    CHECK(offsets[3].value == 2e-5);
    CHECK_FALSE(offsets[3].in_cell_radii);
    CHECK_FALSE(parse_offsets("2e-5")[0].in_cell_radii);
}

TEST_CASE("offsets: a range counts in cell radii or in lengths but not in both") {
    const auto offsets = parse_offsets("0:4.5Rc:1.5Rc");
    REQUIRE(offsets.size() == 4);
    CHECK(offsets[3].value == 4.5);
    for (const auto& offset : offsets) CHECK(offset.in_cell_radii);
    CHECK_THROWS_AS(parse_offsets("1Rc:20um:5um"), UsageError);
    CHECK_THROWS_AS(parse_offsets("5s"), UsageError);
    CHECK_THROWS_AS(parse_offsets("5Rc2"), UsageError);
}
