#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/predict/prediction.hpp"

using namespace bioprint;

namespace {

Case case_of(const Ink& ink) {
    return {.radius = 100e-6,
            .length = 10e-3,
            .drive = Drive::velocity,
            .drive_value = 5e-3,
            .ink = {.name = "test", .source = "", .law = ink},
            .cell = {.name = "test", .source = "", .radius = 8e-6, .shear_modulus = 1e3},
            .positions = {},
            .needle = std::nullopt};
}

bool warns(const Prediction& prediction, const std::string& code) {
    return std::any_of(prediction.warnings.begin(), prediction.warnings.end(),
                       [&](const Warning& warning) { return warning.code == code; });
}

const HerschelBulkleyInk yielding{.yield_stress = 60.0, .consistency = 79.0, .flow_index = 0.4};

}  // namespace

TEST_CASE("predict laws: stress loads the cell whatever the law") {
    for (const Ink& ink :
         {Ink(PowerLawInk{.consistency = 30.6, .flow_index = 0.46}),
          Ink(CarreauYasudaInk{.eta0 = 50.0, .time_constant = 0.7, .transition = 2.0, .flow_index = 0.3}),
          Ink(yielding)}) {
        CAPTURE(law_name(ink));
        const Prediction p = predict(case_of(ink));
        for (const CellAnswer& cell : p.cells) {
            if (cell.model != Model::roscoe_shear || cell.fluid_stress <= yield_stress(ink)) continue;
            CHECK(cell.fluid_stress ==
                  doctest::Approx(p.nozzle.stress_max * cell.offset / 100e-6).epsilon(1e-13));
            const EllipsoidState state = roscoe_shear({.fluid_stress = cell.fluid_stress,
                                                       .shear_rate = 1.0,
                                                       .shear_modulus = 1e3,
                                                       .viscosity_ratio = 1.0});
            CHECK(cell.stress->von_mises == doctest::Approx(state.von_mises).epsilon(1e-13));
        }
        const double rate = (p.nozzle.velocity_max - p.nozzle.velocity_average) / 200e-6;
        CHECK(p.exit.elongation_rate == doctest::Approx(rate).epsilon(1e-10));
        CHECK(p.exit.elongational_stress ==
              doctest::Approx(stress(ink, std::sqrt(3.0) * rate)).epsilon(1e-10));
    }
}

TEST_CASE("predict laws: a cell in the plug bears nothing and the answer says what is open") {
    Case question = case_of(yielding);
    question.drive = Drive::pressure_gradient;
    question.drive_value = 2.0 * 120.0 / question.radius;  // twice the yield stress at the wall
    question.positions = {{0.0}, {30e-6}, {90e-6}};
    const Prediction p = predict(question);
    REQUIRE(p.nozzle.plug_radius.has_value());
    REQUIRE(*p.nozzle.plug_radius > 30e-6);
    REQUIRE(*p.nozzle.plug_radius < 90e-6);
    for (const CellAnswer& cell : p.cells) {
        if (cell.place != Place::nozzle || cell.model == Model::ellipsoid) continue;
        const bool inside = cell.offset < 50e-6;
        CHECK((cell.stress->von_mises == 0.0) == inside);
        if (inside && cell.offset > 0.0) {
            CHECK(cell.fluid_stress == doctest::Approx(p.nozzle.stress_max * 0.3).epsilon(1e-12));
            CHECK_FALSE(cell.angle.has_value());
            CHECK_FALSE(cell.frequency.has_value());
        }
    }
    CHECK(warns(p, "in_plug"));
    CHECK(warns(p, "plug_exit"));
    CHECK(warns(p, "no_rest_viscosity"));
    for (const CellAnswer& cell : p.cells) CHECK_FALSE(cell.relaxation_time.has_value());
}

TEST_CASE("predict laws: a pressure below the yield stress is refused with the one that flows") {
    Case question = case_of(yielding);
    question.drive = Drive::pressure;
    question.drive_value = 11.9e3;
    CHECK_THROWS_WITH_AS(predict(question), doctest::Contains("it flows above 1.2e+04 Pa"), NoSteadyFlow);
    question.drive_value = 12.1e3;
    CHECK(predict(question).nozzle.flow_rate > 0.0);
    question.drive_value = 0.0;
    CHECK(predict(question).nozzle.flow_rate == 0.0);
}

TEST_CASE("predict laws: a vanishing yield stress leaves the answer of the power law") {
    const Prediction a = predict(case_of(PowerLawInk{.consistency = 30.6, .flow_index = 0.46}));
    const Prediction b =
        predict(case_of(HerschelBulkleyInk{.yield_stress = 1e-9, .consistency = 30.6, .flow_index = 0.46}));
    REQUIRE(a.cells.size() == b.cells.size());
    for (std::size_t i = 0; i < a.cells.size(); ++i) {
        CHECK(b.cells[i].stress->von_mises == doctest::Approx(a.cells[i].stress->von_mises).epsilon(1e-5));
    }
}

TEST_CASE("predict laws: population and profile of every law are finite but for the viscosity at rest") {
    for (const Ink& ink :
         {Ink(PowerLawInk{.consistency = 30.6, .flow_index = 0.46}),
          Ink(CarreauYasudaInk{.eta0 = 50.0, .time_constant = 0.7, .transition = 2.0, .flow_index = 0.3}),
          Ink(yielding),
          Ink(HerschelBulkleyInk{.yield_stress = 529.0, .consistency = 480.0, .flow_index = 0.04})}) {
        CAPTURE(law_name(ink));
        for (const bool with_length : {true, false}) {
            Case question = case_of(ink);
            if (!with_length) question.length.reset();
            question.population = true;
            question.profile_points = 9;
            const Prediction p = predict(question);
            REQUIRE(p.population.has_value());
            CHECK(std::isfinite(p.population->peak_stress.mean));
            CHECK(p.population->peak_stress.percentile_95 > p.population->peak_stress.median);
            CHECK(p.population->peak_stress.largest > 0.5 * p.nozzle.stress_max);
            for (const double r : p.profile->velocity) CHECK(std::isfinite(r));
            CHECK(std::isinf(p.profile->viscosity.front()) == !has_rest_viscosity(ink));
        }
    }
}
