#include "bioprint/io/quantity.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

double length(std::string_view text) {
    return parse_quantity(text, Dimension::length, "--radius");
}

std::string refusal(std::string_view text, Dimension dimension, NumberStyle style = {}) {
    try {
        parse_quantity(text, dimension, "--option", style);
    } catch (const UsageError& error) {
        CHECK(error.option() == "--option");
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("quantity: a consistency carries the flow index in its unit") {
    for (const char* text : {"10", "10Pa.s^n", "10 Pa s^n", "10 Pa\u00B7s^n", "10 Pas^n", "10Pa.s\u207F",
                             "1e4 mPa.s^n", "0.01kPa.s^n"}) {
        CAPTURE(text);
        CHECK(parse_quantity(text, Dimension::consistency, "--consistency") == 10.0);
    }
    CHECK(parse_quantity("1 " + std::string(si_unit(Dimension::consistency)), Dimension::consistency, "") ==
          1.0);
    CHECK_THROWS_WITH_AS(parse_quantity("10Pa.s", Dimension::consistency, "--consistency"),
                         "--consistency: got '10Pa.s', a viscosity; it takes a consistency such as 10Pa.s^n",
                         UsageError);
    CHECK_THROWS_WITH_AS(parse_quantity("10Pa.s^0.4", Dimension::consistency, "--consistency"),
                         doctest::Contains("known are Pa.s^n"), UsageError);
    CHECK_THROWS_AS(parse_quantity("10Pa.s^n", Dimension::viscosity, "--eta0"), UsageError);
}

TEST_CASE("quantity: a number alone is SI") {
    CHECK(length("5e-5") == 5e-5);
    CHECK(length("+5E-5") == 5e-5);
    CHECK(length(".5") == 0.5);
    CHECK(length("5.") == 5.0);
    CHECK(length("  1 ") == 1.0);
    CHECK(length("-2.5") == -2.5);
    CHECK(length("\u22122.5") == -2.5);
    CHECK(length("1e\u22123") == 1e-3);
}

TEST_CASE("quantity: minus zero becomes zero") {
    for (const auto* text : {"-0", "-0.0", "-0um", "\u22120e5"}) CHECK_FALSE(std::signbit(length(text)));
}

TEST_CASE("quantity: a conversion gives the double nearest to the exact value") {
    // The right-hand sides are decimal literals, so the compiler's correct rounding is the reference.
    CHECK(length("50um") == 5e-5);
    CHECK(length("0.1 mm") == 1e-4);
    CHECK(length("4.1cm") == 0.041);
    CHECK(length("1in") == 0.0254);
    CHECK(length("7mil") == 0.0001778);
    CHECK(length("250nm") == 2.5e-7);
    CHECK(parse_quantity("141uL/h", Dimension::volume_flow, "") == 3.9166666666666666666666666666667e-11);
    CHECK(parse_quantity("0.7 mL/min", Dimension::volume_flow, "") == 1.16666666666666666666666666667e-8);
    CHECK(parse_quantity("30 psi", Dimension::pressure, "") == 206842.7187950508401016802033604067208134);
    CHECK(parse_quantity("10 Pa.s", Dimension::viscosity, "") == 10.0);
    CHECK(parse_quantity("35cP", Dimension::viscosity, "") == 0.035);
    CHECK(parse_quantity("7%", Dimension::dimensionless, "") == 0.07);
    CHECK(parse_quantity("90/min", Dimension::rate, "") == 1.5);
}

TEST_CASE("quantity: every power-of-ten unit equals the same number with the exponent shifted") {
    for (int i = 1; i < 2000; ++i) {
        const std::string digits = std::to_string(i * 7919) + "." + std::to_string(i);
        CHECK(length(digits + "um") == std::stod(digits + "e-6"));
        CHECK(length(digits + "nm") == std::stod(digits + "e-9"));
        CHECK(parse_quantity(digits + "MPa/m", Dimension::pressure_gradient, "") == std::stod(digits + "e6"));
    }
}

TEST_CASE("quantity: both micro signs and the Latin-1 byte mean micro") {
    CHECK(length("50\u00B5m") == 5e-5);
    CHECK(length("50\u03BCm") == 5e-5);
    CHECK(length("50\xB5m") == 5e-5);
}

TEST_CASE("quantity: spellings of one unit agree") {
    for (const auto* text : {"3mm3/s", "3 mm^3/s", "3mm\u00B3/s", "3 mm3 s-1", "3mm\u00B3\u00B7s\u207B\u00B9",
                             "3 uL/s", "3ul/s", "3\u00B5L / s", "3e-3 cm3/s", "3e-3cc/s", "3e-9m3/s"}) {
        CAPTURE(text);
        CHECK(parse_quantity(text, Dimension::volume_flow, "") == 3e-9);
    }
    for (const auto* text : {"2Pa.s", "2 Pa s", "2 Pa*s", "2Pa\u00B7s", "2Pas", "2 Pa-s", "2000mPa.s",
                             "2000 mPas", "2000cP", "20P", "2 N.s/m2", "2 kg/m/s", "2\u00A0Pa\u202Fs"}) {
        CAPTURE(text);
        CHECK(parse_quantity(text, Dimension::viscosity, "") == 2.0);
    }
    for (const auto* text :
         {"5/s", "5 1/s", "5 s-1", "5s^-1", "5 s\u207B\u00B9", "5Hz", "300/min", "300 1/min"}) {
        CAPTURE(text);
        CHECK(parse_quantity(text, Dimension::rate, "") == 5.0);
    }
    for (const auto* text : {"2bar/m", "200 kPa/m", "0.2Pa/um", "0.2kPa/mm", "2e-3 bar/mm", "0.2 MPa/m"}) {
        CAPTURE(text);
        CHECK(parse_quantity(text, Dimension::pressure_gradient, "") == 2e5);
    }
}

TEST_CASE("quantity: milli and mega differ") {
    CHECK(parse_quantity("1mPa", Dimension::pressure, "") == 1e-3);
    CHECK(parse_quantity("1MPa", Dimension::pressure, "") == 1e6);
    CHECK(refusal("1Mbar", Dimension::pressure).find("did you mean 'mbar'?") != std::string::npos);
}

TEST_CASE("quantity: an error names the option and what it got and what it takes") {
    CHECK(refusal("5s", Dimension::length) == "--option: got '5s', a time; it takes a length such as 50um");
    CHECK(refusal("abc", Dimension::viscosity) ==
          "--option: got 'abc', not a number; it takes a viscosity such as 10Pa.s");
    CHECK(refusal("50umm", Dimension::length) ==
          "--option: got '50umm', whose unit 'umm' is not known (did you mean 'um'?); it takes a length such "
          "as 50um");
    CHECK(refusal("5 furlong", Dimension::length) ==
          "--option: got '5 furlong', whose unit 'furlong' is not known (known are um mm cm m nm in, ...); "
          "it takes "
          "a length such as 50um");
    CHECK(refusal("3Rc", Dimension::length).find("a length in cell radii") != std::string::npos);
    CHECK(refusal("5kpa", Dimension::pressure).find("did you mean 'kPa'?") != std::string::npos);
    CHECK(refusal("3 mm2", Dimension::length).find("an area") != std::string::npos);
    CHECK(refusal("", Dimension::length).find("which is empty") != std::string::npos);
}

TEST_CASE("quantity: what is not a finite decimal number is refused") {
    for (const auto* text : {"",         " ",    "nan",   "NaN",    "inf",    "-inf",
                             "infinity", "0x10", "1.2.3", "1 000",  "1'000",  "--5",
                             "+-5",      "e5",   ".",     "-",      "5e",     "5e+",
                             "1_000",    "5 5",  "1e400", "-1e999", "1e-400", "5um5",
                             "5 um um",  "5um/", "5 /",   "5 m^",   "5 m^0",  "5m10",
                             "5 m//s",   "1/2",  "5!",    "5\n6",   "0b1",    "1e99999999999999999999"}) {
        CAPTURE(text);
        CHECK(refusal(text, Dimension::length) != "accepted");
    }
    CHECK(refusal(std::string_view("5\0um", 4), Dimension::length) != "accepted");
    CHECK(refusal("5 psi9", Dimension::pressure) != "accepted");
}

TEST_CASE("quantity: a decimal comma is read only where it is announced") {
    CHECK(refusal("0,75", Dimension::dimensionless).find("comma") != std::string::npos);
    const NumberStyle comma{.decimal_comma = true};
    CHECK(parse_quantity("0,75", Dimension::dimensionless, "", comma) == 0.75);
    CHECK(parse_quantity("-1,5e-3 mm", Dimension::length, "", comma) == -1.5e-6);
    CHECK(parse_quantity("10 Pa.s", Dimension::viscosity, "", comma) == 10.0);
    CHECK(refusal("0.75", Dimension::dimensionless, comma).find("decimal point") != std::string::npos);
    CHECK(refusal("1.000,5", Dimension::dimensionless, comma) != "accepted");
}

TEST_CASE("quantity: numbers of a thousand digits are read exactly") {
    const std::string zeros(1000, '0');
    CHECK(length("1" + zeros + "e-1000um") == 1e-6);
    CHECK(length("0." + zeros + "1e1001 mm") == 1e-3);
}
