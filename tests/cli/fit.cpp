#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "cli/command.hpp"
#include "support/rheometer_export.hpp"
#include "support/schema.hpp"
#include "support/text.hpp"

using namespace bioprint::test;
using bioprint::testing::contains;
using bioprint::testing::schema_violations;
using nlohmann::json;

namespace {

double cross(double rate) {
    return 10.0 / (1.0 + std::pow(0.05 * rate, 0.75));
}

/// Deterministic, of a percent, without a period the fit could follow.
double scatter(int i) {
    return 0.01 * std::sin(12.9898 * i * i + 1.0);
}

std::vector<ExportPoint> curve(double low, double high, int count) {
    std::vector<ExportPoint> points;
    for (int i = 0; i < count; ++i) {
        const double rate = low * std::pow(high / low, static_cast<double>(i) / (count - 1));
        points.push_back({rate, cross(rate) * std::exp(scatter(i))});
    }
    return points;
}

}  // namespace

TEST_CASE("fit command: every kind of export is fitted and its answer follows the schema") {
    for (const ExportKind kind : export_kinds) {
        CAPTURE(kind_name(kind));
        write_scratch("curve.txt", rheometer_export(kind, curve(0.01, 1000.0, 26)));
        const Outcome outcome = run("fit curve.txt --json");
        REQUIRE(outcome.status == 0);
        const json answer = json::parse(outcome.out);
        CHECK(schema_violations(answer, "fit").empty());
        CHECK(answer["fit"]["parameters"]["eta0"]["value"].get<double>() ==
              doctest::Approx(10.0).epsilon(0.03));
        CHECK(answer["fit"]["parameters"]["alpha"]["value"].get<double>() ==
              doctest::Approx(0.75).epsilon(0.03));
        CHECK(answer["data"]["outliers"] == 0);
    }
}

TEST_CASE("fit command: the line of options and the preset give the same prediction") {
    write_scratch("curve.txt", rheometer_export(ExportKind::rheocompass_german, curve(0.01, 1000.0, 26)));
    REQUIRE(run("fit curve.txt --preset ink.json --name 'my ink'").status == 0);
    const std::string options = run("fit curve.txt -q --get options").out;
    const std::string path = " -q --get nozzle.pressure_gradient";
    const Outcome by_options = run(options.substr(0, options.size() - 1) + path);
    const Outcome by_preset = run("--ink ./ink.json" + path);
    CHECK(by_options.status == 0);
    CHECK(by_options.out == by_preset.out);
    CHECK(run("--ink ./ink.json -q --get input.ink.name").out == "my ink\n");
    CHECK(contains(run("--ink ./ink.json -q --get input.ink.source").out,
                   "fitted to curve.txt, interval 2: 26 points"));
    const json preset = json::parse(read_scratch("ink.json"));
    CHECK(preset["parameters"]["eta0"]["sd"] > 0.0);
    CHECK(preset["temperature"]["value"] == 25.01);
    json shelf = {{"schema", "bioprint-inks/1"}, {"grades", json::object()}, {"inks", json::array({preset})}};
    CHECK(schema_violations(shelf, "inks").empty());
}

TEST_CASE("fit command: a law of any kind is given as options and they predict what the preset does") {
    const double k = 20.0;
    const auto viscosity = [&](const std::string& law, double rate) {
        if (law == "power-law") return k * std::pow(rate, -0.5);
        if (law == "herschel-bulkley") return 12.0 / rate + k * std::pow(rate, -0.5);
        return 0.02 + 50.0 * std::pow(1.0 + std::pow(0.5 * rate, 1.5), -0.4);
    };
    for (const auto& [law, extra, expected] :
         {std::tuple{std::string("power-law"), "", "--law power-law --consistency "},
          {std::string("herschel-bulkley"), "", "--law herschel-bulkley --yield-stress "},
          {std::string("carreau-yasuda"), " --eta-inf fit", "--law carreau-yasuda --eta0 "},
          {std::string("carreau-yasuda"), " --eta-inf 0.02", "--law carreau-yasuda --eta0 "}}) {
        CAPTURE(law);
        std::vector<ExportPoint> points = curve(0.01, 1000.0, 31);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i].viscosity = viscosity(law, points[i].rate) * std::exp(scatter(static_cast<int>(i)));
        write_scratch("law.csv", rheometer_export(ExportKind::plain_named, points));
        const std::string fit = "fit -q law.csv --law " + law + extra;
        std::string options = run(fit + " --preset law.json --get options").out;
        REQUIRE(options.starts_with(expected));
        options.pop_back();
        const std::string path = " -q --get input.ink.law --get nozzle.pressure_gradient";
        const Outcome by_options = run(options + path);
        CHECK(by_options.status == 0);
        CHECK(by_options.out.starts_with(law));
        CHECK(by_options.out == run("--ink ./law.json" + path).out);
        // The table's line is as a shell takes it, broken by a backslash or not.
        const std::string table = run(fit).out;
        const std::size_t at = table.find("  bioprint-predict ");
        REQUIRE(at != std::string::npos);
        const std::string call = table.substr(at + 19, table.find("\n  or as", at) - at - 19);
        CHECK(run(call + path).out == by_options.out);
    }
}

TEST_CASE("fit command: the table for a person is within 80 columns and says what was read") {
    write_scratch("curve.txt", rheometer_export(ExportKind::trios, curve(0.01, 1000.0, 26)));
    const Outcome outcome = run("fit curve.txt");
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "Shear rate [1/s]"));
    CHECK(contains(outcome.out, "Conditioning Sample - 1"));
    CHECK(contains(outcome.out, "--eta0 "));
    CHECK_FALSE(contains(outcome.out, "\033["));
    std::size_t width = 0;
    for (const char c : outcome.out) {
        width = c == '\n' ? 0 : width + ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0);
        CHECK(width <= 80);
    }
}

TEST_CASE("fit command: what the data leave open is said") {
    std::vector<ExportPoint> steep = curve(100.0, 10000.0, 20);
    for (std::size_t i = 0; i < steep.size(); ++i) {
        steep[i].viscosity =
            5e3 / (1.0 + std::pow(100.0 * steep[i].rate, 0.7)) * std::exp(scatter(static_cast<int>(i)));
    }
    write_scratch("steep.txt", rheometer_export(ExportKind::plain_named, steep));
    const json open = json::parse(run("fit steep.txt --json -q").out);
    CHECK(contains(open["warnings"].dump(), "no_plateau"));
    CHECK(open["fit"]["parameters"]["eta0"]["determined"] == false);
    CHECK(open["fit"]["parameters"]["eta0"]["low"].is_null());

    std::vector<ExportPoint> flat = curve(0.01, 100.0, 20);
    for (std::size_t i = 0; i < flat.size(); ++i)
        flat[i].viscosity = 2.0 * std::exp(scatter(static_cast<int>(i)));
    write_scratch("flat.txt", rheometer_export(ExportKind::plain_named, flat));
    CHECK(contains(run("fit flat.txt").out, "no thinning within the scatter"));
    // As a Cross ink a constant viscosity is alpha 0, which halves eta0.
    REQUIRE(run("fit flat.txt --law newtonian --preset flat.json").status == 0);
    CHECK(std::stod(run("--ink ./flat.json -q --get nozzle.viscosity_wall").out) ==
          doctest::Approx(2.0).epsilon(0.01));

    std::vector<ExportPoint> yielding = curve(0.01, 1000.0, 26);
    for (ExportPoint& p : yielding) p.viscosity = 60.0 / p.rate + 20.0 * std::pow(p.rate, -0.5);
    write_scratch("yield.txt", rheometer_export(ExportKind::plain_named, yielding));
    CHECK(contains(run("fit yield.txt").out, "herschel-bulkley law describes these points better"));
    CHECK(run("fit yield.txt -q --law best --get fit.law").out == "herschel-bulkley\n");
}

TEST_CASE("fit command: what leaves a parameter open is called by its name") {
    const auto notes = [](const std::string& call, double (*viscosity)(double), double error) {
        std::vector<ExportPoint> points = curve(0.01, 1000.0, 31);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i].viscosity =
                viscosity(points[i].rate) * std::exp(100.0 * error * scatter(static_cast<int>(i)));
        write_scratch("open.csv", rheometer_export(ExportKind::plain_named, points));
        const Outcome outcome = run("fit open.csv --json " + call);
        CHECK(outcome.status == 0);
        std::string text;
        const json answer = json::parse(outcome.out);
        for (const json& warning : answer["warnings"])
            text += warning["code"].get<std::string>() + ": " + warning["message"].get<std::string>() + "\n";
        return text;
    };
    // Thickening is no Newtonian ink.
    const auto thick = [](double rate) { return std::pow(rate, 0.3); };
    const std::string thickening = notes("", thick, 0.02);
    CHECK(contains(thickening, "thickening: the ink thickens"));
    CHECK(contains(thickening, "n = 1.3"));
    CHECK_FALSE(contains(thickening, "Newtonian between"));
    CHECK_FALSE(contains(notes("--law power-law", thick, 0.02), "thickening"));
    // More than any prediction takes.
    const auto steep = [](double rate) { return std::pow(rate, 1.4); };
    CHECK(contains(notes("--law power-law", steep, 0.02),
                   "not_predicted: no prediction takes this ink: flow-index: got 2.39"));
    const auto falling = [](double rate) { return 20.0 / (1.0 + std::pow(3.0 * rate, 1.3)); };
    CHECK(contains(notes("--law carreau-yasuda", falling, 0.001), "not_predicted"));
    CHECK_FALSE(contains(notes("--law cross", falling, 0.001), "not_predicted"));
    // Five decades that thin fully: it is the law, or the scatter.
    const auto floor = [](double rate) { return 0.3 + 50.0 / (1.0 + std::pow(3.0 * rate, 0.9)); };
    const std::string wrong_law = notes("", floor, 0.02);
    CHECK(contains(wrong_law,
                   "not_determined: the data do not determine K: this law does not describe the points"));
    CHECK_FALSE(contains(wrong_law, "too little of the thinning"));
    const auto noisy = [](double rate) { return 20.0 / (1.0 + std::pow(0.3 * rate, 0.7)); };
    const std::string scattered = notes("", noisy, 0.7);
    CHECK(contains(scattered, "too much to tell"));
    CHECK_FALSE(contains(scattered, "too little of the thinning"));
    // Thinning that has only begun.
    const auto begun = [](double rate) { return 20.0 / (1.0 + std::pow(0.0003 * rate, 0.9)); };
    CHECK(contains(notes("", begun, 0.02), "too little of the thinning branch is measured"));
    // A floor above the points.
    CHECK(contains(notes("--eta-inf 1", floor, 0.02), "eta_inf_above_points: eta_inf is held at 1 Pa s"));
    const Outcome above = run("fit open.csv --eta-inf 60");
    CHECK(above.status == 2);
    CHECK(contains(above.err, "--eta-inf: got 60 Pa s, which no point reaches"));
}

TEST_CASE("fit command: outliers and bad rows are counted with their lines") {
    std::string text = "Shear rate [1/s],Viscosity [Pa.s]\n";
    int line = 1;
    for (const ExportPoint& p : curve(0.01, 1000.0, 26)) {
        ++line;
        const double factor = line == 9 ? 2.0 : 1.0;
        text += line == 5 ? std::to_string(p.rate) + ",-0.5\n"
                          : std::to_string(p.rate) + "," + std::to_string(factor * p.viscosity) + "\n";
    }
    write_scratch("bad.csv", text);
    const Outcome outcome = run("fit bad.csv");
    CHECK(contains(outcome.out, "1 outlier (line 9)"));
    CHECK(contains(outcome.out, "1 row, viscosity not above 0 (line 5)"));
    const Outcome points = run("fit bad.csv --format csv -q");
    CHECK(contains(points.out,
                   "shear_rate [1/s],viscosity [Pa.s],fitted [Pa.s],residual,used,line,interval\r\n"));
    CHECK(contains(points.out, ",0,9,1\r\n"));
}

TEST_CASE("fit command: wrong calls and files end with one clear line") {
    write_scratch("curve.txt", rheometer_export(ExportKind::plain, curve(0.01, 1000.0, 26)));
    write_scratch("empty.txt", "");
    write_scratch("one.csv", "rate [1/s],viscosity [Pa.s]\n1,2\n");
    write_scratch("two.csv", "rate [1/s],viscosity [Pa.s]\n1,2\n10,1\n");
    for (const auto& [call, status, message] :
         {std::tuple{"fit", 2, "takes a FILE"},
          {"fit no-such-file.csv", 4, "no-such-file.csv"},
          {"fit empty.txt", 2, "is empty"},
          {"fit one.csv", 2, "a single point"},
          {"fit two.csv", 2, "different ones"},
          {"fit curve.txt --law casson", 2, "--law: got 'casson'"},
          {"fit curve.txt --interval 0", 2, "--interval: got '0'"},
          {"fit curve.txt --interval 2", 2, "has 1 interval alone"},
          {"fit curve.txt --eta-inf 5s", 2, "--eta-inf: got '5s', a time"},
          {"fit curve.txt --eta-inf -1", 2, "--eta-inf"},
          {"fit curve.txt --format yaml", 2, "--format"},
          {"fit curve.txt --json --format csv", 2, "--json"},
          {"fit curve.txt --get fit.nothing", 2, "fit.nothing"},
          {"fit curve.txt other.txt", 2, "an argument too many"},
          {"fit curve.txt --bogus", 2, "no such option"},
          {"fit curve.txt --law cross --law cross", 2, "--law: given twice; give it once"},
          {"fit curve.txt --interval 1 --interval 1", 2, "--interval: given twice; give it once"},
          {"fit curve.txt -o no/such/dir/x", 4, "no/such/dir"},
          {"-q fit curve.txt", 2, "comes first"}}) {
        CAPTURE(call);
        const Outcome outcome = run(call);
        CHECK(outcome.status == status);
        CHECK(contains(outcome.err, message));
        CHECK(outcome.out.empty());
    }
    CHECK(contains(run("fit --help").out, "--eta-inf"));
    const std::string help = run("--help").out;
    CHECK(contains(help.substr(help.find("Subcommands:")), "\n  fit "));
    // Both problems at once.
    const Outcome both = run("fit curve.txt --law x --eta-inf y");
    CHECK(contains(both.err, "--law"));
    CHECK(contains(both.err, "--eta-inf"));
}

TEST_CASE("fit command: of points too few to choose a law best takes the Cross law and says so") {
    write_scratch("few.csv", rheometer_export(ExportKind::plain, curve(0.01, 1000.0, 4)));
    const Outcome outcome = run("fit few.csv --law best");
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "cross *"));
    CHECK(contains(outcome.out, "4 points are too few to choose a law: this is the Cross law"));
    write_scratch("three.csv", rheometer_export(ExportKind::plain, curve(0.01, 1000.0, 3)));
    const Outcome three = run("fit three.csv --law best");
    CHECK(three.status == 2);
    CHECK(contains(three.err, "3 points are too few to choose a law"));
}

TEST_CASE("fit command: an ink no prediction takes is not offered to one") {
    std::string text = "rate [1/s],viscosity [Pa.s]\n";
    for (int i = 0; i < 12; ++i) {
        const double rate = std::pow(10.0, 0.25 * i);
        text += std::to_string(rate) + "," + std::to_string(std::pow(rate, 1.5)) + "\n";
    }
    write_scratch("thick.csv", text);
    const Outcome table = run("fit thick.csv --law power-law");
    CHECK(table.status == 0);
    CHECK(contains(table.out, "To predict with it\n  no prediction takes this ink: flow-index: got 2.5"));
    CHECK_FALSE(contains(table.out, "--preset"));
    const Outcome preset = run("fit thick.csv --law power-law --preset thick.json");
    CHECK(preset.status == 2);
    CHECK(preset.out.empty());
    CHECK(contains(preset.err, "--preset: no prediction takes this ink"));
    CHECK(contains(preset.err, "fit another law with --law"));
    CHECK(run("--ink ./thick.json").status == 4);  // there is no such file
}

TEST_CASE("fit command: standard input is a file too") {
    const Outcome outcome =
        run("fit - --json", rheometer_export(ExportKind::malvern, curve(0.01, 1000.0, 26)));
    CHECK(outcome.status == 0);
    CHECK(json::parse(outcome.out)["data"]["file"] == "standard input");
}
