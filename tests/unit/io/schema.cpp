#include "support/schema.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

using bioprint::testing::schema_violations;
using Json = nlohmann::json;

namespace {

/// The smallest complete answer.
Json answer() {
    return Json::parse(R"({
        "schema": "bioprint-predict/1", "program": {"name": "bioprint-predict", "version": "1.0.0"},
        "input": {"radius": 5e-5, "length": null, "flow_rate": 3.9e-11,
                  "ink": {"name": "a", "source": "b", "law": "cross", "eta0": 10, "eta_inf": 0, "time_constant": 0.05, "alpha": 0.75},
                  "cell": {"name": "c", "source": "d", "radius": 8e-6, "shear_modulus": 1000, "poisson_ratio": 0.48,
                           "viscosity_ratio": 1},
                  "offsets": [0, 1.2e-5]},
        "nozzle": {"flow_rate": 3.9e-11, "pressure_gradient": 1.7e7, "velocity_average": 0.005, "velocity_max": 0.008,
                   "shear_rate_max": 500, "shear_rate_average": 300, "stress_max": 436, "stress_average": 290,
                   "viscosity_wall": 1, "pressure_drop": null, "residence_time": null, "error": 1e-14},
        "exit": {"elongation_rate": 30, "elongational_stress": 100, "error": 0.2},
        "cells": [{"place": "exit", "model": "roscoe-elongation", "offset": 0, "offset_in_cell_radii": 0,
                   "fluid_stress": 1, "stress_ratio": 1e-3, "stretch": [null, null, null], "angle": null,
                   "frequency": null, "stress": {"von_mises": null, "elastic": [1, 2, 3], "viscous": null},
                   "relaxation_time": 0.01, "error": null, "strain_error": null}],
        "warnings": [{"code": "x", "message": "y"}]})");
}

Json failure() {
    return Json::parse(R"({"schema": "bioprint-predict/1",
        "error": {"code": "usage", "message": "--radius: got '5s'", "option": "--radius"}})");
}

Json data_file(const std::string& name) {
    return Json::parse(std::ifstream(std::string(BIOPRINT_SOURCE_DIR) + "/data/" + name));
}

}  // namespace

TEST_CASE("schema: a complete answer and a failed row and a list of them are valid") {
    CHECK(schema_violations(answer(), "answer").empty());
    CHECK(schema_violations(failure(), "answer").empty());
    CHECK(schema_violations(Json::array({answer(), failure()}), "answer").empty());
    CHECK(schema_violations(Json::array(), "answer").empty());
}

TEST_CASE("schema: a missing member or one too many is a violation at every level") {
    for (const auto* path : {"", "/input", "/input/ink", "/input/cell", "/nozzle", "/exit", "/cells/0",
                             "/cells/0/stress", "/program", "/warnings/0"}) {
        CAPTURE(path);
        const Json::json_pointer place(path);
        auto more = answer();
        more[place]["extra"] = 1;
        CHECK_FALSE(schema_violations(more, "answer").empty());
        const Json members = answer()[place];
        for (const auto& member : members.items()) {
            if (member.key() == "relaxation_time") continue;  // the one that may be absent
            CAPTURE(member.key());
            auto fewer = answer();
            fewer[place].erase(member.key());
            CHECK_FALSE(schema_violations(fewer, "answer").empty());
        }
    }
}

TEST_CASE("schema: wrong values are violations") {
    const auto with = [](const char* path, const Json& value) {
        auto document = answer();
        document[Json::json_pointer(path)] = value;
        return schema_violations(document, "answer");
    };
    CHECK_FALSE(with("/input/radius", nullptr).empty());
    CHECK_FALSE(with("/input/radius", 0).empty());
    CHECK_FALSE(with("/nozzle/stress_max", "436").empty());
    CHECK_FALSE(with("/cells/0/stretch", Json::array({1, 2})).empty());
    CHECK_FALSE(with("/cells/0/model", "guess").empty());
    CHECK_FALSE(with("/schema", "bioprint-predict/2").empty());
    CHECK_FALSE(with("/error", Json::object()).empty());
    CHECK(with("/nozzle/pressure_drop", 1e5).empty());
    CHECK_FALSE(schema_violations(Json(3), "answer").empty());
}

TEST_CASE("schema: the preset files are valid and a misspelt member is not") {
    for (const std::string name : {"inks", "cells", "nozzles"}) {
        auto document = data_file(name + ".json");
        CHECK(schema_violations(document, name) == "");
        document[name][0]["sorce"] = "x";
        CHECK_FALSE(schema_violations(document, name).empty());
    }
}
