#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/command.hpp"
#include "support/text.hpp"

using bioprint::test::Outcome;
using bioprint::test::run;
using bioprint::test::write_scratch;
using bioprint::testing::contains;
using nlohmann::json;

TEST_CASE("trade: a loose tolerance is answered by a prediction and a strict one by a simulation within it") {
    const json loose = json::parse(run("--offset 0 --tolerance 20% --json").out);
    CHECK(loose["choice"]["met"] == true);
    CHECK(loose["choice"]["model"] == "ellipsoid");
    CHECK_FALSE(loose.contains("simulation"));
    const json strict = json::parse(run("--offset 0 --simulate=exit-flow --tolerance 1% --json").out);
    const double value = strict["simulation"]["simulated"]["elongational_stress_average"];
    CHECK(strict["simulation"]["error"]["elongational_stress_average"].get<double>() / value < 0.01);
}

TEST_CASE("trade: a tolerance the draft misses is met by a finer run") {
    const Outcome outcome = run("--offset 0 --simulate=channel --shear-modulus 50kPa --tolerance 2% --json");
    CHECK(outcome.status == 0);
    const json answer = json::parse(outcome.out);
    const double value = answer["simulation"]["simulated"]["von_mises"];
    CHECK(answer["simulation"]["error"]["von_mises"].get<double>() / value < 0.02);
    CHECK(answer["simulation"]["lattice"]["nodes_per_cell_radius"].get<double>() > 5.0);
}

TEST_CASE("trade: a tolerance no run meets is an answer with status 5") {
    const Outcome outcome =
        run("--offset 0 --simulate=channel --shear-modulus 50kPa --tolerance 0.000001% --json");
    CHECK(outcome.status == 5);
    CHECK(contains(outcome.err, "--resolution goes further"));
    const json answer = json::parse(outcome.out);
    CHECK(answer["simulation"]["fidelity"] == "fine");
    CHECK(answer["choice"]["model"] == "fine");
    CHECK(answer["choice"]["met"] == false);
    CHECK(answer["warnings"].back()["code"] == "tolerance_not_met");
}

TEST_CASE("trade: a budget of a millisecond never simulates") {
    const json answer = json::parse(run("--offset 0 --budget 2ms --json").out);
    CHECK_FALSE(answer.contains("simulation"));
    CHECK(answer["choice"]["budget"].get<double>() == doctest::Approx(2e-3));
}

TEST_CASE("trade: a simulation that no budget allows is the cheapest one with status 5") {
    for (const char* call : {"-q --simulate=channel --offset 0 --budget 1ms --json",
                             "-q --simulate=channel --offset 0 --tolerance 3% --budget 1ms --json",
                             "-q --simulate=channel --offset 3Rc --budget 1ms --json"}) {
        const Outcome outcome = run(call);
        CAPTURE(call);
        CHECK(outcome.status == 5);
        CHECK(contains(outcome.err, "--budget: no simulation is within 1 ms"));
        const json answer = json::parse(outcome.out);
        CHECK(answer["choice"]["met"] == false);
        CHECK(answer["choice"]["model"] == "draft");
        CHECK(answer["simulation"]["fidelity"] == "draft");
        CHECK(answer["warnings"].back()["code"] == "budget_not_met");
    }
}

TEST_CASE("trade: a budget takes the most accurate simulation within it") {
    const json answer = json::parse(run("--simulate=channel --offset 0 --budget 10s --json").out);
    CHECK(answer["choice"]["model"] == "standard");
    CHECK(answer["choice"]["met"] == true);
    CHECK(answer["simulation"]["fidelity"] == "standard");
}

TEST_CASE("trade: a simulation is refined within the budget alone") {
    const std::string call = "-q --offset 0 --simulate=channel --shear-modulus 50kPa --tolerance 0.1% --json";
    const json tight = json::parse(run(call + " --budget 100ms").out);
    CHECK(tight["choice"]["model"] == "draft");
    CHECK(contains(tight["choice"]["reason"], "more than the budget"));
    const json wide = json::parse(run(call + " --budget 10s").out);
    CHECK(wide["choice"]["model"] == "fine");
    CHECK(wide["simulation"]["fidelity"] == "fine");
    CHECK(wide["simulation"]["lattice"]["nodes_per_cell_radius"].get<double>() > 11.0);
}

TEST_CASE("trade: a model that would be refused is not taken and the best of the others answers") {
    for (const char* call :
         {"--viscosity-ratio 5 --offset 0 --tolerance 5%", "--cell-radius 39um --offset 0 --tolerance 5%",
          "--shear-modulus 1MPa --velocity 1um/s --offset 0 --tolerance 5%",
          "--ink ama-25C --needle 25G --tip steel --length 12.7mm --pressure 2bar --offset 0 --tolerance "
          "5%"}) {
        const Outcome outcome = run(std::string("-q --json ") + call);
        CAPTURE(call);
        CHECK(outcome.status == 5);
        const json choice = json::parse(outcome.out)["choice"];
        CHECK(choice["model"] == "ellipsoid");
        CHECK_FALSE(contains(choice["reason"], "Next"));
        for (const json& model : choice["models"]) {
            const bool simulation =
                model["model"] == "draft" || model["model"] == "standard" || model["model"] == "fine";
            CHECK(model["refused"].is_string() == simulation);
        }
    }
    CHECK(contains(run("-q --viscosity-ratio 5 --offset 0 --tolerance 5%").out, "cannot follow it"));
}

TEST_CASE("trade: a tolerance that no model is known to keep is said and ends with status 5") {
    for (const char* call :
         {"--tolerance 10% --shear-modulus 200 --alpha 0 --offset 0",
          "--tolerance 1% --budget 10ms --offset 0", "--tolerance 10% --offset 0 --alpha 0.9"}) {
        CAPTURE(call);
        const Outcome outcome = run(std::string("-q --json ") + call);
        CHECK(outcome.status == 5);
        CHECK(contains(outcome.err, "--tolerance: no model that can follow this question"));
        const json answer = json::parse(outcome.out);
        CHECK(answer["choice"]["met"] == false);
        CHECK(answer["warnings"].back()["code"] == "tolerance_not_met");
        const Outcome value = run(std::string("-q --get choice.met ") + call);
        CHECK(value.status == 5);
        CHECK(value.out == "false\n");
    }
    CHECK(run("-q --tolerance 20% --offset 0 --get choice.met").status == 0);
}

TEST_CASE("trade: explain shows the errors of the tables in the manual") {
    const std::string explained = run("-q --offset 0 --explain").out;
    CHECK(contains(explained, "152 % (1 of 5 unanswered)"));
    CHECK(contains(explained, "7.9 %"));
    CHECK(contains(run("-q --offset 3Rc --explain").out, "8.5 % (1 of 5 unanswered)"));
    CHECK(contains(run("-q --explain --alpha 0.9").out, "outside what was measured"));
}

TEST_CASE("trade: explain changes no number of the answer") {
    json plain = json::parse(run("--json").out);
    json explained = json::parse(run("--json --explain").out);
    CHECK(explained["choice"]["model"] == "ellipsoid");
    explained.erase("choice");
    CHECK(plain == explained);
    CHECK(contains(run("--explain -q").out, "Models for exit"));
    CHECK(contains(run("--explain -q --simulate=exit-flow --fidelity draft").out, "Models for exit-flow"));
}

TEST_CASE("trade: a dry run counts rows and answers nothing") {
    CHECK(contains(run("--alpha 0:0.7:0.1 --dry-run").out, "rows     8\n"));
    write_scratch("rows.csv", "alpha\n0.1\n0.2\n\n0.3\n");
    CHECK(contains(run("--batch rows.csv --dry-run").out, "rows     3\n"));
    CHECK(contains(run("--simulate --dry-run").out, "simulation of exit"));
    CHECK(run("--batch missing.csv --dry-run").status == 4);
    CHECK(run("--alpha -1 --dry-run").status == 2);
}

TEST_CASE("trade: a dry run refuses what the call would refuse") {
    for (const char* call :
         {"--viscosity-ratio 5 --simulate", "--shear-modulus 1MPa --velocity 1um/s --simulate",
          "--law herschel-bulkley --yield-stress 60Pa --consistency 79Pa.s^n --flow-index 0.4 --simulate",
          "--simulate=channel --offset 45um", "--simulate --format csv", "--alpha 1.2"}) {
        CAPTURE(call);
        const Outcome planned = run(std::string(call) + " --dry-run");
        const Outcome done = run(call);
        CHECK(planned.status == done.status);
        CHECK(planned.status != 0);
        CHECK(planned.err == done.err);
        CHECK(planned.out.empty());
    }
    CHECK(run("--cell-radius 39um --offset 0 --tolerance 5% --dry-run").status == 5);
    write_scratch("strange.csv", "name\nx\n");
    CHECK(run("--batch strange.csv --dry-run").status == 2);
}

TEST_CASE("trade: a dry run of a piece counts the rows of the piece") {
    std::string text = "radius [um]\n";
    for (int i = 0; i < 59; ++i) text += (i == 5 ? "\n" : "") + std::to_string(40 + i) + "\n";
    write_scratch("rows.csv", text);
    CHECK(contains(run("--batch rows.csv --dry-run").out, "rows     59\n"));
    CHECK(contains(run("--batch rows.csv --dry-run --shard 1/3").out, "rows     19 of 59, piece 1 of 3\n"));
    CHECK(contains(run("--batch rows.csv --dry-run --shard 3/3").out, "rows     20 of 59, piece 3 of 3\n"));
    CHECK(contains(run("--alpha 0:0.7:0.1 --dry-run --format csv --shard 1/3").out, "rows     3 of 8,"));
    CHECK(json::parse(run("--batch rows.csv --dry-run --format jsonl --shard 2/3").out)["records"] == 20);
    const json whole = json::parse(run("--batch rows.csv --dry-run --json -j1").out);
    const json piece = json::parse(run("--batch rows.csv --dry-run --format jsonl -j1 --shard 1/10").out);
    CHECK(piece["time"].get<double>() < 0.5 * whole["time"].get<double>());
}

TEST_CASE("trade: a dry run tells as JSON and what is not met") {
    const json plan = json::parse(run("--dry-run --json --simulate=channel --offset 0").out);
    CHECK(plan["schema"] == "bioprint-predict/plan/1");
    CHECK(plan["measured"] == true);
    CHECK(plan["time_most"].get<double>() > plan["time_least"].get<double>());
    CHECK(plan["memory"].get<double>() > 5e6);
    const Outcome outcome = run("--dry-run --json --simulate=channel --offset 0 --budget 1ms");
    CHECK(outcome.status == 5);
    CHECK(json::parse(outcome.out)["choice"]["met"] == false);
    CHECK(contains(run("--dry-run --explain").out, "Models for exit"));
    const Outcome refined = run("--dry-run --simulate=channel --offset 0 --tolerance 5%");
    CHECK(refined.status == 0);
    CHECK(contains(refined.out, "finer runs while its own numerical error is above 5 %"));
    const Outcome bounded = run("--dry-run --simulate=channel --offset 0 --tolerance 7% --budget 1s");
    CHECK(contains(bounded.out, "3 nodes a cell radius"));
    CHECK_FALSE(contains(bounded.out, "finer runs"));  // the budget does not allow one
    const Outcome finest = run("--dry-run --simulate=channel --offset 0 --tolerance 0.5%");
    CHECK(finest.status == 0);  // the run's own error decides
    CHECK_FALSE(contains(finest.out, "finer runs"));
}

TEST_CASE("trade: a dry run says where the time lies outside what was measured") {
    for (const char* call : {"--offset 0 -a 0.95 -K 100 --simulate=exit-flow --fidelity draft",
                             "--offset 0 --cell-radius 2um --simulate=channel",
                             "--offset 0 --velocity 20um/s --shear-modulus 50kPa --simulate=channel"}) {
        CAPTURE(call);
        CHECK(contains(run(std::string("--dry-run ") + call).out, "outside what was measured"));
    }
    const std::string usual = run("--dry-run --simulate=channel --offset 0 --fidelity draft").out;
    CHECK(contains(usual, " as a rule, at most "));
    CHECK_FALSE(contains(usual, "outside"));
}

TEST_CASE("trade: the time of a batch is that of its own rows") {
    std::string text = "radius [um]\n";
    for (int i = 0; i < 300; ++i) text += std::to_string(40 + i % 50) + "\n";
    write_scratch("rows.csv", text);
    const auto time = [](const char* call) { return json::parse(run(call).out)["time"].get<double>(); };
    const double steady = time("--batch rows.csv --dry-run --json -j1 --model steady");
    CHECK(time("--batch rows.csv --dry-run --json -j1") > 2.0 * steady);
}

TEST_CASE("trade: what does not fit together is refused") {
    for (const char* call :
         {"--tolerance 0", "--tolerance 300%", "--tolerance 5s", "--budget 0s", "--budget 5mm",
          "--tolerance 5% --model steady", "--tolerance 5% --alpha 0,0.3", "--explain --batch rows.csv",
          "--simulate --tolerance 5% --out kept", "--simulate --tolerance 5% --fidelity draft",
          "--simulate --fidelity fine --budget 1min"}) {
        const Outcome outcome = run(call);
        CAPTURE(call);
        CHECK(outcome.status == 2);
        CHECK(contains(outcome.err, "--"));
        CHECK(outcome.out.empty());
    }
}

TEST_CASE(
    "trade: a cell too soft to keep a shape in the nozzle is refused before the run with what would do") {
    const Outcome outcome =
        run("--alpha 0 --shear-modulus 200Pa --offset 0 --simulate=channel --fidelity draft");
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.err, "--channel-time"));
    CHECK(run("--alpha 0 --shear-modulus 200Pa --offset 0 --simulate=channel --fidelity draft --channel-time "
              "5ms -q")
              .status == 0);
}
