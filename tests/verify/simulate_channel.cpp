#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/simulate/simulation.hpp"

using namespace bioprint;

namespace {

constexpr double nozzle = 50e-6;
constexpr double cell = 8e-6;
constexpr double speed = 5e-3;

Scene stiff() {
    return {.kind = SceneKind::channel,
            .ink = {.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = 0.0},
            .nozzle_radius = nozzle,
            .velocity_average = speed,
            .cell = {.radius = cell, .shear_modulus = 1e4}};
}

struct StiffError {
    double stress, velocity;
};

/// Against the rigid sphere on the axis of Poiseuille flow: ⟨von Mises⟩ = 0.97173 G R_c, v = u_max (1 − ⅔
/// (R_c/R)²).
StiffError stiff_error(double resolution, CellCoupling coupling = CellCoupling::inside_elements) {
    SimulationOptions options{
        .resolution = resolution, .estimate_error = false, .accuracy = 2e-3, .settle_tolerance = 1e-3};
    options.coupling = coupling;
    const SimulationResult r = simulate(stiff(), options);
    const double gradient = 8.0 * 5.0 * speed / (nozzle * nozzle);
    const double velocity = 2.0 * speed * (1.0 - 2.0 / 3.0 * cell * cell / (nozzle * nozzle));
    return {.stress = r.at("von_mises").value / (0.97173 * gradient * cell) - 1.0,
            .velocity = r.at("cell_velocity").value / velocity - 1.0};
}

}  // namespace

TEST_CASE("channel: a stiff cell at 6 nodes has the rigid sphere's stress to 2 % and speed to 0.1 %") {
    const StiffError e = stiff_error(6.0);
    MESSAGE("stress " << e.stress << " velocity " << e.velocity);
    CHECK(std::abs(e.stress) < 0.02);
    CHECK(std::abs(e.velocity) < 1e-3);
}

TEST_CASE(
    "channel: coupling at the vertices gives the stress a third too high where coupling inside does not") {
    CHECK(stiff_error(6.0, CellCoupling::at_vertices).stress > 0.2);
}

TEST_CASE("channel: the same values come out for one thread and two") {
    SimulationOptions options{.resolution = 6.0, .settle_tolerance = 5e-2};
    const SimulationResult one = simulate(stiff(), options);
    options.threads = 2;
    const SimulationResult two = simulate(stiff(), options);
    REQUIRE(one.values.size() == two.values.size());
    for (std::size_t n = 0; n < one.values.size(); ++n) {
        CHECK(one.values[n].value == two.values[n].value);
        CHECK(one.values[n].error == two.values[n].error);
    }
    CHECK(one.series.rows == two.series.rows);
}
