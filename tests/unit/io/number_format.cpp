#include "bioprint/io/number_format.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace bioprint;

namespace {

std::string lab(double value, Dimension dimension, int digits = 4) {
    const auto [number, unit] = format_lab(value, dimension, digits);
    return unit.empty() ? number : number + " " + unit;
}

}  // namespace

TEST_CASE("number format: the shortest form reads back to the same double") {
    CHECK(format_shortest(5e-5) == "5e-05");
    CHECK(format_shortest(0.75) == "0.75");
    CHECK(format_shortest(-0.0) == "0");
    std::mt19937_64 random(7);
    for (int i = 0; i < 100000; ++i) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value)) continue;
        const std::string text = format_shortest(value);
        double back = 0.0;
        std::from_chars(text.data(), text.data() + text.size(), back);
        CHECK(back == value);
    }
}

TEST_CASE("number format: lab units put the number between 1 and 1000") {
    CHECK(lab(5e-5, Dimension::length) == "50 µm");
    CHECK(lab(0.005, Dimension::velocity) == "5 mm/s");
    CHECK(lab(436.2, Dimension::pressure) == "436.2 Pa");
    CHECK(lab(436.2, Dimension::pressure, 3) == "436 Pa");
    CHECK(lab(1.74e7, Dimension::pressure_gradient) == "17.4 MPa/m");
    CHECK(lab(3.9166666e-11, Dimension::volume_flow) == "39.17 nL/s");
    CHECK(lab(10, Dimension::viscosity) == "10 Pa s");
    CHECK(lab(0.0123456, Dimension::time) == "12.35 ms");
    CHECK(lab(1234.56, Dimension::rate) == "1235 1/s");
    CHECK(lab(0.75, Dimension::dimensionless) == "0.75");
    CHECK(lab(-1050, Dimension::pressure) == "-1.05 kPa");
}

TEST_CASE("number format: rounding up to 1000 takes the next unit") {
    CHECK(lab(999.96, Dimension::pressure) == "1 kPa");
    CHECK(lab(999.94, Dimension::pressure) == "999.9 Pa");
    CHECK(lab(9.9999e-10, Dimension::length, 3) == "1 nm");
}

TEST_CASE("number format: zero has no sign and the usual unit") {
    CHECK(lab(0.0, Dimension::length) == "0 µm");
    CHECK(lab(-0.0, Dimension::pressure) == "0 Pa");
    CHECK(lab(-0.0, Dimension::dimensionless) == "0");
}

TEST_CASE("number format: what no unit can hold gets an exponent") {
    CHECK(lab(1.5e-15, Dimension::length) == "1.5e-06 nm");
    CHECK(lab(2.5e13, Dimension::rate) == "2.5e+13 1/s");
    CHECK(lab(2e200, Dimension::length) == "2e+200 m");
    CHECK(lab(std::numeric_limits<double>::infinity(), Dimension::length) == "n/a µm");
    CHECK(lab(std::nan(""), Dimension::dimensionless) == "n/a");
}

TEST_CASE("number format: a column in one unit") {
    const LabUnit& unit = choose_lab_unit(0.012, Dimension::length);
    CHECK(unit.name == "mm");
    CHECK(format_in(0.012, unit) == "12");
    CHECK(format_in(0.00025, unit) == "0.25");
    CHECK(format_in(1e-9, unit) == "1e-06");
    CHECK(format_in(0.0, unit) == "0");
}

TEST_CASE("number format: four digits are within half a unit of the fourth") {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> exponent(-12.0, 12.0);
    for (int i = 0; i < 20000; ++i) {
        const double value = std::pow(10.0, exponent(random));
        const auto [number, unit] = format_lab(value, Dimension::dimensionless);
        double back = 0.0;
        std::from_chars(number.data(), number.data() + number.size(), back);
        CHECK(std::abs(back / value - 1.0) <= 0.5001e-3);
    }
}
