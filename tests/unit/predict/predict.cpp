#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/predict/prediction.hpp"

using namespace bioprint;

namespace {

/// The paper's case: R 50 µm, 5 mm/s, η0 10 Pa s, K 0.05 s, α 0.75, cell of 8 µm and 1 kPa.
Case paper_case(double alpha = 0.75) {
    return {
        .radius = 50e-6,
        .length = std::nullopt,
        .drive = Drive::velocity,
        .drive_value = 5e-3,
        .ink = {.name = "test", .source = "", .law = {.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha}},
        .cell = {.name = "test", .source = "", .radius = 8e-6, .shear_modulus = 1e3},
        .positions = {},
        .needle = std::nullopt};
}

bool warns(const Prediction& prediction, const std::string& code) {
    return std::any_of(prediction.warnings.begin(), prediction.warnings.end(),
                       [&](const Warning& warning) { return warning.code == code; });
}

const CellAnswer& exit_cell(const Prediction& prediction) {
    return *std::find_if(prediction.cells.begin(), prediction.cells.end(),
                         [](const CellAnswer& cell) { return cell.place == Place::exit; });
}

}  // namespace

TEST_CASE("predict: without positions the paper's four are answered as far as they fit") {
    const Prediction wide = predict(paper_case());
    REQUIRE(wide.question.positions.size() == 4);
    CHECK(wide.question.positions[3].value == doctest::Approx(36e-6).epsilon(1e-14));
    // The centred one in the nozzle, and at the exit by both models; the others in the nozzle by both and at
    // the exit in time.
    CHECK(wide.cells.size() == 12);
    CHECK(wide.passages.size() == 4);

    Case narrow = paper_case();
    narrow.radius = 25e-6;
    CHECK(predict(narrow).question.positions.size() == 2);  // 3 R_c + R_c = 32 µm is too far
}

TEST_CASE("predict: the steady theory gives 667 Pa and 2113 Pa at the exit of the paper's nozzle") {
    // The figures of an independent evaluation; four digits were kept.
    CHECK(exit_cell(predict(paper_case(0.75))).stress->von_mises == doctest::Approx(667).epsilon(1e-3));
    CHECK(exit_cell(predict(paper_case(0.0))).stress->von_mises == doctest::Approx(2113).epsilon(1e-3));
}

TEST_CASE("predict: every shape keeps the cell's volume") {
    for (const double alpha : {0.0, 0.3, 0.75, 0.95}) {
        for (const CellAnswer& cell : predict(paper_case(alpha)).cells) {
            const auto& a = cell.stretch.value();
            CHECK(a[0] * a[1] * a[2] == doctest::Approx(1.0).epsilon(1e-12));
        }
    }
}

TEST_CASE("predict: the load of a cell is the stress of the ink whatever the ink") {
    // Two inks at one pressure gradient load the cell alike (the paper's central finding).
    Case question = paper_case(0.0);
    question.drive = Drive::pressure_gradient;
    question.drive_value = 2e7;
    const Prediction newtonian = predict(question);
    question.ink.law.alpha = 0.75;
    const Prediction thinning = predict(question);
    CHECK(newtonian.cells[6].stress->von_mises ==
          doctest::Approx(thinning.cells[6].stress->von_mises).epsilon(1e-12));
}

TEST_CASE(
    "predict: past the turning point there is no shape and the warning names load and limit and flow rate") {
    Case question = paper_case(0.0);
    question.drive_value = 7e-3;  // the Newtonian ink's last steady shape is at 6 mm/s
    const Prediction prediction = predict(question);
    CHECK_FALSE(exit_cell(prediction).stress.has_value());
    REQUIRE(warns(prediction, "no_steady_shape"));
    const auto warning = std::find_if(prediction.warnings.begin(), prediction.warnings.end(),
                                      [](const Warning& w) { return w.code == "no_steady_shape"; });
    CHECK(warning->message.find("606.2 Pa") != std::string::npos);
    CHECK(warning->message.find("496.2 Pa") != std::string::npos);
    CHECK(warning->message.find("mm/s") != std::string::npos);
    // At the named flow rate the load is the limit.
    question.drive_value = 5.7296e-3;
    CHECK(exit_cell(predict(question)).fluid_stress == doctest::Approx(496.2).epsilon(1e-4));
}

TEST_CASE("predict: where no steady shape exists the ellipsoid carried in time has one") {
    Case question = paper_case(0.0);
    question.drive_value = 7e-3;
    const Prediction prediction = predict(question);
    const CellAnswer& carried = prediction.cells.at(2);
    CHECK(carried.model == Model::ellipsoid);
    CHECK(carried.stress->von_mises > 1000.0);
    CHECK(carried.stress->von_mises < 2000.0);
    question.transient = false;
    const Prediction steady = predict(question);
    CHECK(steady.cells.size() == 5);
    CHECK(steady.passages.empty());
}

TEST_CASE("predict: a slow print of a stiff cell is the same by the steady theory and in time") {
    // Small in every way: slow against the cell's response, so both theories see the same passing load but
    // for its peak, which is 1.4 to 1.7 times the average that the steady theory takes.
    Case question = paper_case(0.0);
    question.cell.shear_modulus = 1e6;
    question.cell.radius = 1e-6;
    const Prediction prediction = predict(question);
    const double steady = prediction.cells.at(1).stress->von_mises;
    const double carried = prediction.cells.at(2).stress->von_mises;
    // Finite elements: the peak is 1.743 times the estimate.
    CHECK(carried / steady == doctest::Approx(1.743).epsilon(2e-3));
}

TEST_CASE("predict: a length adds pressure drop and residence time") {
    Case question = paper_case();
    CHECK_FALSE(predict(question).nozzle.pressure_drop.has_value());
    question.length = 10e-3;
    const Prediction prediction = predict(question);
    CHECK(*prediction.nozzle.pressure_drop == doctest::Approx(10e-3 * prediction.nozzle.pressure_gradient));
    CHECK(*prediction.nozzle.residence_time == doctest::Approx(2.0).epsilon(1e-14));
    question.drive = Drive::pressure;
    question.drive_value = *prediction.nozzle.pressure_drop;
    CHECK(predict(question).nozzle.velocity_average == doctest::Approx(5e-3).epsilon(1e-12));
}

TEST_CASE("predict: the profile runs from the axis to the wall") {
    Case question = paper_case();
    question.profile_points = 11;
    const Prediction prediction = predict(question);
    const RadialProfile& profile = *prediction.profile;
    CHECK(profile.r.front() == 0.0);
    CHECK(profile.r.back() == question.radius);
    CHECK(profile.velocity.front() == prediction.nozzle.velocity_max);
    CHECK(profile.velocity.back() == 0.0);
    CHECK(profile.stress.back() == prediction.nozzle.stress_max);
    CHECK(std::is_sorted(profile.velocity.rbegin(), profile.velocity.rend()));
    CHECK(profile.viscosity.front() == 10.0);
}

TEST_CASE("predict: results outside the checked range carry a warning") {
    CHECK(warns(predict(paper_case()), "near_wall"));  // 36 + 2·8 > 50 µm

    Case near_axis = paper_case();
    near_axis.positions = {{4e-6}};
    CHECK(warns(predict(near_axis), "near_axis"));

    Case large = paper_case();
    large.cell.radius = 20e-6;
    CHECK(warns(predict(large), "large_cell"));

    Case soft = paper_case();
    soft.cell.shear_modulus = 50.0;
    CHECK(warns(predict(soft), "stress_ratio"));
    CHECK(warns(predict(soft), "bullet_range"));

    Case plug = paper_case(0.95);
    plug.drive_value = 1.0;
    CHECK(warns(predict(plug), "plug_flow"));

    Case metres = paper_case();
    metres.radius = 50.0;
    CHECK(warns(predict(metres), "suspicious_size"));

    Case tapered = paper_case();
    tapered.needle = NeedleChoice{.name = "25G tapered", .source = "", .remark = "", .tapered = true};
    CHECK(warns(predict(tapered), "tapered_tip"));

    Case fast = paper_case();
    fast.ink.law.eta0 = 1e-3;
    fast.drive_value = 1.0;
    CHECK(warns(predict(fast), "inertia"));

    Case slow = paper_case();
    slow.drive_value = 1e-5;
    slow.positions = {{24e-6}};
    CHECK(predict(slow).warnings.empty());
}

TEST_CASE("predict: every problem of a case is told at once") {
    Case question = paper_case();
    question.radius = -1.0;
    question.ink.law.eta0 = 0.0;
    question.ink.law.alpha = -0.5;
    question.cell.poisson_ratio = 0.5;
    CHECK(problems_of(question).size() == 4);
    CHECK_THROWS_AS(predict(question), UsageError);

    Case outside = paper_case();
    outside.positions = {{45e-6}};
    CHECK(problems_of(outside).size() == 1);
    outside.positions = {{5.0, true}, {5.3, true}};  // 42.4 + 8 > 50 µm
    CHECK(problems_of(outside).size() == 1);
    Case touching = paper_case();
    touching.positions = {{42e-6}};
    CHECK(problems_of(touching).empty());
}

TEST_CASE("predict: a nozzle at rest loads no cell") {
    Case question = paper_case();
    question.drive_value = 0.0;
    const Prediction prediction = predict(question);
    for (const CellAnswer& cell : prediction.cells) {
        CHECK(cell.stress->von_mises == 0.0);
        CHECK(cell.stretch->at(0) == 1.0);
    }
}

TEST_CASE("predict: off the axis the settled ellipsoid is Roscoe's but for what the size adds") {
    const Prediction p = predict(paper_case(0.3));
    for (std::size_t i = 3; i < 12; i += 3) {
        const CellAnswer& steady = p.cells.at(i);
        const CellAnswer& nozzle = p.cells.at(i + 1);
        const CellAnswer& exit = p.cells.at(i + 2);
        CHECK(steady.model == Model::roscoe_shear);
        CHECK(nozzle.model == Model::ellipsoid);
        CHECK(nozzle.place == Place::nozzle);
        CHECK(exit.place == Place::exit);
        CHECK(nozzle.offset == steady.offset);
        for (std::size_t k = 0; k < 3; ++k) {
            CHECK(nozzle.stretch->at(k) == steady.stretch->at(k));
            CHECK(nozzle.stress->elastic.at(k) == steady.stress->elastic.at(k));
        }
        CHECK(*nozzle.angle == *steady.angle);
        CHECK(*nozzle.frequency == *steady.frequency);
        // The bullet's part fades off the axis: 6 % at 1.5 R_c, less than 1 % at 4.5 R_c.
        CHECK(nozzle.stress->von_mises > steady.stress->von_mises);
        CHECK(nozzle.stress->von_mises < 1.06 * steady.stress->von_mises);
        CHECK(*exit.relaxation_time > 0.0);
    }
}

TEST_CASE("predict: the passage names the largest stress on the way and whether the nozzle is long enough") {
    Case question = paper_case();
    question.length = 12.7e-3;
    const Prediction p = predict(question);
    CHECK(p.passages.at(0).place == Place::exit);
    CHECK(p.passages.at(0).von_mises == doctest::Approx(p.cells.at(2).stress->von_mises).epsilon(1e-3));
    CHECK(*p.passages.at(0).position > 0.0);
    CHECK(p.passages.at(3).place == Place::nozzle);
    CHECK(*p.passages.at(3).position < -12e-3);  // soon after the entrance: the overshoot
    CHECK(p.passages.at(3).nozzle_peak > p.passages.at(3).nozzle_steady);
    for (const PassageAnswer& way : p.passages) CHECK(*way.settles);
    CHECK_FALSE(warns(p, "unsettled"));

    question.length = 0.4e-3;
    const Prediction brief = predict(question);
    CHECK(warns(brief, "unsettled"));
    CHECK_FALSE(*brief.passages.at(1).settles);
    CHECK_FALSE(brief.passages.at(1).settling_time.has_value());
    CHECK(brief.cells.at(3).applies == false);
    CHECK(p.cells.at(6).applies == true);
}

TEST_CASE("predict: a steady entry says whether its assumptions hold") {
    Case question = paper_case();
    question.positions = {{0.0}, {4e-6}, {24e-6}, {40e-6}};
    const Prediction p = predict(question);
    CHECK(p.cells.at(0).applies == true);   // G R_c/μ = 0.14
    CHECK(p.cells.at(1).applies == false);  // fast
    CHECK_FALSE(p.cells.at(2).applies.has_value());
    CHECK(p.cells.at(3).applies == false);  // near the axis
    CHECK(p.cells.at(6).applies == true);
    CHECK(p.cells.at(9).applies == false);  // near the wall
}
