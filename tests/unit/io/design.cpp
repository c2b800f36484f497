#include "io/design.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bioprint/errors.hpp"
#include "io/answer_checks.hpp"

using namespace bioprint;

namespace {

/// What the limits say of a prediction made afresh at a value.
std::vector<CheckResult> judged(const DesignQuestion& question, const Settings& base, double value) {
    Case asked = with_value(base, question.sought, value).make_case();
    asked.population = needs_population(question.limits);
    const Json answer = answer_object(predict(asked));
    std::vector<CheckResult> results;
    for (const Check& limit : question.limits) results.push_back(evaluate(limit, answer, "--limit", false));
    return results;
}

bool all_hold(const std::vector<CheckResult>& results) {
    for (const CheckResult& result : results) {
        if (!result.holds) return false;
    }
    return true;
}

Check limit(const std::string& text) {
    return parse_check(text, "--limit");
}

Settings settings(std::initializer_list<std::pair<Key, const char*>> values) {
    Settings result;
    for (const auto& [key, text] : values) result.set(key, text, "--" + std::string(info_of(key).option));
    return result;
}

constexpr double ordinary_tolerance = 1e-8;  // ten times that of the search

}  // namespace

TEST_CASE("design: a Newtonian ink has the flow rate of Hagen and Poiseuille at the wall stress asked for") {
    // alpha 0 is a Newtonian ink of eta0/2: stress 4 (eta0/2) Q / (pi R^3).
    const Settings base = settings({{Key::alpha, "0"}, {Key::eta0, "10Pa.s"}, {Key::radius, "100um"}});
    const Design design =
        solve_design({.sought = Key::flow_rate, .limits = {limit("nozzle.stress_max<=1kPa")}}, base);
    const double exact = 1000.0 * 3.14159265358979324 * 1e-12 / (4.0 * 5.0);
    CHECK(design.outcome == DesignOutcome::found);
    CHECK(design.largest);
    CHECK(design.value == doctest::Approx(exact).epsilon(1e-8));
    CHECK(design.limits[0].binds);
    CHECK(design.limits[0].by_theory);
}

TEST_CASE("design: the value keeps all limits and the one just beyond breaks one in random questions") {
    std::mt19937_64 random(7);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>(0.0, 1.0)(random));
    };
    constexpr std::array<Key, 4> sought = {Key::flow_rate, Key::velocity, Key::pressure, Key::radius};
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        Settings base;
        const Key key = sought[static_cast<std::size_t>(i) % sought.size()];
        base.set_number(Key::eta0, between(0.5, 300.0), "--eta0");
        base.set_number(Key::time_constant, between(0.01, 1.0), "-K");
        base.set_number(Key::alpha, between(0.05, 0.95), "--alpha");
        base.set_number(Key::length, between(2e-3, 3e-2), "--length");
        if (key == Key::radius) {
            base.set_number(Key::flow_rate, between(1e-12, 1e-9), "--flowrate");
        } else {
            base.set_number(Key::radius, between(50e-6, 400e-6), "--radius");
        }
        base.set(Key::model, "steady", "--model");
        DesignQuestion question{
            .sought = key, .limits = {limit("nozzle.stress_max<1kPa"), limit("nozzle.pressure_drop<=3bar")}};
        question.limits[0].limit = between(10.0, 1e4);
        question.limits[1].limit = between(1e3, 1e6);
        if (i % 3 == 0) question.limits.push_back(limit("nozzle.residence_time>10ms"));
        if (i % 5 == 0) question.limits.push_back(limit("exit.elongational_stress<500Pa"));
        const Design design = solve_design(question, base);
        CAPTURE(i);
        CAPTURE(design.value);
        const std::vector<CheckResult> here = judged(question, base, design.value);
        if (design.outcome == DesignOutcome::impossible) {
            CHECK_FALSE(all_hold(here));
            continue;
        }
        CHECK(all_hold(here));
        CHECK(design.remarks.empty());
        if (design.outcome == DesignOutcome::unlimited) continue;
        ++found;
        REQUIRE(design.beyond);
        CHECK_FALSE(all_hold(judged(question, base, *design.beyond)));
        CHECK(std::abs(std::log(*design.beyond / design.value)) < ordinary_tolerance);
        bool any_binds = false;
        for (const LimitStand& stand : design.limits) {
            any_binds = any_binds || stand.binds;
            if (stand.binds) CHECK(std::abs(*stand.result.margin) < 1e-6 * *stand.result.value);
        }
        CHECK(any_binds);
        CHECK(design.evaluations <= 60);
    }
    CHECK(found > 100);
}

TEST_CASE("design: a limit on the population is kept with some ten predictions") {
    const Settings base = settings({{Key::radius, "100um"}, {Key::length, "10mm"}});
    const DesignQuestion question{
        .sought = Key::flow_rate,
        .limits = {limit("population.p95<1kPa"), limit("nozzle.pressure_drop<3bar")}};
    const Design design = solve_design(question, base);
    CHECK(design.outcome == DesignOutcome::found);
    CHECK(all_hold(judged(question, base, design.value)));
    REQUIRE(design.beyond);
    CHECK_FALSE(all_hold(judged(question, base, *design.beyond)));
    CHECK(design.evaluations <= 20);
}

TEST_CASE("design: at a given flow the smallest radius keeps a stress and at a given pressure the largest") {
    const Design narrow = solve_design({.sought = Key::radius, .limits = {limit("nozzle.stress_max<300Pa")}},
                                       settings({{Key::flow_rate, "1uL/s"}}));
    CHECK(narrow.outcome == DesignOutcome::found);
    CHECK_FALSE(narrow.largest);
    const Design wide = solve_design({.sought = Key::radius, .limits = {limit("nozzle.stress_max<300Pa")}},
                                     settings({{Key::pressure, "1bar"}, {Key::length, "10mm"}}));
    CHECK(wide.outcome == DesignOutcome::found);
    CHECK(wide.largest);
    CHECK(wide.value == doctest::Approx(2.0 * 300.0 * 1e-2 / 1e5).epsilon(1e-8));  // G R/2
}

TEST_CASE("design: limits from both sides bound an interval and contradicting ones leave the closest value") {
    const Settings base = settings({{Key::radius, "100um"}});
    const Design both =
        solve_design({.sought = Key::velocity,
                      .limits = {limit("nozzle.velocity_average>=1mm/s"), limit("nozzle.stress_max<400Pa")}},
                     base);
    CHECK(both.outcome == DesignOutcome::found);
    CHECK(both.largest);
    REQUIRE(both.kept);
    CHECK(both.kept->first == doctest::Approx(1e-3).epsilon(1e-8));
    CHECK(both.kept->second == both.value);
    // 4 mm/s at least and 1 mm/s at most: the same factor from both is 2 mm/s.
    const Design none = solve_design(
        {.sought = Key::velocity,
         .limits = {limit("nozzle.velocity_average>4mm/s"), limit("nozzle.velocity_average<1mm/s")}},
        base);
    CHECK(none.outcome == DesignOutcome::impossible);
    CHECK_FALSE(none.kept);
    CHECK(none.value == doctest::Approx(2e-3).epsilon(2e-4));
}

TEST_CASE("design: when every value keeps the limits the answer is the end of the range") {
    const Settings base = settings({{Key::radius, "100um"}});
    DesignQuestion question{
        .sought = Key::velocity, .limits = {limit("nozzle.stress_max<1MPa")}, .range = {{1e-3, 1e-2}}};
    Design design = solve_design(question, base);
    CHECK(design.outcome == DesignOutcome::unlimited);
    CHECK(design.value == 1e-2);
    question.limits = {limit("nozzle.stress_max<1mPa")};
    design = solve_design(question, base);
    CHECK(design.outcome == DesignOutcome::impossible);
    CHECK(design.value == 1e-3);
}

TEST_CASE("design: where the steady flow ends is where a flow ends that no limit stops") {
    // The stress of this ink has a maximum; past its rate there is no steady flow.
    const Settings base = settings({{Key::alpha, "1.5"}, {Key::radius, "100um"}});
    const Design design =
        solve_design({.sought = Key::velocity, .limits = {limit("nozzle.stress_max<1MPa")}}, base);
    CHECK(design.outcome == DesignOutcome::found);
    CHECK(design.steady_flow_binds);
    CHECK_NOTHROW(predict(with_value(base, Key::velocity, design.value).make_case()));
    REQUIRE(design.beyond);
    CHECK_THROWS_AS(predict(with_value(base, Key::velocity, *design.beyond).make_case()), NoSteadyFlow);
}

TEST_CASE("design: alpha is sought between 0 and 1 and its direction is measured") {
    const Settings base = settings({{Key::radius, "50um"}, {Key::velocity, "5mm/s"}});
    const Design design =
        solve_design({.sought = Key::alpha, .limits = {limit("nozzle.stress_max<1kPa")}}, base);
    CHECK(design.outcome == DesignOutcome::found);
    CHECK_FALSE(design.largest);
    CHECK_FALSE(design.limits[0].by_theory);
    CHECK(design.limits[0].monotone);
    CHECK(design.value > 0.25);
    CHECK(design.value < 0.5);
}

TEST_CASE("design: where a limit turns what the ends of the range say is heard") {
    // The exposure of a print at a given flow rises with the radius and falls again.
    const Settings wide = settings({{Key::flow_rate, "141uL/h"}, {Key::length, "12.7mm"}});
    const DesignQuestion both{
        .sought = Key::radius,
        .limits = {limit("population.exposure.p95<2kPa.s"), limit("nozzle.stress_max<300Pa")}};
    const Design design = solve_design(both, wide);
    CHECK(design.outcome == DesignOutcome::found);
    CHECK_FALSE(design.largest);
    CHECK_FALSE(design.limits[0].monotone);
    CHECK(design.limits[0].binds);
    CHECK(all_hold(judged(both, wide, design.value)));
    CHECK_FALSE(all_hold(judged(both, wide, *design.beyond)));
    // On the small side it is kept as well; the other interval is told of.
    const DesignQuestion exposure{.sought = Key::radius, .limits = {limit("population.exposure.p95<2kPa.s")}};
    const Design small = solve_design(exposure, wide);
    CHECK(small.largest);
    CHECK_FALSE(small.limits[0].monotone);
    CHECK_FALSE(small.remarks.empty());
    // Kept where the search begins, and not at the end nobody went to.
    const DesignQuestion share{.sought = Key::flow_rate,
                               .limits = {limit("population.share_peaking_at_exit<0.2")}};
    const Design flow = solve_design(share, Settings());
    CHECK(flow.outcome == DesignOutcome::found);
    CHECK_FALSE(flow.largest);
    CHECK(all_hold(judged(share, Settings(), flow.value)));
    CHECK_FALSE(all_hold(judged(share, Settings(), *flow.beyond)));
    // Nowhere kept: the closest is that of all places tried.
    const Design none = solve_design(
        {.sought = Key::flow_rate, .limits = {limit("population.share_peaking_at_exit<0.1")}}, Settings());
    CHECK(none.outcome == DesignOutcome::impossible);
    CHECK(*none.limits[0].result.value < 0.2);
}

TEST_CASE("design: a limit without a value anywhere is a mistake of the call") {
    CHECK_THROWS_AS(solve_design({.sought = Key::velocity, .limits = {limit("nozzle.pressure_drop<3bar")}},
                                 settings({{Key::radius, "100um"}})),
                    UsageError);
    CHECK_THROWS_AS(sought_key("colour"), UsageError);
    CHECK_THROWS_AS(parse_range("5um", Key::radius), UsageError);
    CHECK_THROWS_AS(parse_range("9um:5um", Key::radius), UsageError);
    CHECK_THROWS_AS(parse_range("1s:2s", Key::radius), UsageError);
    CHECK(parse_range("10:50um", Key::radius) == std::pair{1e-5, 5e-5});
}
