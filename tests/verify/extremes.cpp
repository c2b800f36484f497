#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <string>

#include "bench/extreme_runs.hpp"

using namespace bioprint::extremes;

// Some scenes of the campaign of tests/bench/extremes.cpp, put to the real program.

TEST_CASE("extremes: every scene ends in an answer within its error or in a refusal that names an option") {
    std::map<Verdict, int> counts;
    for (const ExtremeScene& scene : few_extreme_scenes()) {
        // Some ten times what the slowest takes.
        const Outcome outcome = ask(scene, false, {.seconds = 60.0});
        CAPTURE(scene.number);
        CAPTURE(scene.kind);
        CAPTURE(std::string(name_of(outcome.verdict)));
        CAPTURE(outcome.quantity);
        CAPTURE(outcome.remark);
        CAPTURE(outcome.deviation);
        CHECK(is_sound(outcome.verdict));
        ++counts[outcome.verdict];
    }
    CHECK(counts[Verdict::within] >= 6);
    CHECK(counts[Verdict::unjudged] >= 3);
    CHECK(counts[Verdict::refused] >= 8);
}

TEST_CASE("extremes: the Poisson ratio of a cell changes nothing in its simulation") {
    ExtremeScene scene = few_extreme_scenes().back();
    const Outcome one = ask(scene, false, {});
    scene.poisson = 0.3;
    const Outcome other = ask(scene, false, {});
    const auto values = [](const std::string& answer) {
        const std::size_t begin = answer.find("\"simulated\"");
        REQUIRE(begin != std::string::npos);
        return answer.substr(begin, answer.find('}', begin) - begin);
    };
    CHECK(values(one.ended.out) == values(other.ended.out));
}

TEST_CASE("extremes: what comes back is told apart by how the process ended") {
    const auto with_program = [](const char* program) {
        return ask(few_extreme_scenes().front(), false, {.program = program}).verdict;
    };
    CHECK(with_program("/bin/true") == Verdict::not_a_number);  // status 0 without an answer
    CHECK(with_program("/bin/false") == Verdict::crashed);
    CHECK(with_program("/nowhere") == Verdict::crashed);
}
