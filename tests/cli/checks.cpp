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

TEST_CASE("check: status 7 and a line with value and margin when a condition does not hold") {
    CHECK(run("--check 'nozzle.stress_max<2kPa'").status == 0);
    const Outcome outcome =
        run("-q --check 'nozzle.stress_max<2kPa' --check 'nozzle.stress_max<400Pa' --json");
    CHECK(outcome.status == 7);
    CHECK(contains(outcome.err, "--check: nozzle.stress_max<400Pa does not hold: 435.1 Pa, 35.1"));
    CHECK(contains(outcome.err, "above"));
    CHECK_FALSE(contains(outcome.err, "2kPa"));
    const json answer = json::parse(outcome.out);
    CHECK(schema_violations(answer, "answer") == "");
    REQUIRE(answer["checks"].size() == 2);
    CHECK(answer["checks"][0]["holds"] == true);
    CHECK(answer["checks"][1]["holds"] == false);
    CHECK(answer["checks"][1]["value"] == answer["nozzle"]["stress_max"]);
    CHECK(answer["checks"][1]["margin"].get<double>() < 0.0);
}

TEST_CASE("check: the table says what holds and get works beside a check") {
    const Outcome table = run("--check 'cells.exit.stress.von_mises<300Pa'");
    CHECK(table.status == 7);
    CHECK(contains(table.out, "DOES NOT HOLD"));
    const Outcome one = run("-q --get nozzle.stress_max --get population.p95 --check 'population.p95<9kPa'");
    CHECK(one.status == 0);
    CHECK(std::stod(one.out.substr(one.out.find('\n'))) > 100.0);
}

TEST_CASE("check: a value that does not exist does not hold") {
    const Outcome outcome = run("--check 'nozzle.pressure_drop<3bar'");
    CHECK(outcome.status == 7);
    CHECK(contains(outcome.err, "there is no value; give the nozzle's --length"));
    CHECK(contains(run("-q --check 'cells.1.angle<1'").err,
                   "this value does not exist for a cell at that place"));
    CHECK(run("--check 'nozzle.pressure_drop<3bar' --length 1cm").status == 0);
}

TEST_CASE("check: what is wrong with an expression is a mistake of the call") {
    CHECK(run("--check 'nozzle.stress_max<2s'").status == 2);
    CHECK(contains(run("--check 'nozzle.stress_max<2s'").err, "a time; it takes a pressure"));
    CHECK(run("--check 'nozzle.stres_max<2'").status == 2);
    CHECK(run("--check nonsense").status == 2);
    // With a unit behind it a mistaken path is still what has to be mended.
    for (const char* limit : {"1", "1kPa"}) {
        const Outcome mistaken = run("--check 'nozzle.stres_max<" + std::string(limit) + "'");
        CHECK(mistaken.status == 2);
        CHECK(contains(mistaken.err, "--check: no value at 'nozzle.stres_max'"));
        CHECK_FALSE(contains(mistaken.err, "plain number"));
    }
    CHECK(contains(run("--check 'cells.exit.stress<1kPa'").err, "'cells.exit.stress' is not one value"));
    CHECK(contains(run("--check 'input.ink.name<1kPa'").err, "'input.ink.name' is a text"));
    CHECK(contains(run("--check '2kPa>=nozzle.stress_max'").err,
                   "the path stands on the left: 'nozzle.stress_max<=2kPa'"));
    CHECK(run("--check 'simulation.simulated.von_mises_peak<2kPa'").status == 2);
    CHECK(run("--alpha 0,0.5 --check 'nozzle.stres_max<2' --json").status == 2);
}

TEST_CASE("check: a sweep counts the rows in which a condition does not hold and names the worst") {
    for (const char* format : {"table", "json", "jsonl", "csv"}) {
        CAPTURE(format);
        const Outcome outcome =
            run("-q --alpha 0:0.75:0.25 --check 'nozzle.stress_max<1kPa' --format " + std::string(format));
        CHECK(outcome.status == 7);
        CHECK(contains(outcome.err, "does not hold in 2 of 4 rows; the worst is row 1: 2 kPa"));
    }
    CHECK(contains(run("-q --alpha 0,0.75 --check 'nozzle.stress_max<1kPa'").out, "FAIL"));
    const Outcome csv = run("-q --alpha 0,0.75 --check 'nozzle.stress_max<1kPa' --format csv");
    CHECK(contains(csv.out, "checks.0.holds,checks.0.relative_margin"));
    CHECK(contains(csv.out, ",false,-"));
}

TEST_CASE("check: a batch answers every row and a refused row comes before a check") {
    const Outcome rows = run("-q --batch - --check 'nozzle.stress_max<1kPa'", "alpha\n0\n0.75\n");
    CHECK(rows.status == 7);
    CHECK(contains(rows.err, "does not hold in 1 of 2 rows"));
    const Outcome lines =
        run("-q --batch - --check 'nozzle.stress_max<1kPa'", "{\"alpha\": 0.75}\n{\"alpha\": 0.7}\n");
    CHECK(lines.status == 0);
    CHECK(schema_violations(json::parse(lines.out.substr(0, lines.out.find('\n'))), "answer") == "");
    const Outcome refused = run("-q --batch - --check 'nozzle.stress_max<1kPa'", "alpha\n0.75\n-1\n");
    CHECK(refused.status == 6);
    CHECK(contains(refused.err, "no value in 1"));
    // A second run over the first one's answer replaces its columns.
    CHECK(run("-q --batch - --check 'nozzle.stress_max<1kPa'", rows.out).out == rows.out);
}

TEST_CASE("check: a simulation can be held to a condition") {
    const Outcome outcome =
        run("-q --simulate=channel --fidelity draft --check 'simulation.simulated.von_mises<1Pa' --json");
    CHECK(outcome.status == 7);
    CHECK(contains(outcome.err, "simulation.simulated.von_mises<1Pa does not hold"));
    CHECK(schema_violations(json::parse(outcome.out), "answer") == "");
}
