#include "bioprint/simulate/simulation.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/lattice_units.hpp"

using namespace bioprint;

namespace {

Scene scene(double alpha, SceneKind kind = SceneKind::exit) {
    return {.kind = kind,
            .ink = {.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = alpha},
            .nozzle_radius = 50e-6,
            .velocity_average = 5e-3,
            .cell = {.radius = 8e-6, .shear_modulus = 1e3}};
}

NozzleFlow flow_of(const Scene& s) {
    return NozzleFlow::from_velocity(s.ink, s.nozzle_radius, s.velocity_average);
}

}  // namespace

TEST_CASE("lattice units: every limit holds and the binding one is named") {
    for (const double alpha : {0.0, 0.3, 0.75, 0.9}) {
        for (const double modulus : {50.0, 1e3, 1e4, 1e6}) {
            Scene s = scene(alpha);
            s.cell.shear_modulus = modulus;
            const LatticeUnits u = units_for_cell(s, flow_of(s), 38, {});
            CHECK(u.wall_reynolds <= 5.0 * (1.0 + 1e-12));
            CHECK(u.velocity_lu <= 0.05 * (1.0 + 1e-12));
            CHECK(modulus / u.stress <= 0.2 / 3.0 * (1.0 + 1e-12));
            CHECK(!u.binding.empty());
        }
    }
    Scene s = scene(0.0);
    s.cell.shear_modulus = 1e6;
    CHECK(units_for_cell(s, flow_of(s), 38, {}).binding == "elastic waves");
}

TEST_CASE("lattice units: they keep the flow's dimensionless numbers") {
    const Scene s = scene(0.6);
    const NozzleFlow flow = flow_of(s);
    const LatticeUnits u = units_for_cell(s, flow, 38, {});
    const auto ink = u.relaxation(s.ink);
    CHECK(ink.time_constant * u.velocity_lu / 38 ==
          doctest::Approx(s.ink.time_constant * s.velocity_average / s.nozzle_radius));
    // modulus over viscous stress
    CHECK(s.cell.shear_modulus / u.stress / (u.viscosity_lu * u.velocity_lu / 38) ==
          doctest::Approx(s.cell.shear_modulus / (s.ink.eta0 * s.velocity_average / s.nozzle_radius)));
}

TEST_CASE("lattice units: a cell too stiff for the flow is refused with one that fits and is as rigid") {
    Scene s = scene(0.0);
    s.cell.shear_modulus = 1e13;
    try {
        simulate(s);
        FAIL("accepted");
    } catch (const UsageError& e) {
        CHECK(std::string(e.what()).find("fits and bears the same stress") != std::string::npos);
        CHECK(e.option() == "--shear-modulus");
    }
}

TEST_CASE("lattice units: an ink that thins a million times is refused before the run") {
    Scene s = scene(0.95);
    s.ink.time_constant = 1e6 * s.nozzle_radius / s.velocity_average;
    try {
        simulate(s);
        FAIL("accepted");
    } catch (const UsageError& e) {
        CHECK(std::string(e.what()).find("steps for each nozzle radius") != std::string::npos);
    }
}

TEST_CASE("channel: the stress of a cell that is all but rigid does not depend on its modulus") {
    // Broke down after thousands of steps by an oscillation of period two when the forces were of one position.
    SimulationOptions options;
    options.resolution = 3.0;
    options.estimate_error = false;
    Scene s = scene(0.0);
    s.kind = SceneKind::channel;
    s.velocity_average = 1e-4;
    for (const double radius : {8e-6, 30e-6}) {
        s.cell.radius = radius;
        s.cell.shear_modulus = 1e4;
        const double soft = simulate(s, options).at("von_mises").value;
        s.cell.shear_modulus = 1e5;
        // 2 %: the lattice spacing makes the stress swing by one.
        CHECK(simulate(s, options).at("von_mises").value == doctest::Approx(soft).epsilon(0.02));
    }
}

TEST_CASE("simulation: what does not fit is refused by option") {
    const auto option = [](const Scene& s, const SimulationOptions& o = {}) {
        try {
            simulate(s, o);
        } catch (const UsageError& e) {
            return e.option();
        }
        return std::string("accepted");
    };
    Scene s = scene(0.5);
    s.cell.radius = 45e-6;
    CHECK(option(s) == "--cell-radius");
    s.cell.radius = 1e-8;
    CHECK(option(s) == "--resolution");
    s = scene(0.5);
    s.cell.shear_modulus = std::nan("");
    CHECK(option(s) == "--shear-modulus");
    s = scene(0.5);
    s.nozzle_radius = -1.0;
    CHECK(option(s) == "--radius");
    CHECK(option(scene(0.5), {.resolution = 1.0}) == "--resolution");
}

TEST_CASE("simulation: a cancelled run says so and keeps what it had") {
    const std::atomic<bool> cancel = true;
    SimulationOptions options{.resolution = 3.0};
    options.cancel = &cancel;
    try {
        simulate(scene(0.75, SceneKind::channel), options);
        FAIL("went on");
    } catch (const SimulationIncomplete& e) {
        CHECK(e.result().series.rows.size() == 1);
    }
}

TEST_CASE("simulation: a cell too soft to hold together ends with a reason and no NaN") {
    Scene s = scene(0.0, SceneKind::channel);
    s.cell.shear_modulus = 5.0;
    try {
        const SimulationResult r = simulate(s, {.resolution = 3.0, .channel_time = 0.3});
        for (const auto& v : r.values) {
            CHECK(std::isfinite(v.value));
        }
    } catch (const SimulationIncomplete& e) {
        CHECK(std::string(e.what()).find("inside out") != std::string::npos);
        for (const auto& row : e.result().series.rows) {
            for (const double x : row) {
                CHECK(std::isfinite(x));
            }
        }
    }
}

TEST_CASE("simulation: progress never falls within a stage and ends at one") {
    SimulationOptions options{.resolution = 3.0, .settle_tolerance = 0.05};
    double last = 0.0;
    options.progress = [&](const SimulationProgress& p) {
        CHECK(p.done >= last);
        CHECK(p.done <= 1.0);
        last = p.done;
    };
    simulate(scene(0.0, SceneKind::channel), options);
    CHECK(last == 1.0);
}

TEST_CASE("simulation: one that was cancelled goes on from its checkpoint to the same numbers") {
    SimulationOptions options{.resolution = 3.0, .settle_tolerance = 0.02};
    const SimulationResult whole = simulate(scene(0.75), options);

    SimulationState kept;
    std::atomic<bool> cancel = false;
    long checkpoints = 0;
    options.cancel = &cancel;
    options.checkpoint_interval = 0.0;
    options.checkpoint = [&](const SimulationState& state) {
        kept = state;
        ++checkpoints;
    };
    const auto cut_at = [&](const char* stage, double done) {
        cancel = false;
        options.progress = [&cancel, stage, done](const SimulationProgress& p) {
            if (std::string(p.stage) == stage && p.done >= done) {
                cancel = true;
            }
        };
        CHECK_THROWS_AS(simulate(scene(0.75), options), SimulationIncomplete);
    };
    cut_at("channel", 0.01);
    const SimulationState first = kept;
    options.resume = &first;
    cut_at("exit", 0.4);
    const SimulationState second = kept;
    options.resume = &second;
    cut_at("strand", 0.3);
    const SimulationState third = kept;
    options.resume = &third;
    cancel = false;
    options.progress = {};
    const SimulationResult resumed = simulate(scene(0.75), options);
    CHECK(checkpoints > 10);
    REQUIRE(resumed.values.size() == whole.values.size());
    for (std::size_t n = 0; n < whole.values.size(); ++n) {
        CHECK(resumed.values[n].value == whole.values[n].value);
    }
    CHECK(resumed.series.rows == whole.series.rows);
    CHECK(resumed.steps == whole.steps);

    Scene other = scene(0.75);
    other.cell.shear_modulus *= 1.01;
    CHECK_THROWS_AS(simulate(other, options), UsageError);
}
