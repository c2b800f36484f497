#include "io/checks.hpp"

#include <doctest/doctest.h>

#include <string>

#include "bioprint/errors.hpp"
#include "io/answer_checks.hpp"
#include "io/answer_path.hpp"
#include "support/text.hpp"

using namespace bioprint;
using bioprint::testing::contains;

namespace {

Json answer() {
    return answer_object(predict(Settings{}.make_case()));
}

std::string refusal(const std::string& text) {
    try {
        parse_check(text, "--check");
    } catch (const UsageError& e) {
        return e.what();
    }
    return "";
}

}  // namespace

TEST_CASE("check: all four relations are read with and without blanks and their limit is in SI") {
    CHECK(parse_check("nozzle.stress_max<2kPa", "--check").limit == 2000.0);
    CHECK(parse_check("nozzle.stress_max<2kPa", "--check").relation == Relation::less);
    CHECK(parse_check(" nozzle.stress_max <= 2 kPa ", "--check").relation == Relation::at_most);
    CHECK(parse_check("nozzle.flow_rate > 1uL/s", "--check").relation == Relation::greater);
    CHECK(parse_check("nozzle.flow_rate>=1uL/s", "--check").relation == Relation::at_least);
    CHECK(parse_check("cells.1.stretch.0>0.7", "--check").dimension == Dimension::dimensionless);
    CHECK(parse_check("population.p95<2kPa", "--check").path == "population.p95");
    CHECK(parse_check("simulation.simulated.von_mises_peak<2kPa", "--check").limit == 2000.0);
    CHECK(parse_check("simulation.difference.von_mises_peak<10%", "--check").limit == 0.1);
}

TEST_CASE("check: a limit of another kind is refused with what it takes") {
    CHECK(contains(refusal("nozzle.stress_max<2s"),
                   "--check nozzle.stress_max: got '2s', a time; it takes a pressure such as 1kPa"));
    CHECK(contains(refusal("cells.exit.stretch.0<1kPa"), "a plain number"));
    CHECK(contains(refusal("nozzle.stress_max"), "compares nothing"));
    CHECK(contains(refusal("<2kPa"), "without a path"));
    CHECK(contains(refusal("nozzle.stress_max<"), "nozzle.stress_max"));
    CHECK(contains(refusal("nozzle.stress_max==2kPa"), "compares nothing"));
}

TEST_CASE("check: short forms of paths are the places they stand for") {
    const Json full = answer();
    CHECK(json_path(full, "population.p95") == "population.peak_stress.percentile_95");
    CHECK(json_path(full, "population.exposure.p50") == "population.exposure.median");
    CHECK(json_path(full, "population.share_peaking_at_exit") == "population.share_peaking_at_exit");
    CHECK(json_path(full, "nozzle.stress_max") == "nozzle.stress_max");
    const auto entry = [&](const std::string& place) {
        const std::string path = json_path(full, "cells." + place + ".model");
        return value_at(full, path.substr(0, path.rfind('.')));
    };
    CHECK(entry("exit")["model"] == "ellipsoid");
    CHECK(entry("exit")["place"] == "exit");
    CHECK(entry("exit")["offset"] == 0.0);
    CHECK(entry("nozzle")["model"] == "ellipsoid");
    CHECK(entry("nozzle")["place"] == "nozzle");
    for (const Json& cell : full["cells"]) {
        if (cell["place"] != "nozzle" || cell["model"] != "ellipsoid") continue;
        CHECK(cell["stress"]["von_mises"] <= entry("nozzle")["stress"]["von_mises"]);
    }
    CHECK(dimension_at("cells.exit.stress.von_mises") == Dimension::pressure);
    CHECK(dimension_at("population.p95") == Dimension::pressure);
}

TEST_CASE("check: margin and verdict follow the relation and strict limits are strict") {
    const Json full = answer();
    const double stress = full["nozzle"]["stress_max"].get<double>();
    const auto at = [&](Relation relation, double limit) {
        return evaluate({.text = "",
                         .path = "nozzle.stress_max",
                         .relation = relation,
                         .limit = limit,
                         .dimension = Dimension::pressure},
                        full, "--check", true);
    };
    CHECK_FALSE(at(Relation::less, stress).holds);
    CHECK(at(Relation::at_most, stress).holds);
    CHECK_FALSE(at(Relation::greater, stress).holds);
    CHECK(at(Relation::at_least, stress).holds);
    CHECK(*at(Relation::less, stress + 100.0).margin == doctest::Approx(100.0));
    CHECK(*at(Relation::greater, stress + 100.0).margin == doctest::Approx(-100.0));
}

TEST_CASE("check: a value that does not exist holds no condition and the sentence says so") {
    const Check check = parse_check("nozzle.pressure_drop<3bar", "--check");
    const CheckResult result = evaluate(check, answer(), "--check", true);
    CHECK_FALSE(result.holds);
    CHECK_FALSE(result.value);
    CHECK(contains(sentence(check, result), "there is no value"));
    CHECK(contains(sentence(check, result), "--length"));
}

TEST_CASE("check: a mistaken path is told in the words it was written in, with the place that was meant") {
    const Json full = answer();
    const auto told = [&](const std::string& path) -> std::string {
        try {
            (void)value_meant(full, path);
        } catch (const UsageError& e) {
            return e.what();
        }
        return "";
    };
    CHECK(told("cells.exit.von_mises") ==
          "--get: no value at 'cells.exit.von_mises'; did you mean 'cells.exit.stress.von_mises'?");
    CHECK(told("stress_max") == "--get: no value at 'stress_max'; did you mean 'nozzle.stress_max'?");
    CHECK(contains(told("cells.exit.weight"), "'cells.exit' has place, model, "));
    CHECK(told("cells.exit.stress.von_mises").empty());
}

TEST_CASE("check: a place no answer has is a mistake and one that others have is a missing value") {
    const Json full = answer();
    const Check typo = parse_check("nozzle.stres_max<2", "--check");
    CHECK_THROWS_AS(evaluate(typo, full, "--check", false), UsageError);
    const Check far = parse_check("cells.30.stress.von_mises<2kPa", "--check");
    CHECK_FALSE(evaluate(far, full, "--check", false).holds);
    CHECK_THROWS_AS(evaluate(far, full, "--check", true), UsageError);
    CHECK_THROWS_AS(evaluate(parse_check("cells.0.model<2", "--check"), full, "--check", true), UsageError);
    CHECK_THROWS_AS(evaluate(parse_check("nozzle<2", "--check"), full, "--check", true), UsageError);
}
