#include "bioprint/predict/ladder.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace bioprint;

namespace {

const RungVerdict& verdict(const RungChoice& choice, Rung rung) {
    return *std::find_if(choice.ladder.begin(), choice.ladder.end(),
                         [&](const auto& v) { return v.rung == rung; });
}

}  // namespace

TEST_CASE("ladder: a record exists for every model of the moderate cell at the exit") {
    for (const Rung rung : {Rung::steady, Rung::ellipsoid, Rung::draft, Rung::standard, Rung::fine}) {
        const RungRecord* record = measured(QuestionKind::exit, rung, 0.5);
        CAPTURE(std::string(name_of(rung)));
        REQUIRE(record != nullptr);
        CHECK(record->time > 0.0);
        CHECK(record->longest >= record->time);
        CHECK(record->questions > record->unjudged);
    }
}

TEST_CASE("ladder: errors fall and times rise from draft to fine") {
    for (const QuestionKind kind : {QuestionKind::exit_flow, QuestionKind::channel, QuestionKind::exit}) {
        for (const auto& [coarse, fine] :
             {std::pair{Rung::draft, Rung::standard}, {Rung::standard, Rung::fine}}) {
            const RungRecord* a = measured(kind, coarse, 0.0);
            const RungRecord* b = measured(kind, fine, 0.0);
            REQUIRE(a != nullptr);
            REQUIRE(b != nullptr);
            CHECK(b->error < a->error);
            CHECK(b->time > a->time);
        }
    }
}

TEST_CASE("ladder: a tolerance takes the cheapest model within it") {
    for (const double tolerance : {1e-3, 1e-2, 0.05, 0.1, 0.5}) {
        const RungChoice choice =
            choose_rung({.kind = QuestionKind::exit, .load = 0.05, .tolerance = tolerance, .budget = {}});
        CAPTURE(tolerance);
        if (!choice.met) {
            for (const RungVerdict& v : choice.ladder) CHECK((!v.error || *v.error > tolerance));
            continue;
        }
        CHECK(*verdict(choice, choice.rung).error <= tolerance);
        for (const RungVerdict& v : choice.ladder) {
            if (v.rung == choice.rung) break;
            CHECK((!v.error || *v.error > tolerance));
        }
    }
}

TEST_CASE("ladder: a budget takes the most accurate model within it and never a dearer one") {
    for (const double budget : {1e-3, 0.1, 1.0, 10.0, 1e3}) {
        const RungChoice choice =
            choose_rung({.kind = QuestionKind::exit, .load = 0.05, .tolerance = {}, .budget = budget});
        CAPTURE(budget);
        REQUIRE(choice.met);
        const RungVerdict& taken = verdict(choice, choice.rung);
        CHECK(*taken.time <= budget);
        for (const RungVerdict& v : choice.ladder) {
            if (v.affordable && v.error) CHECK(*v.error >= *taken.error);
        }
    }
}

TEST_CASE("ladder: what was never measured has no error") {
    CHECK_FALSE(expected_error(QuestionKind::exit, Rung::steady, -1.0));
    const RungChoice choice =
        choose_rung({.kind = QuestionKind::exit, .load = 0.05, .tolerance = 1e-9, .budget = {}});
    CHECK_FALSE(choice.met);
}
