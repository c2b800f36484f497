#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/command.hpp"
#include "support/schema.hpp"
#include "support/text.hpp"

using bioprint::test::Outcome;
using bioprint::test::run;
using bioprint::testing::contains;
using bioprint::testing::schema_violations;
using nlohmann::json;

TEST_CASE("design: the answer is the prediction at the value with the design beside it") {
    const Outcome outcome =
        run("design --solve flowrate --limit 'nozzle.stress_max<500Pa' --radius 100um --json");
    CHECK(outcome.status == 0);
    const json answer = json::parse(outcome.out);
    CHECK(schema_violations(answer, "answer") == "");
    CHECK(answer["design"]["outcome"] == "found");
    CHECK(answer["design"]["side"] == "largest");
    CHECK(answer["design"]["limits"][0]["binds"] == true);
    const double value = answer["design"]["value"].get<double>();
    CHECK(answer["nozzle"]["flow_rate"] == value);
    // Asked as a question of its own, the value keeps the limit; a little more does not.
    const std::string text =
        run("-q design --solve flowrate --limit 'nozzle.stress_max<500Pa' --radius 100um "
            "--get design.value")
            .out;
    CHECK(std::stod(text) == value);
    const auto check = [&](double flow) {
        return run("--radius 100um --flowrate " + json(flow).dump() + " --check 'nozzle.stress_max<500Pa'")
            .status;
    };
    CHECK(check(value) == 0);
    CHECK(check(value * (1.0 + 1e-8)) == 7);
}

TEST_CASE("design: the subcommand takes options of the prediction on either side") {
    const std::string value = "--get design.value -q";
    const std::string behind =
        run("design --solve velocity --limit 'nozzle.stress_max<500Pa' --radius 100um " + value).out;
    CHECK(behind ==
          run("--radius 100um " + value + " design --solve velocity --limit 'nozzle.stress_max<500Pa'").out);
    CHECK(std::stod(behind) > 0.0);
}

TEST_CASE("design: no value ends with status 7 and the closest is shown") {
    const Outcome outcome =
        run("design --solve velocity --limit 'nozzle.velocity_average>4mm/s' --limit "
            "'nozzle.velocity_average<1mm/s'");
    CHECK(outcome.status == 7);
    CHECK(contains(outcome.out, "no velocity from"));
    CHECK(contains(outcome.out, "BROKEN"));
    CHECK(contains(outcome.err, "the closest is 2 mm/s"));
    CHECK(contains(outcome.err, "nozzle.velocity_average>4mm/s does not hold"));
}

TEST_CASE("design: a limit on the population brings it into the answer") {
    const Outcome outcome = run("-q design --solve flowrate --limit 'population.p95<1kPa' --json");
    CHECK(outcome.status == 0);
    const json answer = json::parse(outcome.out);
    CHECK(schema_violations(answer, "answer") == "");
    const double p95 = answer["population"]["peak_stress"]["percentile_95"].get<double>();
    CHECK(p95 < 1000.0);
    CHECK(p95 > 999.0);
}

TEST_CASE("design: what is wrong with the question is told at once") {
    const Outcome outcome = run("design --solve colour --limit 'nozzle.stress_max<2s'");
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "--solve: got 'colour'; it takes radius, flowrate"));
    CHECK(contains(outcome.err, "a time; it takes a pressure"));
    CHECK(run("design --solve flowrate").status == 2);
    CHECK(contains(run("design --limit 'nozzle.stress_max<2kPa'").err,
                   "radius, flowrate, velocity, pressure, pressure-gradient or alpha"));
    const Outcome twice = run("design --solve flowrate --solve radius --limit 'nozzle.stress_max<2kPa'");
    CHECK(twice.status == 2);
    CHECK(contains(twice.err, "--solve: given twice; give it once"));
    CHECK_FALSE(contains(twice.err, "missing"));
    CHECK(contains(run("design --solve flowrate --limit 'nozzle.stress_max<2kPa' --range 1uL/h:2uL/h "
                       "--range 1uL/h:2uL/h")
                       .err,
                   "--range: given twice; give it once"));
    CHECK_FALSE(contains(run("design --limit 'nozzle.stress_max<2kPa' --solve").err, "is missing"));
    const Outcome spread = run(
        "design --solve velocity --uncertainty --limit 'uncertainty.nozzle.stress_max.percentile_95<600Pa'");
    CHECK(spread.status == 2);
    CHECK(contains(spread.err, "a design sets no limit on a spread"));
    CHECK(run("design --solve velocity --limit 'simulation.simulated.von_mises_peak<1kPa'").status == 2);
    CHECK(run("design --solve radius --limit 'nozzle.stress_max<2kPa' --needle 25G").status == 2);
    CHECK(run("design --solve flowrate --limit 'nozzle.stress_max<2kPa' --velocity 5mm/s").status == 2);
    CHECK(run("design --solve flowrate --limit 'nozzle.stress_max<2kPa' --alpha 0,0.5").status == 2);
    CHECK(run("design --solve flowrate --limit 'nozzle.stress_max<2kPa' --format csv").status == 2);
    CHECK(run("design --solve pressure --limit 'nozzle.stress_max<2kPa'").status == 2);
    CHECK(run("design --solve flowrate --limit 'nozzle.pressure_drop<3bar'").status == 2);
    CHECK(run("design --solve radius --limit 'nozzle.stress_max<2kPa' --range 5um:9um").status == 2);
    CHECK(run("--solve flowrate").status == 2);
    CHECK(run("design --bogus").status == 2);
    CHECK(contains(run("design --help").out, "--limit"));
}
