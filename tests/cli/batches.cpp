#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "support/text.hpp"

using bioprint::test::Outcome;
using bioprint::test::read_scratch;
using bioprint::test::run;
using bioprint::test::scratch_exists;
using bioprint::test::write_scratch;
using bioprint::testing::contains;
using bioprint::testing::lines;
using nlohmann::json;

namespace {

/// The value in the column called `name` of a row without quotes.
std::string cell(const std::string& table, std::size_t row, const std::string& name, char separator = ',') {
    const auto split = [&](const std::string& line) {
        std::vector<std::string> fields;
        std::istringstream in(line.substr(0, line.find('\r')));
        for (std::string field; std::getline(in, field, separator);) fields.push_back(field);
        return fields;
    };
    const std::vector<std::string> all = lines(table);
    const std::vector<std::string> names = split(all.at(0));
    const auto found = std::find(names.begin(), names.end(), name);
    REQUIRE(found != names.end());
    const std::vector<std::string> fields = split(all.at(row));
    const auto index = static_cast<std::size_t>(found - names.begin());
    return index < fields.size() ? fields[index] : "";
}

}  // namespace

TEST_CASE("batches: a value that another law or question has is null in the rows without it") {
    const std::string paths = " --get input.ink.name --get nozzle.plug_radius --model steady";
    const auto is_good = [](const Outcome& outcome) {
        CHECK(outcome.status == 0);
        CHECK(outcome.out.starts_with("ama-25C\t"));
        CHECK_FALSE(outcome.out.starts_with("ama-25C\tnull"));
        CHECK(outcome.out.ends_with("\nalginate-2.5\tnull\n"));
        CHECK_FALSE(contains(outcome.err, "--get"));
    };
    const std::string lines = "{\"ink\":\"ama-25C\"}\n{\"ink\":\"alginate-2.5\"}\n";
    is_good(run("--batch -" + paths, lines));
    is_good(run("--batch -" + paths, "ink\nama-25C\nalginate-2.5\n"));
    is_good(run("--ink ama-25C,alginate-2.5" + paths));
    // As many cells, warnings and spreads as a row has.
    const Outcome mixed =
        run("--batch - --model steady --get cells.2.offset --get warnings.3.code --get uncertainty.samples",
            "{\"offset\":\"0,1Rc\",\"alpha\":\"0.5±0.1\"}\n{\"offset\":\"0\"}\n");
    CHECK(mixed.status == 0);
    CHECK(contains(mixed.out, "8e-06\tnull\t1024\nnull\tnull\tnull\n"));
    CHECK(contains(mixed.err, "--get: none of the rows has 'warnings.3.code'"));
    // Nobody's place is a mistake, and what no row was asked for is said.
    for (const std::string& rows : {std::string("--batch -"), std::string("--alpha 0.5,0.6")}) {
        const Outcome mistaken = run(rows + " --get nozzle.plug_radios", "alpha\n0.5\n");
        CHECK(mistaken.status == 2);
        CHECK(contains(mistaken.err, "no value at 'nozzle.plug_radios'"));
        CHECK(mistaken.out.empty());
        const Outcome unasked = run(rows + " --get population.p95", "alpha\n0.5\n");
        CHECK(unasked.status == 0);
        CHECK(contains(unasked.err, "none of the rows has 'population.p95'; add --population"));
    }
}

TEST_CASE("csv batch: the user's columns come back byte for byte with ours behind them") {
    const std::string table =
        "sample,radius,\"flow rate note\",flowrate\n"
        "A1,50um,\"a, \"\"quoted\"\" note\",141uL/h\n"
        "B2, 60um ,,20 uL/min\n";
    const Outcome outcome = run("--batch -", table);
    CHECK(outcome.status == 0);
    const std::vector<std::string> in = lines(table);
    const std::vector<std::string> out = lines(outcome.out);
    REQUIRE(out.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(out[i].substr(0, in[i].size() + 1) == in[i] + ",");
    CHECK(cell(outcome.out, 2, "input.radius [m]") == "6e-05");
    CHECK(contains(outcome.err, "'sample'"));
}

TEST_CASE("csv batch: a second run over its own output changes no byte") {
    const std::string table = "sample,radius,alpha\nA,50um,0.75\nB,40um,0.3\nC,-1um,0.3\n";
    const std::string once = run("--batch - -q", table).out;
    CHECK(run("--batch - -q", once).out == once);
}

TEST_CASE("csv batch: an answer alone can be asked again") {
    const std::string answers = run("--alpha 0,0.3 --radius 40um --format csv").out;
    const Outcome again = run("--batch - -q", answers);
    CHECK(again.status == 0);
    CHECK(cell(again.out, 2, "nozzle.stress_max [Pa]") == cell(answers, 2, "nozzle.stress_max [Pa]"));
}

TEST_CASE("csv batch: a path of the answer's input is a question where there is no answer") {
    const Outcome outcome = run("--batch - -q", "radius,input.ink.alpha\n50um,0\n");
    CHECK(outcome.status == 0);
    CHECK(cell(outcome.out, 1, "nozzle.stress_max [Pa]") == "2000");
}

TEST_CASE("csv: what --threshold asks of a population has columns") {
    const std::string share = "population.thresholds.0.share_above";
    const std::string call = "-q --population --threshold 300Pa --threshold 1kPa --format csv";
    const std::string one = run(call).out;
    CHECK(cell(one, 1, "population.thresholds.0.stress [Pa]") == "300");
    CHECK(cell(one, 1, "population.thresholds.1.stress [Pa]") == "1000");
    CHECK(cell(one, 1, share) + "\n" == run("-q --population --threshold 300Pa --get " + share).out);
    CHECK_FALSE(contains(run("-q --batch - --population", one).out, "thresholds"));  // an earlier run's
    const std::string rows = "population,threshold [kPa]\nyes,0.3\nyes,\nyes,\"0.3,1\"\n";
    const Outcome batch = run("-q --batch -", rows);
    CHECK(cell(batch.out, 1, share) == cell(one, 1, share));
    CHECK(cell(batch.out, 2, share).empty());
    CHECK(batch.status == 6);
    CHECK(contains(batch.out, "more thresholds than the first row has"));
}

TEST_CASE("csv batch: bytes that are no text are named and do not end the batch") {
    const Outcome outcome = run("--batch - -q --json", "alpha,radius [q\xFC]\n0,5\n0,\n");
    CHECK(outcome.status == 6);
    CHECK(json::parse(outcome.out).size() == 2);
}

TEST_CASE("csv batch: separator and decimal comma and byte order mark and line ends are mirrored") {
    const std::string table = "\xEF\xBB\xBFProbe;radius [um];alpha\r\nA;50,5;0,75\r\nB;40;0,3\r\n";
    const Outcome outcome = run("--batch - -q", table);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.substr(0, 3) == "\xEF\xBB\xBF");
    const std::string body = outcome.out.substr(3);
    CHECK(cell(body, 1, "input.radius [m]", ';') == "5,05e-05");
    CHECK(cell(body, 1, "input.ink.alpha", ';') == "0,75");
    CHECK(body.substr(body.size() - 2) == "\r\n");
    CHECK(run("--batch - -q", outcome.out).out == outcome.out);
}

TEST_CASE("csv batch: a missing last line end stays missing") {
    const std::string out = run("--batch - -q", "radius\n50um").out;
    CHECK(out.back() != '\n');
    CHECK(run("--batch - -q", out).out == out);
}

TEST_CASE("csv batch: a bad row is answered in place and the others go on with status 6") {
    const Outcome outcome =
        run("--batch - -q", "name,radius,alpha\na,50um,0.75\nb,5s,0.75\nc,60um\nd,50um,2\ne,50um,0\n");
    CHECK(outcome.status == 6);
    CHECK(lines(outcome.out).size() == 6);
    CHECK(cell(outcome.out, 2, "error.code") == "usage");
    CHECK(cell(outcome.out, 3, "error.code").empty());  // cells missing at the end are empty cells
    CHECK(cell(outcome.out, 4, "error.code") == "no_steady_flow");
    CHECK(cell(outcome.out, 1, "error.code").empty());
    CHECK(cell(outcome.out, 5, "nozzle.stress_max [Pa]") == "2000");
}

TEST_CASE("csv batch: a row with cells too many or a quote not closed comes back as it is with a remark") {
    const Outcome outcome = run("--batch -", "radius,note\n50um,a,b\n60um,c\n");
    CHECK(outcome.status == 6);
    CHECK(lines(outcome.out).at(1) == "50um,a,b");
    CHECK(cell(outcome.out, 2, "input.radius [m]") == "6e-05");
    CHECK(contains(outcome.err, "line 2"));
    CHECK(run("--batch - -q", outcome.out).out == outcome.out);
}

TEST_CASE("csv batch: columns of the user that are named like ours stay his") {
    const std::string once = run("--batch - -q", "warnings,radius\nmind the gap,50um\n").out;
    CHECK(once.substr(0, 15) == "warnings,radius");
    CHECK(run("--batch - -q", once).out == once);
}

TEST_CASE("csv batch: text of ours that a spreadsheet would run is disarmed") {
    const Outcome outcome = run("--batch - -q", "radius,ink\n50um,=cmd()\n");
    CHECK(outcome.status == 6);
    const std::string row = lines(outcome.out).at(1);
    CHECK(row.substr(0, 13) == "50um,=cmd(),,");  // the user's own cell is his
    CHECK(row.find(",=", 5) == std::string::npos);
}

TEST_CASE("csv batch: the options of the command line are the rows' defaults") {
    const Outcome outcome =
        run("--batch - -q --alpha 0 --needle 25G --tip steel", "radius,velocity\n50um,\n,1mm/s\n");
    CHECK(cell(outcome.out, 1, "input.radius [m]") == "5e-05");
    CHECK(cell(outcome.out, 2, "input.radius [m]") == "0.000125");
    CHECK(cell(outcome.out, 2, "input.ink.alpha") == "0");
    CHECK(cell(outcome.out, 1, "nozzle.velocity_average [m/s]") == "0.005");
}

TEST_CASE("csv batch: rows choose their positions") {
    const Outcome outcome = run("--batch - -q", "offset\n\"0,2Rc\"\n20um\n");
    CHECK(outcome.status == 0);
    CHECK(contains(outcome.out, "cells.2.offset"));
    CHECK(run("--batch - -q", "offset\n20um\n\"0,1Rc,2Rc\"\n").status == 6);
}

TEST_CASE("csv batch: what cannot be understood is refused with the remedy") {
    CHECK(run("--batch -", "a,b\n1,2\n").status == 2);
    CHECK(run("--batch -", "").status == 2);
    CHECK(run("--batch -", "radius,diameter,radius\n1,2,3\n").status == 2);
    CHECK(run("--batch - --alpha 0,0.5", "radius\n50um\n").status == 2);
    CHECK(run("--batch - --format table", "radius\n50um\n").status == 2);
}

TEST_CASE("json lines batch: an object a line in and out") {
    const Outcome outcome =
        run("--batch -",
            "{\"radius\": \"50um\", \"alpha\": 0}\n"
            "{\"input\": {\"radius\": 6e-5, \"ink\": {\"alpha\": 0.3}}, \"offset\": [0, \"2Rc\"]}\n"
            "{\"radius\": \"50um\", \"bogus\": 1}\n"
            "not json\n");
    CHECK(outcome.status == 6);
    const std::vector<std::string> rows = lines(outcome.out);
    REQUIRE(rows.size() == 4);
    CHECK(json::parse(rows[0])["nozzle"]["pressure_gradient"] == 8e7);
    CHECK(json::parse(rows[1])["input"]["offsets"] == json::array({0.0, 16e-6}));
    CHECK(json::parse(rows[2])["error"]["option"] == "bogus");
    CHECK(contains(json::parse(rows[3])["error"]["message"], "line 4"));
}

TEST_CASE("json lines batch: the values of a refused line are its error and its id") {
    const std::string call =
        "--batch - --get id --get error.code --get error.message --get nozzle.stress_max";
    const Outcome outcome =
        run(call, "{\"radius\":\"5s\",\"id\":\"r1\"}\n{\"alpha\":0,\"radius\":\"50um\",\"id\":\"r2\"}\n");
    CHECK(outcome.status == 6);
    const auto rows = lines(outcome.out);
    CHECK(rows[0].starts_with("r1\tusage\tradius: "));
    CHECK(rows[0].ends_with("\tnull"));
    CHECK(rows[1] == "r2\tnull\tnull\t2000");
    CHECK_FALSE(contains(outcome.err, "none of the rows"));
    CHECK_FALSE(contains(run(call, "{\"alpha\":0}\n").err, "none of the rows"));
    CHECK(run("--batch - --get error.cod", "alpha\n0\n").status == 2);
}

TEST_CASE("sweep: a row without an answer keeps its swept values") {
    const std::string sweep = "-q --model steady --alpha 0.5,1.3 --velocity 1m/s,2m/s --diameter 100um,120um";
    const auto values =
        lines(run(sweep + " --get input.ink.alpha --get nozzle.velocity_average --get input.radius "
                          "--get nozzle.stress_max")
                  .out);
    CHECK(values[4] == "1.3\t1\t5e-05\tnull");
    CHECK(values[7] == "1.3\t2\t6e-05\tnull");
    const std::string csv = run(sweep + " --format csv").out;
    CHECK(cell(csv, 8, "input.ink.alpha") == "1.3");
    CHECK(cell(csv, 8, "nozzle.velocity_average [m/s]") == "2");
    CHECK(cell(csv, 8, "input.radius [m]") == "6e-05");
    CHECK(cell(csv, 8, "nozzle.stress_max [Pa]").empty());
    const json row =
        json::parse(lines(run("-q --needle 25G,27G --alpha 0.5,1.3 --velocity 1m/s --format jsonl").out)[3]);
    CHECK(row["input"]["ink"]["alpha"] == 1.3);
    CHECK(row["input"]["needle"]["name"] == "27G");
    CHECK(row["error"]["code"] == "no_steady_flow");
}

TEST_CASE("json lines batch: a line's id comes back with its answer or its error") {
    const std::string asked =
        "{\"id\": \"B7\", \"radius\": \"50um\"}\n{\"id\": 12, \"radius\": \"-1um\"}\n"
        "{\"radius\": \"50um\"}\n{\"id\": [1], \"radius\": \"50um\"}\n";
    const Outcome outcome = run("-q --batch - --model steady", asked);
    CHECK(outcome.status == 6);
    const std::vector<std::string> rows = lines(outcome.out);
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].starts_with("{\"id\":\"B7\","));
    CHECK(json::parse(rows[1])["id"] == 12);
    CHECK(json::parse(rows[1]).contains("error"));
    CHECK(!json::parse(rows[2]).contains("id"));
    CHECK(contains(json::parse(rows[3])["error"]["message"], "id: takes a text or a number"));
    CHECK(run("-q --batch - --model steady --get id --get nozzle.stress_max", asked).out.starts_with("B7\t"));
    CHECK(run("-q --batch - --model steady --get id", asked).out == "B7\n12\nnull\nnull\n");
}

TEST_CASE("json lines batch: an answer's input asks the same question again") {
    const json answer = json::parse(run("--radius 40um --alpha 0.3 --json").out);
    const std::string question = json({{"input", answer["input"]}}).dump() + "\n";
    CHECK(json::parse(run("--batch -", question).out)["nozzle"] == answer["nozzle"]);
}

TEST_CASE("batch: json and csv and single values can be asked of either kind") {
    CHECK(json::parse(run("--batch - --json", "{\"alpha\": 0}\n{\"alpha\": 0.5}\n").out).size() == 2);
    CHECK(json::parse(run("--batch - -q --json", "alpha\n0\n0.5\n").out).size() == 2);
    CHECK(lines(run("--batch - --format csv", "{\"alpha\": 0}\n{\"alpha\": 0.5}\n").out).size() == 3);
    CHECK(run("--batch - -q --get input.ink.alpha", "alpha\n0\n0.5\n").out == "0\n0.5\n");
}

TEST_CASE("batch: an output file is written whole and replaces its own input") {
    write_scratch("runs.csv", "radius\n50um\n60um\n");
    CHECK(run("--batch runs.csv -o runs.csv -q").status == 0);
    const std::string once = read_scratch("runs.csv");
    CHECK(lines(once).size() == 3);
    CHECK(run("--batch runs.csv -o runs.csv -q").status == 0);
    CHECK(read_scratch("runs.csv") == once);
}

TEST_CASE("batch: the bytes do not depend on the number of threads") {
    std::string table = "id,radius,alpha\n";
    for (int i = 0; i < 5000; ++i) {
        table +=
            std::to_string(i) + "," + std::to_string(20 + i % 80) + "um,0." + std::to_string(i % 90) + "\n";
    }
    CHECK(run("--batch - -q --jobs 1", table).out == run("--batch - -q --jobs 3", table).out);
}
