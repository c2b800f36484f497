#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bioprint/simulate/simulation.hpp"
#include "support/reference_table.hpp"

using namespace bioprint;

// Independent finite-element solution: tests/reference/README.md.
namespace {

struct Reference {
    const char* file;
    double alpha, peak, peak_position, average, radial, excess;
};
// alpha, peak [Pa], its place [m], mean over ±R about it [Pa], largest radial velocity [m/s], excess pressure
// [Pa]
const Reference references[] = {
    {"exit_axis_alpha0.00.csv", 0.0, 754.61443, 7.2921052e-6, 410.36633, 1.1058285e-3, 888.46865},
    {"exit_axis_alpha0.30.csv", 0.3, 512.03845, 4.9843073e-6, 284.35494, 1.118234e-3, 533.60109},
    {"exit_axis_alpha0.75.csv", 0.75, 236.00098, -2.7095709e-6, 137.63973, 0.97064425e-3, 136.63141},
};

struct AxisPoint {
    double x, stress;
};

std::vector<AxisPoint> axis(const char* file) {
    constexpr double radius = 50e-6;
    std::vector<AxisPoint> points;
    for (const test::ReferenceRow& row : test::read_reference(file)) {
        points.push_back({.x = row.at("x_over_R") * radius, .stress = row.at("elongational_stress")});
    }
    return points;
}

SimulationResult exit_flow(double alpha, double resolution) {
    return simulate({.kind = SceneKind::exit_flow,
                     .ink = {.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = alpha},
                     .nozzle_radius = 50e-6,
                     .velocity_average = 5e-3},
                    {.resolution = resolution});
}

/// The largest distance of the simulated stress on the axis from the reference, as a share of the peak.
double pointwise(const SimulationResult& r, const Reference& reference) {
    double largest = 0.0;
    const auto& rows = r.series.rows;
    for (const AxisPoint& p : axis(reference.file)) {
        if (p.x < rows.front()[0] || p.x > rows.back()[0]) {
            continue;
        }
        std::size_t i = 1;
        while (rows[i][0] < p.x) {
            ++i;
        }
        const double t = (p.x - rows[i - 1][0]) / (rows[i][0] - rows[i - 1][0]);
        const double stress = (1.0 - t) * rows[i - 1][3] + t * rows[i][3];
        largest = std::max(largest, std::abs(stress - p.stress));
    }
    return largest / reference.peak;
}

bool within(const SimulationResult& r, const char* name, double exact, double relative) {
    return std::abs(r.at(name).value / exact - 1.0) < relative;
}

}  // namespace

TEST_CASE(
    "exit flow: peak and average of the elongational stress agree with finite elements to 0.2 % at 38 "
    "nodes") {
    for (const Reference& reference : references) {
        const SimulationResult r = exit_flow(reference.alpha, 6.0);
        REQUIRE(r.lattice.nodes_per_radius == 38);
        MESSAGE("alpha " << reference.alpha << ": peak " << r.at("elongational_stress_peak").value
                         << ", average " << r.at("elongational_stress_average").value << ", at "
                         << r.at("peak_position").value << ", pointwise " << pointwise(r, reference) << ", "
                         << r.wall_time << " s");
        CHECK(within(r, "elongational_stress_peak", reference.peak, 2e-3));
        CHECK(within(r, "elongational_stress_average", reference.average, 2e-3));
        CHECK(within(r, "radial_velocity_max", reference.radial, 1e-2));
        CHECK(std::abs(r.at("peak_position").value - reference.peak_position) < 0.1e-6);
        CHECK(std::abs(r.at("excess_pressure").value - reference.excess) <
              3.0 * r.at("excess_pressure").error);
        CHECK(pointwise(r, reference) < 1e-2);
    }
}
