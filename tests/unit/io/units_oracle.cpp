#include <doctest/doctest.h>
#include <udunits2.h>

#include <array>
#include <cmath>
#include <string>

#include "bioprint/io/quantity.hpp"
#include "io/units.hpp"

using namespace bioprint;

namespace {

/// UDUNITS works in doubles with a handful of multiplications; ours is correctly rounded.
constexpr double oracle_tolerance = 1e-15;

constexpr std::array dimensions = {
    Dimension::dimensionless, Dimension::length,   Dimension::volume_flow,
    Dimension::velocity,      Dimension::pressure, Dimension::pressure_gradient,
    Dimension::viscosity,     Dimension::time,     Dimension::rate};

/// What UDUNITS writes otherwise, or does not know.
std::string udunits_spelling(std::string_view unit) {
    if (unit == "mil" || unit == "thou") return "0.001 inch";
    if (unit == "Pas") return "Pa.s";
    if (unit == "mPas") return "mPa.s";
    if (unit == "cP") return "0.01 poise";
    if (unit == "P") return "poise";
    if (unit.starts_with("/")) return std::string("1").append(unit);
    return std::string(unit);
}

class Udunits {
  public:
    Udunits() {
        ut_set_error_message_handler(ut_ignore);
        system_ = ut_read_xml(nullptr);
        REQUIRE(system_ != nullptr);
    }
    ~Udunits() { ut_free_system(system_); }
    Udunits(const Udunits&) = delete;
    Udunits& operator=(const Udunits&) = delete;

    /// One `unit` in `si`; NaN when UDUNITS does not know it or cannot convert it.
    [[nodiscard]] double convert(const std::string& unit, const std::string& si) const {
        ut_unit* from = ut_parse(system_, unit.c_str(), UT_UTF8);
        ut_unit* to = ut_parse(system_, si.c_str(), UT_UTF8);
        double value = std::nan("");
        if (from != nullptr && to != nullptr && ut_are_convertible(from, to) != 0) {
            cv_converter* converter = ut_get_converter(from, to);
            value = cv_convert_double(converter, 1.0);
            cv_free(converter);
        }
        ut_free(from);
        ut_free(to);
        return value;
    }

  private:
    ut_system* system_;
};

void check_against(const Udunits& oracle, const std::string& ours, const std::string& theirs,
                   const std::string& si, Dimension dimension) {
    const double expected = oracle.convert(theirs, si);
    const double value = parse_quantity("1 " + ours, dimension, "");
    CAPTURE(ours);
    REQUIRE(std::isfinite(expected));
    CHECK(std::abs(value / expected - 1.0) <= oracle_tolerance);
}

}  // namespace

TEST_CASE("units: every everyday spelling agrees with UDUNITS") {
    const Udunits oracle;
    for (const auto dimension : dimensions) {
        const std::string si = dimension == Dimension::dimensionless ? "1" : std::string(si_unit(dimension));
        for (const auto unit : usual_units(dimension)) {
            if (unit == "1") continue;
            check_against(oracle, std::string(unit), udunits_spelling(unit), si, dimension);
        }
    }
}

TEST_CASE("units: every name with every prefix agrees with UDUNITS") {
    const Udunits oracle;
    const auto check = [&](std::initializer_list<const char*> names, const char* si, Dimension dimension) {
        for (const auto* name : names) check_against(oracle, name, udunits_spelling(name), si, dimension);
    };
    check({"m", "cm", "mm", "um", "nm", "in", "inch", "mil", "thou", "micron"}, "m", Dimension::length);
    check({"s", "ms", "us", "ns", "sec", "min", "h", "hr"}, "s", Dimension::time);
    check({"Pa", "uPa", "mPa", "hPa", "kPa", "MPa", "GPa", "bar", "mbar", "ubar", "psi", "atm", "N/m2",
           "mN/mm2", "kg/m/s2", "uN/mm^2", "nN/um2", "g/m/s2"},
          "Pa", Dimension::pressure);
    check({"Hz", "mHz", "kHz", "MHz", "1/h", "1/ms", "us-1"}, "s-1", Dimension::rate);
    check({"Pas", "mPas", "P", "cP", "psi.s", "bar.s", "N.s/m2", "kg/m/s"}, "Pa.s", Dimension::viscosity);
    for (const std::string volume : {"m3", "cm3", "mm3", "um3", "L",  "dL", "cL", "mL", "uL", "nL",
                                     "pL", "l",   "dl",  "cl",  "ml", "ul", "nl", "pl", "cc", "in3"}) {
        for (const std::string time : {"s", "ms", "min", "h", "hr", "sec"}) {
            const std::string unit = volume + "/" + time;
            check_against(oracle, unit, unit, "m3/s", Dimension::volume_flow);
        }
    }
    for (const std::string pressure : {"Pa", "hPa", "kPa", "MPa", "GPa", "bar", "mbar", "psi", "atm"}) {
        for (const std::string length : {"m", "cm", "mm", "um", "in", "inch"}) {
            const std::string unit = pressure + "/" + length;
            check_against(oracle, unit, unit, "Pa/m", Dimension::pressure_gradient);
        }
    }
    for (const std::string length : {"m", "cm", "mm", "um", "nm", "in"}) {
        for (const std::string time : {"s", "ms", "min", "h"}) {
            check_against(oracle, length + "/" + time, length + "/" + time, "m/s", Dimension::velocity);
        }
    }
}

TEST_CASE("units: the SI unit of every dimension is read back as one") {
    for (const auto dimension : dimensions) {
        CHECK(parse_quantity("1 " + std::string(si_unit(dimension)), dimension, "") == 1.0);
    }
}
