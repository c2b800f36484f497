#include <doctest/doctest.h>

#include <algorithm>

#include "bioprint/predict/ladder.hpp"
#include "bioprint/predict/prediction.hpp"

using namespace bioprint;

namespace {

Case question() {
    return {.radius = 50e-6,
            .length = {},
            .drive = Drive::velocity,
            .drive_value = 5e-3,
            .ink = {.name = "ink",
                    .source = "",
                    .law = CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75}},
            .cell = {.name = "cell", .source = "", .radius = 8e-6, .shear_modulus = 1000.0},
            .positions = {},
            .needle = {}};
}

const CellAnswer& centred_exit(const Prediction& prediction) {
    return *std::find_if(prediction.cells.begin(), prediction.cells.end(), [](const CellAnswer& cell) {
        return cell.offset == 0.0 && cell.place == Place::exit && cell.model == Model::ellipsoid;
    });
}

bool nothing_is_known(const Prediction& prediction) {
    return std::none_of(prediction.cells.begin(), prediction.cells.end(),
                        [](const CellAnswer& cell) { return cell.error || cell.strain_error; }) &&
           std::none_of(prediction.passages.begin(), prediction.passages.end(),
                        [](const PassageAnswer& passage) { return passage.error.has_value(); });
}

}  // namespace

TEST_CASE(
    "stated errors: a usual question has them beside its numbers and they are those that were measured") {
    Case asked = question();
    asked.positions = {{.value = 0.0}, {.value = 24e-6}};
    const Prediction p = predict(asked);
    CHECK(p.nozzle.error > 0.0);
    CHECK(p.nozzle.error < 1e-13);
    CHECK(p.exit.error == expected_error(QuestionKind::exit_flow, Rung::steady, 0.0));
    const CellAnswer& cell = centred_exit(p);
    const double load = p.exit.elongational_stress / 1000.0;
    REQUIRE(cell.error);
    CHECK(*cell.error >= *expected_error(QuestionKind::exit, Rung::ellipsoid, load));
    REQUIRE(cell.strain_error);
    CHECK(*cell.strain_error > *cell.error);
    REQUIRE(p.passages.size() == 2);
    CHECK(p.passages[0].error == cell.error);
    CHECK(p.passages[1].nozzle_error ==
          expected_error(QuestionKind::channel_off_axis, Rung::ellipsoid, p.cells[3].stress_ratio));
}

TEST_CASE(
    "stated errors: softer cells at the exit are known less well and those without a shape not at all") {
    Case asked = question();
    asked.positions = {{.value = 0.0}};
    asked.ink.law = CrossInk{.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.0};
    const CellAnswer usual = centred_exit(predict(asked));  // G R_c/μ 0.64
    asked.drive_value = 8e-3;
    const CellAnswer softer = centred_exit(predict(asked));
    CHECK(*softer.error > *usual.error);
    CHECK(*softer.strain_error > 1.5 * *usual.strain_error);
    asked.drive_value = 12e-3;
    CHECK(nothing_is_known(predict(asked)));
}

TEST_CASE("stated errors: other inks, fillings and sizes than the measured ones have none") {
    Case asked = question();
    asked.cell.viscosity_ratio = 5.0;
    CHECK(nothing_is_known(predict(asked)));
    asked = question();
    asked.cell.radius = 20e-6;
    asked.positions = {{.value = 0.0}};
    CHECK(nothing_is_known(predict(asked)));
    asked = question();
    asked.ink.law = PowerLawInk{.consistency = 10.0, .flow_index = 0.5};
    const Prediction p = predict(asked);
    CHECK(nothing_is_known(p));
    CHECK_FALSE(p.exit.error);
    CHECK(p.nozzle.error > 0.0);
}

TEST_CASE("stated errors: a cell within one radius of the wall has none and its neighbour has") {
    Case asked = question();
    asked.positions = {{.value = 33e-6}, {.value = 36e-6}};
    const Prediction p = predict(asked);
    REQUIRE(p.passages.size() == 2);
    CHECK(p.passages[0].nozzle_error);
    CHECK_FALSE(p.passages[1].nozzle_error);
}
