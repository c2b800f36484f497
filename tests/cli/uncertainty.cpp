#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "support/schema.hpp"
#include "support/text.hpp"

using bioprint::test::Outcome;
using bioprint::test::run;
using bioprint::test::write_scratch;
using bioprint::testing::contains;
using bioprint::testing::schema_violations;
using nlohmann::json;

TEST_CASE("uncertainty: an input with its spread adds that of every number to the answer") {
    const Outcome outcome = run("--alpha 0.75±0.05 --json");
    CHECK(outcome.status == 0);
    const json answer = json::parse(outcome.out);
    CHECK(schema_violations(answer, "answer") == "");
    CHECK(answer["uncertainty"]["inputs"].size() == 1);
    CHECK(answer["uncertainty"]["samples"] == 1024);
    CHECK(answer["uncertainty"]["cells"].size() == answer["cells"].size());
    CHECK(answer["uncertainty"]["nozzle"]["stress_max"]["first_order"]["alpha"].get<double>() > 0.95);
    CHECK(answer["uncertainty"]["nozzle"]["pressure_drop"] == nullptr);
    CHECK(answer["nozzle"] == json::parse(run("--alpha 0.75 --json").out)["nozzle"]);
}

TEST_CASE("uncertainty: the presets' scatter with a table of shares and advice") {
    const Outcome outcome = run("--uncertainty");
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "Uncertainty: 1024 samples"));
    CHECK(contains(outcome.out, "eta0 10 ± 1.5 Pa s (log-normal)"));
    CHECK(contains(outcome.out, "share of the variance by"));
    CHECK(contains(outcome.out, "Most of the spread of"));
}

TEST_CASE("uncertainty: an ink of any law varies by the spreads that its preset states") {
    const auto names = [](const std::string& law, const std::string& parameters, const std::string& more) {
        write_scratch("ink.json",
                      R"({"name": "mine", "law": ")" + law + R"(", "parameters": {)" + parameters + "}}");
        const Outcome outcome =
            run("-q --ink ./ink.json --uncertainty --samples 16 --model steady --json" + more);
        REQUIRE(outcome.status == 0);
        std::string text;
        const json answer = json::parse(outcome.out);
        CHECK(answer["uncertainty"]["failed"] == 0);
        for (const json& input : answer["uncertainty"]["inputs"])
            text += input["name"].get<std::string>() + " " + input["source"].get<std::string>() + "; ";
        return text;
    };
    const std::string herschel =
        R"("yield_stress": {"value": 12, "unit": "Pa", "sd": 0.5}, "consistency": {"value": 8, "unit": "Pa.s^n", "sd": 0.2},
           "flow_index": {"value": 0.5, "unit": "1"})";
    CHECK(names("herschel-bulkley", herschel, "") == "consistency preset mine; yield-stress preset mine; ");
    // What is given replaces the preset's; exactly or with a spread of its own.
    CHECK(names("herschel-bulkley", herschel, " --yield-stress 10Pa") == "consistency preset mine; ");
    CHECK(names("herschel-bulkley", herschel, " --yield-stress 10Pa±1Pa") ==
          "yield-stress given; consistency preset mine; ");
    CHECK(names("power-law",
                R"("consistency": "8 Pa.s^n", "flow_index": {"value": 0.5, "unit": "1", "sd": 0.02})",
                "") == "flow-index preset mine; ");
    // Close to 1, where the law ends.
    CHECK(names("carreau-yasuda",
                R"("eta0": {"value": 8, "unit": "Pa.s", "sd": 1}, "time_constant": "1 s",
                   "flow_index": {"value": 0.95, "unit": "1", "sd": 0.1})",
                "") == "eta0 preset mine; flow-index preset mine; ");
}

TEST_CASE("uncertainty: a fitted ink varies as its flow curve leaves it open") {
    std::string curve = "rate [1/s],viscosity [Pa.s]\n";
    std::string high = curve;
    for (int i = 0; i < 31; ++i) {
        const auto point = [&](double rate) {
            const double scatter = 1.0 + 0.02 * std::sin(12.9898 * i * i + 1.0);
            return std::to_string(rate) + "," +
                   std::to_string(37.0 * scatter / (1.0 + std::pow(0.8 * rate, 0.68))) + "\n";
        };
        curve += point(0.01 * std::pow(10.0, i / 6.0));
        high += point(100.0 * std::pow(10.0, i / 30.0));
    }
    write_scratch("curve.csv", curve);
    write_scratch("high.csv", high);
    REQUIRE(run("fit -q curve.csv --preset curve.json").status == 0);
    REQUIRE(run("fit -q high.csv --preset high.json").status == 0);
    const std::string call = "--uncertainty --model steady --radius 50±1um ";
    const json answer = json::parse(run(call + "--json -q --ink ./curve.json").out);
    CHECK(schema_violations(answer, "answer") == "");
    CHECK(answer["uncertainty"]["correlation"]["names"] == json({"eta0", "time-constant", "alpha"}));
    CHECK(answer["uncertainty"]["held"].empty());
    const std::string table = run(call + "--ink ./curve.json").out;
    CHECK(contains(table, "vary together"));
    CHECK_FALSE(contains(table, "do not determine"));
    // Given, it leaves the others alone.
    const json given = json::parse(run(call + "--json -q --ink ./curve.json --eta0 37Pa.s±1Pa.s").out);
    CHECK(given["uncertainty"]["correlation"]["names"] == json({"time-constant", "alpha"}));

    const Outcome open = run(call + "--ink ./high.json");
    CHECK(contains(open.out, "do not determine time-constant"));
    CHECK_FALSE(contains(open.out, "\n  time-constant "));
    const Outcome value = run(call + "--ink ./high.json --get uncertainty.held");
    CHECK(value.out == "[\"time-constant\"]\n");
    CHECK(contains(value.err, "do not determine time-constant"));
}

TEST_CASE("uncertainty: the bytes do not depend on the threads") {
    for (const char* format : {"json", "csv", "table"}) {
        const std::string call = "--uncertainty --radius 50±2um --samples 64 --format " + std::string(format);
        CHECK(run(call + " -j 1").out == run(call + " -j 4").out);
    }
}

TEST_CASE("uncertainty: paths of the spread can be got and checked and stand in csv columns") {
    const std::string q = "-q --uncertainty --model steady ";
    const double high = std::stod(run(q + "--get uncertainty.nozzle.stress_max.percentile_95").out);
    CHECK(high > 450.0);
    CHECK(run(q + "--check 'uncertainty.nozzle.stress_max.percentile_95<10kPa'").status == 0);
    CHECK(run(q + "--check 'uncertainty.nozzle.stress_max.percentile_95<440Pa'").status == 7);
    CHECK(run(q + "--check 'uncertainty.nozzle.stress_max.first_order.alpha<1kPa'").status == 2);
    const std::string csv = run(q + "--format csv --alpha 0.5,0.7").out;
    CHECK(contains(csv, "uncertainty.nozzle.stress_max.standard_deviation [Pa]"));
    CHECK(contains(csv, "uncertainty.cells.0.stress.von_mises.percentile_5 [Pa]"));
    CHECK(run(q + "--batch - ", csv).status == 0);
}

TEST_CASE("uncertainty: rows of a batch carry spreads of their own") {
    const Outcome outcome = run("-q --batch - --format jsonl --model steady --samples 16",
                                "alpha,radius\n0.75±0.05,50um\n0.7,50±1um\n0.7,50um\n");
    CHECK(outcome.status == 0);
    std::istringstream lines(outcome.out);
    std::vector<json> rows;
    for (std::string line; std::getline(lines, line);) rows.push_back(json::parse(line));
    REQUIRE(rows.size() == 3);
    CHECK(rows[0]["uncertainty"]["inputs"][0]["name"] == "alpha");
    CHECK(rows[1]["uncertainty"]["inputs"][0]["name"] == "radius");
    CHECK_FALSE(rows[2].contains("uncertainty"));
    for (const json& row : rows) CHECK(schema_violations(row, "answer") == "");
}

TEST_CASE("uncertainty: a spread in a cell of a CSV batch has its columns in the answer") {
    const std::string rows =
        "id,radius [um],alpha,velocity\na,50,0.75±0.05,5mm/s\nb,100,0.5,5mm/s±5%\nc,80,0.6,5mm/s\n";
    write_scratch("spread.csv", rows);
    for (const std::string& batch : {std::string("spread.csv"), std::string("-")}) {
        const Outcome outcome = run("--batch " + batch + " --model steady --samples 16", rows);
        CHECK(outcome.status == 0);
        std::istringstream lines(outcome.out);
        std::vector<std::vector<std::string>> cells;
        for (std::string line; std::getline(lines, line);) {
            cells.emplace_back();
            std::istringstream row(line);
            for (std::string cell; std::getline(row, cell, ',');) cells.back().push_back(cell);
        }
        REQUIRE(cells.size() == 4);
        const std::string name = "uncertainty.nozzle.stress_max.standard_deviation [Pa]";
        const auto column = std::find(cells[0].begin(), cells[0].end(), name) - cells[0].begin();
        REQUIRE(column < std::ssize(cells[0]));
        const auto at = [&](std::size_t row) { return cells[row].at(static_cast<std::size_t>(column)); };
        CHECK(std::stod(at(1)) > 1.0);
        CHECK(std::stod(at(2)) > 0.1);
        CHECK(at(3).empty());
        // Answered twice it is the same.
        CHECK(run("--batch - --model steady --samples 16", outcome.out).out == outcome.out);
    }
    // The columns stand before the rows: a spread that comes too late is refused and not dropped.
    const Outcome late = run("--batch - --model steady", "alpha\n0.5\n0.5±0.1\n");
    CHECK(late.status == 6);
    CHECK(contains(late.out, "line 3: has a ±"));
    CHECK(run("--batch - --model steady --uncertainty --samples 8", "alpha\n0.5\n0.5±0.1\n").status == 0);
    write_scratch("late.csv", "alpha\n0.5\n0.5±0.1\n");
    CHECK(run("--batch late.csv --model steady --samples 8").status == 0);
    const Outcome lines = run("--batch - --model steady --format csv", "{\"alpha\":\"0.5±0.1\"}\n");
    CHECK(lines.status == 6);
    CHECK(contains(lines.out, "line 1: has a ±"));
    // A row that takes the command line's spread away has none.
    const Outcome without =
        run("--batch - --alpha 0.5±0.1 --model steady --samples 8", "alpha\n\"0.4\"\n\"\"\n0.3±0.1\n");
    CHECK(without.status == 0);
}

TEST_CASE("uncertainty: with the population the spread of its quantiles") {
    const Outcome outcome = run("-q --uncertainty --population --samples 8 --json");
    CHECK(outcome.status == 0);
    const json answer = json::parse(outcome.out);
    CHECK(schema_violations(answer, "answer") == "");
    CHECK(answer["uncertainty"]["population"]["peak_stress"]["percentile_95"]["standard_deviation"]
              .get<double>() > 0.0);
}

TEST_CASE("uncertainty: what is wrong is named") {
    CHECK(run("--alpha 0.75±").status == 2);
    CHECK(contains(run("--alpha 0.75±").err, "behind the ±"));
    CHECK(run("--alpha 0.3,0.75±0.05").status == 2);
    CHECK(contains(run("--alpha 0.3,0.75±0.05").err, "a list or range takes no ±"));
    CHECK(run("--radius 50um±1s").status == 2);
    CHECK(run("--samples 64").status == 2);
    CHECK(contains(run("--uncertainty --alpha 0.3,0.5").err, "choose one of them"));
    CHECK(run("--uncertainty --samples 3").status == 2);
    CHECK(run("--uncertainty --samples many").status == 2);
}
