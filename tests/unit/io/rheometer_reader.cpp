#include "io/rheometer_reader.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "bioprint/errors.hpp"
#include "io/decoded_text.hpp"
#include "io/flow_columns.hpp"
#include "io/number_columns.hpp"
#include "support/rheometer_export.hpp"
#include "support/text.hpp"

using namespace bioprint;
using namespace bioprint::test;
using bioprint::testing::contains;

namespace {

std::vector<ExportPoint> points() {
    std::vector<ExportPoint> all;
    for (int i = 0; i < 21; ++i) {
        const double rate = std::pow(10.0, -2.0 + 0.25 * i);
        all.push_back({rate, 10.0 / (1.0 + std::pow(0.05 * rate, 0.75))});
    }
    return all;
}

RheometerData read(const std::string& bytes, const RheometerReadOptions& options = {}) {
    const DecodedText decoded = decode_text(bytes, "data.txt");
    RheometerData data = read_rheometer_text(decoded.text, "data.txt", options);
    data.encoding = decoded.encoding;
    return data;
}

/// What reading `bytes` is refused with.
std::string refusal(const std::string& bytes, const RheometerReadOptions& options = {}) {
    try {
        read(bytes, options);
    } catch (const UsageError& e) {
        return e.what();
    }
    return "not refused";
}

}  // namespace

TEST_CASE("rheometer: every kind of export gives back its points") {
    for (const ExportKind kind : export_kinds) {
        CAPTURE(kind_name(kind));
        const RheometerData data = read(rheometer_export(kind, points()));
        REQUIRE(data.points.size() == points().size());
        for (std::size_t i = 0; i < data.points.size(); ++i) {
            // Six digits were written.
            CHECK(data.points[i].rate == doctest::Approx(points()[i].rate).epsilon(1e-5));
            CHECK(data.points[i].viscosity == doctest::Approx(points()[i].viscosity).epsilon(1e-5));
        }
        CHECK(data.dropped.empty());
    }
}

TEST_CASE("rheometer: what was understood of a file is told") {
    const RheometerData german = read(rheometer_export(ExportKind::rheocompass_german, points()));
    CHECK(german.encoding == "UTF-16LE");
    CHECK(german.separator == '\t');
    CHECK(german.decimal_comma);
    REQUIRE(german.intervals.size() == 2);
    CHECK(contains(german.intervals[0].skipped, "constant"));
    CHECK(german.intervals[1].skipped.empty());
    CHECK(german.intervals[1].rate == "Scherrate [1/s]");
    CHECK(german.intervals[1].viscosity == "Viskosit\u00e4t [mPa\u00b7s]");
    CHECK(german.points.front().temperature == doctest::Approx(25.01));
    const RheometerData trios = read(rheometer_export(ExportKind::trios, points()));
    CHECK(trios.intervals.back().name == "Flow sweep - 2");
    CHECK(contains(trios.intervals.front().skipped, "shear rate"));
    CHECK(read(rheometer_export(ExportKind::german_excel, points())).encoding == "Windows-1252");
    const RheometerData plain = read(rheometer_export(ExportKind::plain, points()));
    REQUIRE(plain.remarks.size() == 1);
    CHECK(contains(plain.remarks[0], "taken as shear rate"));
    CHECK(contains(read(rheometer_export(ExportKind::plain_named, points())).remarks.front(), "no unit"));
}

TEST_CASE("rheometer: columns are found by their unit first and by their name second") {
    const auto find = [](std::initializer_list<const char*> fields) {
        std::vector<ColumnHead> heads;
        for (const char* const field : fields) heads.push_back(split_head(field));
        return find_flow_columns(heads);
    };
    const FlowColumns swapped =
        find({"Time [s]", "Viscosity [mPa.s]", "Rotational speed [1/min]", "Shear rate [1/s]"});
    CHECK(swapped.rate->index == 3);
    CHECK(swapped.viscosity->index == 1);
    CHECK(swapped.viscosity->factor == 1e-3);
    CHECK(find({"Tasso (1/s)", "Qualcosa (Pa s)"}).complete());
    CHECK(find({"Complex viscosity [Pa.s]", "Shear rate [1/s]"}).complete() == false);
    CHECK(find({"\u526a\u5207\u901f\u7387 [1/s]", "\u526a\u5207\u5e94\u529b [Pa]"}).stress->index == 1);
    CHECK(find({"Storage modulus [Pa]", "Shear stress [Pa]", "Shear rate [1/s]"}).stress->index == 1);
    CHECK(find({"Taux de cisaillement", "Contrainte de cisaillement", "Viscosit\u00e9"}).rate->index == 0);
    CHECK(find({"Taux de cisaillement", "Contrainte de cisaillement", "Viscosit\u00e9"}).stress->index == 1);
    CHECK(find({"Angular frequency [rad/s]", "Complex viscosity [Pa.s]"}).oscillation);
    CHECK(find({"D/(1/s)", "\u03b7/Pa\u00b7s"}).complete());
    CHECK(find({"Shear rate (s\u207b\u00b9)", "Viscosity, cP"}).viscosity->factor == 1e-3);
}

TEST_CASE("rheometer: names in a line of their own words name the columns whatever separates the numbers") {
    const RheometerData data = read("# my data\nvisc rate\n5\t1\n2\t10\n1\t100\n");
    CHECK(data.intervals.front().rate == "rate");
    CHECK(data.intervals.front().viscosity == "visc");
    CHECK(data.points.at(1).rate == 10.0);
    for (const std::string& remark : data.remarks) CHECK_FALSE(contains(remark, "without names"));
}

TEST_CASE("rheometer: stress over rate is the viscosity where none was exported") {
    const RheometerData data = read("Shear rate [1/s],Shear stress [kPa]\n0.1,0.002\n1,0.01\n10,0.05\n");
    REQUIRE(data.points.size() == 3);
    CHECK(data.points[0].viscosity == doctest::Approx(20.0));
    CHECK(data.intervals[0].viscosity == "Shear stress [kPa] over Shear rate [1/s]");
}

TEST_CASE("rheometer: numbers are read under the file's own decimal mark") {
    CHECK(parse_field("0,5", true) == 0.5);
    CHECK(parse_field("1.234,5", true) == 1234.5);
    CHECK(parse_field("1,234.5", false) == 1234.5);
    CHECK(parse_field("1,5E+02", true) == 150.0);
    CHECK(parse_field("\u2212"
                      "3",
                      false) == -3.0);
    CHECK_FALSE(parse_field("0,123", false).has_value());
    CHECK_FALSE(parse_field("1,23,4", false).has_value());
    CHECK_FALSE(parse_field("nan", false).has_value());
    CHECK_FALSE(parse_field("1e999", false).has_value());
    CHECK_FALSE(parse_field("5 Pa", false).has_value());
    for (const auto& [text, separator, comma] : {std::tuple{"0,1\t2,5\n1,0\t2,1\n", '\t', true},
                                                 {"0.1;2.5\n1.0;2.1\n", ';', false},
                                                 {"0,1;2,5\n1,0;2,1\n", ';', true},
                                                 {"0.1,2.5\n1.0,2.1\n", ',', false},
                                                 {"0,1 2,5\n1,0 2,1\n", ' ', true},
                                                 {"1\t200\n10\t100\n", '\t', false}}) {
        CAPTURE(text);
        const RheometerData data = read(std::string(text) + std::string(text[1] == '\t' ? "100\t50\n" : ""));
        CHECK(data.separator == separator);
        CHECK(data.decimal_comma == comma);
    }
}

TEST_CASE("rheometer: rows that are no points are dropped with their reason and line") {
    const RheometerData data = read(
        "Shear rate [1/s];Viscosity "
        "[Pa.s]\n0.01;10\n0.1;-3\n0;9\n1;n/a\n10;\n-;7\n100;3\n1000;NaN\n1e99;1\n5;8\n");
    CHECK(data.points.size() == 3);
    std::size_t count = 0;
    for (const DroppedRows& rows : data.dropped) count += rows.count;
    CHECK(count == 7);
    REQUIRE(data.dropped.size() >= 3);
    CHECK(data.dropped[0].reason == "viscosity not above 0");
    CHECK(data.dropped[0].first_line == 3);
    CHECK(data.dropped[2].reason == "no number for the viscosity");
    CHECK(data.dropped[2].count == 3);
}

TEST_CASE("rheometer: words between the rows are a row left out and the curve goes on") {
    const std::string above = "Shear rate [1/s],Viscosity [Pa.s]\n0.1,10\n1,8\n";
    for (const char* const words :
         {"overload,overload", "OVER,OVER", "<LOD,<LOD", "manual stop,", "comment: bubble,",
          "sensor error,overload", "\nError,Error\n", "---,---", "n/a,#DIV/0!"}) {
        CAPTURE(words);
        const RheometerData data = read(above + words + "\n10,5\n100,2\n");
        CHECK(data.intervals.size() == 1);
        CHECK(data.points.size() == 4);
        CHECK(data.remarks.empty());
        REQUIRE(data.dropped.size() == 1);
        CHECK(data.dropped[0].count == 1);
    }
    // What names columns begins a table of its own, and one without a curve is said to be left out.
    for (const char* const words : {"Time,Torque", "Time [s],Torque [mN.m]", "\nstart,end"}) {
        CAPTURE(words);
        const RheometerData data = read(above + words + "\n10,5\n100,2\n");
        CHECK(data.intervals.size() == 2);
        CHECK(data.points.size() == 2);
        REQUIRE_FALSE(data.remarks.empty());
        CHECK(contains(data.remarks.back(), "is left out: no column of shear rate among"));
        CHECK(contains(data.remarks.back(), "delete the words before them"));
    }
    CHECK(read(above + "rate,viscosity\n10,5\n100,2\n").points.size() == 4);
}

TEST_CASE("rheometer: a column of logarithms is not the quantity") {
    const RheometerData data = read(
        "log shear rate [1/s],shear rate [1/s],log10(viscosity) [Pa.s],viscosity [Pa.s]\n"
        "0,1,1,10\n1,10,0.7,5\n2,100,0.3,2\n");
    CHECK(data.points.size() == 3);
    CHECK(data.points.back().rate == 100.0);
    CHECK(data.points.back().viscosity == 2.0);
    for (const char* const log : {"log", "lg", "ln", "Log10", "log_10"}) {
        CAPTURE(log);
        const std::string word(log);
        const std::string message =
            refusal(word + " shear rate [1/s]," + word + " viscosity [Pa.s]\n0.1,1\n1,0.7\n2,0.3\n");
        CHECK(contains(message, "'" + word + " viscosity [Pa.s]': logarithms are not read"));
        CHECK(contains(message, "export the quantity itself"));
    }
    CHECK(read("Logger shear rate [1/s],viscosity [Pa.s]\n1,10\n10,5\n").points.size() == 2);
}

TEST_CASE("rheometer: an interval is chosen by its number and a wrong one lists those there are") {
    const std::string file =
        "Shear rate [1/s],Viscosity [Pa.s]\n0.1,10\n1,8\n10,5\n"
        "Shear rate [1/s],Viscosity [Pa.s]\n10,6\n1,9\n0.1,11\n";
    CHECK(read(file).points.size() == 6);
    CHECK(read(file, {.intervals = {2}}).points.front().viscosity == 6.0);
    CHECK(contains(refusal(file, {.intervals = {3}}), "has 2 intervals: 1 from line 2"));
}

TEST_CASE("rheometer: a curve turned backwards counts as forwards") {
    const RheometerData data =
        read("rate [1/s],stress [Pa],viscosity [Pa.s]\n-1,-5,5\n-10,-30,3\n-100,-100,1\n");
    CHECK(data.points.size() == 3);
    CHECK(data.points[0].rate == 1.0);
    CHECK(contains(data.remarks.back(), "3 rows turn backwards"));
    CHECK(
        contains(read("rate [1/s],viscosity [Pa.s]\n1,5\n-10,3\n").remarks.back(), "1 row turns backwards"));
}

TEST_CASE("rheometer: a viscosity that is not stress over rate is remarked") {
    const RheometerData data = read("rate [1/s],stress [Pa],viscosity [mPa.s]\n1,5,5\n10,30,3\n100,100,1\n");
    REQUIRE_FALSE(data.remarks.empty());
    CHECK(contains(data.remarks.back(), "check the units"));
}

TEST_CASE("rheometer: what is no flow curve is refused with line or columns and the remedy") {
    CHECK(contains(refusal(""), "is empty"));
    CHECK(contains(refusal("\n \n\t\n"), "is empty"));
    CHECK(contains(refusal("no numbers here\nnor here\n"), "no line holds two numbers"));
    CHECK(contains(refusal(std::string("\x00\x01\x02\x03garbage\x00\x05", 14)), "no text"));
    CHECK(contains(refusal(std::string("PK\x03\x04xxxxxxxx")), "workbook"));
    CHECK(contains(refusal("%PDF-1.7\n"), "PDF"));
    CHECK(contains(refusal("Time [s],Torque [mN.m]\n1,2\n2,3\n"), "'Time [s]', 'Torque [mN.m]'"));
    CHECK(contains(refusal("1,2,3\n2,3,4\n"), "3 columns without names"));
    CHECK(contains(refusal("rate [1/s],viscosity [Pa.s]\n1,2\n"), "a single point"));
    CHECK(contains(refusal("rate [1/s],viscosity [Pa.s]\n1,2\n1,2\n1,2\n"), "the shear rate is constant"));
    CHECK(contains(refusal("rate [1/s],viscosity [Pa.s]\n1,-2\n10,-2\n100,nan\n"),
                   "2 rows with viscosity not above 0 (line 2)"));
    CHECK(contains(refusal("Angular frequency [rad/s],Complex viscosity [Pa.s]\n1,2\n10,1\n"),
                   "an oscillatory test, no flow curve; export a rotational test"));
    const std::string unit = refusal("Shear rate [1/s],Shear stress [dyn/cm2]\n1,20\n10,90\n");
    CHECK(contains(unit, "the unit 'dyn/cm2' is not known here; convert the column"));
    CHECK_FALSE(contains(unit, "name the columns"));
    CHECK(contains(refusal("1 5\n10 2\n100 1\n", {.intervals = {3}}),
                   "got 3, but data.txt has 1 interval alone; leave it out"));
}

TEST_CASE("rheometer: encodings are told apart") {
    CHECK(decode_text("\xEF\xBB\xBF"
                      "a",
                      "x")
              .text == "a");
    CHECK(decode_text("Viskosit\xE4t", "x").text == "Viskosit\u00e4t");
    CHECK(decode_text(as_utf16("Pa\u00b7s \u526a"), "x").text == "Pa\u00b7s \u526a");
    CHECK(decode_text(as_utf16("0,1\t2,5\r\n").substr(2), "x").encoding == "UTF-16LE");
    CHECK(decode_text(std::string("\xFE\xFF\0a\0b", 6), "x").text == "ab");
    CHECK(decode_text("plain", "x").encoding == "UTF-8");
}
