#include "lattice/axisymmetric.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace bioprint::lattice;

namespace {

struct Profile {
    std::vector<double> nodes, slope, links;
};

/// Poiseuille flow with maximum `u` in a tube of n nodes.
Profile parabola(int n, double u) {
    Profile p;
    for (int j = 0; j < n; ++j) {
        const double r = (j + 0.5) / n;
        p.nodes.push_back(u * (1.0 - r * r));
        p.slope.push_back(-2.0 * u * r / n);
    }
    for (int j = 0; j <= n; ++j) {
        const double r = static_cast<double>(j) / n;
        p.links.push_back(u * (1.0 - r * r));
    }
    return p;
}

AxisymmetricFlow exit_flow(const Profile& p, const CrossRelaxation& ink, int n = 12) {
    AxisymmetricFlow flow({.length = 6 * n, .radius = n, .lip = 3 * n}, ink, p.nodes, p.links);
    const double nu = ink.uniform_t() / 3.0;
    flow.start(p.nodes, p.slope, 4.0 * nu * p.nodes.front() / (n * n));
    return flow;
}

double largest(const std::vector<double>& v) {
    double top = 0.0;
    for (const double x : v) {
        top = std::max(top, std::abs(x));
    }
    return top;
}

constexpr CrossRelaxation thinning{.t0 = 9.0, .t_inf = 0.0, .time_constant = 2000.0, .alpha = 0.6};

}  // namespace

TEST_CASE("axisymmetric lattice: rest stays exactly at rest") {
    AxisymmetricFlow flow({.length = 32, .radius = 8, .lip = 32, .periodic = true}, thinning);
    for (int n = 0; n < 50; ++n) {
        flow.step();
    }
    CHECK(largest(flow.measure().velocity_x) == 0.0);
    CHECK(largest(flow.measure().pressure) == 0.0);
}

TEST_CASE("axisymmetric lattice: a restored state goes on to the same bits") {
    const Profile p = parabola(12, 0.02);
    AxisymmetricFlow flow = exit_flow(p, thinning);
    for (int n = 0; n < 33; ++n) {
        flow.step();
    }
    AxisymmetricFlow other = exit_flow(p, thinning);
    other.restore(flow.state());
    for (int n = 0; n < 20; ++n) {
        flow.step();
        other.step();
    }
    CHECK(flow.state() == other.state());
}

TEST_CASE("axisymmetric lattice: a window of zero force changes nothing") {
    const Profile p = parabola(12, 0.02);
    AxisymmetricFlow flow = exit_flow(p, thinning);
    AxisymmetricFlow windowed = exit_flow(p, thinning);
    windowed.set_window({.begin = -8, .columns = 24, .rows = 5});
    for (int n = 0; n < 40; ++n) {
        flow.step();
        windowed.step();
    }
    const auto a = flow.measure().velocity_x;
    const auto b = windowed.measure().velocity_x;
    double difference = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        difference = std::max(difference, std::abs(a[n] - b[n]));
    }
    CHECK(difference < 1e-15);  // rounding: the two stretches vectorise alike but may contract differently
}

TEST_CASE("axisymmetric lattice: a rescaled steady flow is steady") {
    const Profile p = parabola(12, 0.02);
    AxisymmetricFlow flow = exit_flow(p, thinning);
    REQUIRE(flow.run_to_steady(1e-10, 200000));
    const auto before = flow.measure();
    constexpr double velocity = 0.2;
    constexpr double viscosity = 0.1;
    flow.rescale(velocity, viscosity);
    const double scale = velocity * largest(before.velocity_x);
    for (int n = 0; n < 400; ++n) {
        flow.step();
    }
    const auto after = flow.measure();
    double error = 0.0;
    for (std::size_t n = 0; n < before.velocity_x.size(); ++n) {
        error = std::max(error, std::abs(after.velocity_x[n] - velocity * before.velocity_x[n]));
    }
    CHECK(error < 1e-7 * scale);
}

TEST_CASE("axisymmetric lattice: the flow rate is the same through every column of a steady exit flow") {
    double error_before = 0.0;
    for (const int n : {12, 24}) {
        const Profile p = parabola(n, 0.02);
        AxisymmetricFlow flow = exit_flow(p, {.t0 = 9.0}, n);
        REQUIRE(flow.run_to_steady(1e-8, 400000));
        const double first = flow.flow_rate(2);
        double error = 0.0;
        for (int i = 3; i < 6 * n - 3; ++i) {
            error = std::max(error, std::abs(flow.flow_rate(i) / first - 1.0));
        }
        CHECK(error < 0.5 / (n * n));
        if (error_before > 0.0) {
            CHECK(std::log2(error_before / error) > 1.7);  // second order
        }
        error_before = error;
    }
}
