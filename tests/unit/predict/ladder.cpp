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

namespace {

RungRequest simulation_of(QuestionKind kind, std::optional<double> tolerance, std::optional<double> budget) {
    return {.kind = kind, .load = 0.5, .tolerance = tolerance, .budget = budget, .simulated = true};
}

void refuse(RungRequest& request, Rung rung) {
    request.outlook.at(static_cast<std::size_t>(rung)).refused = "no";
}

}  // namespace

TEST_CASE("ladder: a simulation within a budget is the most accurate one that fits") {
    for (const auto& [budget, rung] :
         {std::pair{1.0, Rung::draft}, {10.0, Rung::standard}, {60.0, Rung::fine}}) {
        const RungChoice choice = choose_rung(simulation_of(QuestionKind::channel, {}, budget));
        CAPTURE(budget);
        CHECK(choice.rung == rung);
        CHECK(choice.met);
    }
}

TEST_CASE("ladder: where no simulation is within the budget the cheapest is taken and the wish is not met") {
    for (const std::optional<double>& tolerance : {std::optional<double>(), std::optional(0.03)}) {
        const RungChoice choice = choose_rung(simulation_of(QuestionKind::channel, tolerance, 1e-3));
        CHECK(choice.rung == Rung::draft);
        CHECK_FALSE(choice.met);
    }
}

TEST_CASE("ladder: a tolerance out of reach takes the most accurate simulation within the budget") {
    const RungChoice choice = choose_rung(simulation_of(QuestionKind::exit, 0.005, 60.0));
    CHECK_FALSE(choice.met);
    const RungVerdict& taken = verdict(choice, choice.rung);
    REQUIRE(taken.error);
    for (const Rung rung : {Rung::draft, Rung::standard, Rung::fine}) {
        const RungVerdict& other = verdict(choice, rung);
        if (other.affordable && other.error) CHECK(*other.error >= *taken.error);
    }
    CHECK(resolution_of(choice.rung) > 0.0);
}

TEST_CASE("ladder: a simulation of unknown error is the standard one and the finest that a budget allows") {
    RungRequest request = simulation_of(QuestionKind::channel, 0.05, {});
    request.measured = false;
    CHECK(choose_rung(request).rung == Rung::standard);
    request = simulation_of(QuestionKind::channel, {}, 10.0);
    request.measured = false;
    CHECK(choose_rung(request).rung == Rung::standard);
    request.budget = 60.0;
    CHECK(choose_rung(request).rung == Rung::fine);
}

TEST_CASE("ladder: a model that cannot follow the question is not taken") {
    RungRequest request{.kind = QuestionKind::exit, .load = 0.5, .tolerance = 0.05, .budget = {}};
    CHECK(choose_rung(request).rung == Rung::standard);
    refuse(request, Rung::standard);
    CHECK(choose_rung(request).rung == Rung::fine);
    CHECK(choose_rung(request).met);
    refuse(request, Rung::fine);
    refuse(request, Rung::draft);
    const RungChoice choice = choose_rung(request);
    CHECK(choice.rung == Rung::ellipsoid);
    CHECK_FALSE(choice.met);
    request.simulated = true;
    CHECK(choose_rung(request).rung == Rung::standard);  // whose run says why it cannot
    CHECK_FALSE(choose_rung(request).met);
}

TEST_CASE("ladder: outside what was measured no error is known and the ellipsoid answers") {
    const RungRequest request{
        .kind = QuestionKind::exit, .load = 0.5, .tolerance = 0.5, .budget = {}, .measured = false};
    const RungChoice choice = choose_rung(request);
    CHECK(choice.rung == Rung::ellipsoid);
    CHECK_FALSE(choice.met);
    for (const RungVerdict& v : choice.ladder) CHECK_FALSE(v.error);
}

TEST_CASE("ladder: the time expected of this question goes before the longest of its kind") {
    RungRequest request = simulation_of(QuestionKind::channel, {}, 10.0);
    request.outlook.at(static_cast<std::size_t>(Rung::fine)).time = 5.0;
    CHECK(choose_rung(request).rung == Rung::fine);
    request.outlook.at(static_cast<std::size_t>(Rung::fine)).time = 50.0;
    request.outlook.at(static_cast<std::size_t>(Rung::standard)).time = 20.0;
    CHECK(choose_rung(request).rung == Rung::draft);
}
