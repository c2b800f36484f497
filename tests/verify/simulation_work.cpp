#include "bioprint/simulate/work.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/trade_questions.hpp"
#include "bioprint/predict/comparison.hpp"

// The time of a simulation, known before it runs, against the times measured for data/trade.json.

using namespace bioprint;

namespace {

nlohmann::json measured_questions() {
    std::ifstream file(BIOPRINT_SOURCE_DIR "/data/trade.json");
    return nlohmann::json::parse(file)["questions"];
}

Scene scene_of(const trade::Question& question) {
    Case asked = question.to_case();
    asked.transient = false;
    const Prediction prediction = predict(asked);
    return scene_for(prediction,
                     {.kind = question.kind->scene, .offset = prediction.question.positions.front().value});
}

Scene channel() {
    return {.kind = SceneKind::channel,
            .ink = {.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = 0.5},
            .nozzle_radius = 50e-6,
            .velocity_average = 5e-3,
            .cell = {.radius = 8e-6, .shear_modulus = 1e3}};
}

}  // namespace

TEST_CASE("simulation work: every measured run took between the least and the most time expected of it") {
    const nlohmann::json measured = measured_questions();
    int runs = 0;
    for (const trade::Question& question : trade::questions()) {
        for (const nlohmann::json& entry : measured) {
            if (entry["label"] != question.label()) continue;
            for (const auto& [rung, resolution] :
                 {std::pair{"draft", 3.0}, {"standard", 6.0}, {"fine", 12.0}}) {
                if (!entry["rungs"].contains(rung) || !entry["rungs"][rung].contains("cpu")) continue;
                const double time = entry["rungs"][rung]["cpu"];
                const SimulationWork work = expected_work(scene_of(question), {.resolution = resolution});
                CAPTURE(question.label());
                CAPTURE(std::string(rung));
                CHECK(work.least < time);
                CHECK(time < work.most);
                ++runs;
            }
        }
    }
    CHECK(runs > 100);
}

TEST_CASE("simulation work: a given time in the nozzle is what it takes") {
    const SimulationWork short_time = expected_work(channel(), {.channel_time = 0.02});
    const SimulationWork long_time = expected_work(channel(), {.channel_time = 0.2});
    CHECK(long_time.least / short_time.least == doctest::Approx(10.0).epsilon(0.05));
    CHECK(long_time.most / short_time.most == doctest::Approx(10.0).epsilon(0.1));
}

TEST_CASE("simulation work: a smaller cell in the same nozzle takes more time and memory") {
    Scene small = channel();
    small.cell.radius = 1e-6;
    const SimulationWork usual = expected_work(channel());
    const SimulationWork finer = expected_work(small);
    CHECK(finer.least > 20.0 * usual.least);
    CHECK(finer.memory > 10.0 * usual.memory);
}

TEST_CASE("simulation work: what the run would refuse is refused") {
    Scene wide = channel();
    wide.cell.radius = 40e-6;
    CHECK_THROWS_AS(check_scene(wide), UsageError);
    CHECK_THROWS_AS(expected_work(wide), UsageError);
    Scene slow = channel();
    slow.velocity_average = 1e-6;
    slow.cell.shear_modulus = 1e6;
    CHECK_THROWS_AS(check_scene(slow), UsageError);
    Scene beside = channel();
    beside.offset = 24e-6;
    CHECK_NOTHROW(check_scene(beside));
    CHECK_THROWS_AS(check_scene(beside, {.resolution = 41.0}), UsageError);
    beside.offset = 41e-6;
    CHECK_THROWS_AS(check_scene(beside), UsageError);
}
