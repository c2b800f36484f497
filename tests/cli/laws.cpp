#include <doctest/doctest.h>

#include <string>

#include "cli/command.hpp"
#include "support/text.hpp"

using namespace bioprint::test;
using bioprint::testing::contains;

namespace {

const std::string yielding =
    "--law herschel-bulkley --yield-stress 60Pa --consistency 79Pa.s^n --flow-index 0.4 ";

}  // namespace

TEST_CASE("laws: every law answers on the command line") {
    for (const char* law :
         {"--law cross --eta0 2Pa.s", "--law power-law --consistency 30Pa.s^n --flow-index 0.46",
          "--law carreau-yasuda --eta0 50 --time-constant 0.7 --flow-index 0.3", "--ink ama-25C",
          "--ink gelma-ijb", "--ink alginate-2.5-25C-pl"}) {
        CAPTURE(law);
        const Outcome outcome = run(std::string(law) + " --population --profile 5 --json");
        CHECK(outcome.status == 0);
        CHECK_FALSE(contains(outcome.out, "nan"));
        CHECK_FALSE(contains(outcome.out, ": inf"));
    }
    CHECK(run("-q " + yielding + "--get input.ink.law").out == "herschel-bulkley\n");
    CHECK(contains(run(yielding).out, "radius of the plug"));
}

TEST_CASE("laws: a load below the yield stress is refused with the one that flows") {
    const Outcome gradient = run(yielding + "--pressure-gradient 1MPa/m");
    CHECK(gradient.status == 3);
    CHECK(contains(gradient.err, "it flows above a pressure gradient of 2.4e+06 Pa/m"));
    const Outcome pressure = run(yielding + "--pressure 10kPa --length 10mm");
    CHECK(pressure.status == 3);
    CHECK(contains(pressure.err, "it flows above 2.4e+04 Pa"));
    CHECK(run(yielding + "--pressure 25kPa --length 10mm -q").status == 0);
    CHECK(run(yielding + "--flowrate 0 -q").status == 0);
}

TEST_CASE("laws: a wrong combination of law and parameters is named with its remedy") {
    const auto refusal = [](const std::string& call) {
        const Outcome outcome = run(call);
        CHECK(outcome.status == 2);
        return outcome.err;
    };
    CHECK(contains(
        refusal("--consistency 3"),
        "--consistency: the cross law has no such parameter; it takes eta0, eta-inf, time-constant, alpha, "
        "and --law chooses another law"));
    CHECK(contains(refusal("--law power-law --flow-index 0.4"),
                   "--law: the power-law law needs --consistency too"));
    CHECK(
        contains(refusal("--law bingham"), "it takes cross, power-law, carreau-yasuda or herschel-bulkley"));
    CHECK(contains(refusal("--ink ama-25C --law power-law"),
                   "follows the herschel-bulkley law, not power-law"));
    CHECK(contains(refusal("--law power-law --consistency 3 --flow-index 0"),
                   "--flow-index: got 0; it must be above 0"));
    CHECK(contains(refusal("--ink ama-25C --simulate=exit-flow --fidelity draft"),
                   "--simulate: knows inks by the Cross law only"));
}

TEST_CASE("laws: what an answer says of its ink is a question again") {
    const std::string question =
        R"({"ink": {"name": "power-law", "law": "power-law", "consistency": 30, "flow_index": 0.46}})";
    const Outcome again = run("--batch - -q --get nozzle.stress_max", question + "\n");
    CHECK(again.status == 0);
    CHECK(again.out ==
          run("-q --law power-law --consistency 30 --flow-index 0.46 --get nozzle.stress_max").out);
}

TEST_CASE("laws: a row's law replaces the ink of the call") {
    const Outcome outcome = run("--ink ama-25C --batch - -q --get input.ink.law",
                                "law,consistency,flow-index\npower-law,3,0.4\n");
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "power-law\n");
}
