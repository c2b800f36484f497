#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "cli/command.hpp"
#include "support/schema.hpp"

using bioprint::test::run;
using bioprint::testing::schema_violations;
using nlohmann::json;

TEST_CASE("command: every answer is valid under the schema it names") {
    for (const char* call : {"",
                             "--alpha 0",
                             "--alpha 0 --velocity 5cm/s",
                             "--velocity 0",
                             "--needle 25G",
                             "--needle 27G --tip tapered",
                             "--length 12.7mm --pressure 2bar",
                             "--profile 7",
                             "--offset 0",
                             "--offset 20um,3Rc",
                             "--ink alginate-2-25C",
                             "--ink ama-25C --population --profile 4",
                             "--ink ama-25C --velocity 0",
                             "--ink alginate-2.5-25C-pl --profile 4",
                             "--law carreau-yasuda --eta0 50 --time-constant 0.7 --flow-index 0.3",
                             "--cell hela",
                             "--cell-radius 45um",
                             "--viscosity-ratio 0 --shear-modulus 20",
                             "--radius 6mm",
                             "--model steady",
                             "--population",
                             "--population --length 1cm --threshold 1kPa",
                             "--simulate=channel --fidelity draft",
                             "--simulate=channel --offset 0 --budget 1ms",
                             "--viscosity-ratio 5 --offset 0 --tolerance 5%",
                             "--simulate=exit-flow --resolution 3",
                             "--simulate=shear --fidelity draft",
                             "--simulate=channel --offset 3Rc --channel-time 1ms --fidelity draft"}) {
        CAPTURE(call);
        CHECK(schema_violations(json::parse(run(std::string(call) + " --json").out), "answer") == "");
    }
}

TEST_CASE("command: every plan of a dry run is valid under its schema") {
    for (const char* call : {"", "--alpha 0:0.7:0.1", "--batch -", "--model steady --explain", "--simulate",
                             "--simulate=shear --fidelity draft", "--simulate=exit-flow --alpha 0.9",
                             "--simulate=channel --offset 0 --budget 1ms", "--tolerance 1% --budget 10ms"}) {
        CAPTURE(call);
        const json plan = json::parse(run(std::string("--dry-run --json ") + call).out);
        CHECK(schema_violations(plan, "plan") == "");
    }
}

TEST_CASE("command: rows of a batch and their refusals are valid under the schema") {
    std::istringstream rows(
        run("--batch -",
            "{\"alpha\": 0.3}\n{\"alpha\": 2, \"velocity\": 1}\n{\"radius\": \"5s\"}\n{\"x\": 1}\nbroken\n")
            .out);
    int count = 0;
    for (std::string line; std::getline(rows, line); ++count) {
        CAPTURE(line);
        CHECK(schema_violations(json::parse(line), "answer") == "");
    }
    CHECK(count == 5);
}
