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
        run("--offset 0 --simulate=exit-flow --tolerance 0.000001% --fidelity draft --json");
    CHECK(outcome.status == 5);
    CHECK(contains(outcome.err, "--resolution goes further"));
    CHECK(json::parse(outcome.out).contains("simulation"));
}

TEST_CASE("trade: a budget of a millisecond never simulates") {
    const json answer = json::parse(run("--offset 0 --budget 2ms --json").out);
    CHECK_FALSE(answer.contains("simulation"));
    CHECK(answer["choice"]["budget"].get<double>() == doctest::Approx(2e-3));
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

TEST_CASE("trade: what does not fit together is refused") {
    for (const char* call : {"--tolerance 0", "--tolerance 300%", "--tolerance 5s", "--budget 0s",
                             "--budget 5mm", "--tolerance 5% --model steady", "--tolerance 5% --alpha 0,0.3",
                             "--explain --batch rows.csv", "--simulate --tolerance 5% --out kept"}) {
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
