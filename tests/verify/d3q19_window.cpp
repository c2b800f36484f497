#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "bioprint/errors.hpp"
#include "lattice/d3q19.hpp"

using namespace bioprint;

namespace {

constexpr double radius = 8.5;
constexpr int length = 96;
constexpr int lip =
    40;  // within the window, so that rigid wall, lip and free surface lie in it and beside it
constexpr double velocity = 0.01;

template <class Real>
D3q19<Real> nozzle_exit(int threads) {
    return D3q19<Real>({.nx = length,
                        .section = tube(radius, true),
                        .viscosity = {.nu0 = 1.0, .time_constant = 500.0, .alpha = 0.75},
                        .ends = Ends::inflow_outflow,
                        .inflow =
                            [](double y, double z) {
                                const double part = std::min((y * y + z * z) / (radius * radius), 1.0);
                                return 2.0 * velocity * (1.0 - part);
                            },
                        .slip_begin = lip,
                        .slip_end = length,
                        .threads = threads});
}

template <class Real>
void run(D3q19<Real>& lattice, int cycles) {
    for (int i = 0; i < cycles; ++i) {
        lattice.cycle();
    }
}

/// Settled once for all that start from it.
D3q19<double> resting_exit() {
    static const std::vector<double> state = [] {
        auto lattice = nozzle_exit<double>(1);
        run(lattice, 4000);
        return lattice.state();
    }();
    auto lattice = nozzle_exit<double>(1);
    lattice.restore(state);
    return lattice;
}

/// Over the average velocity.
double largest_difference(const D3q19<double>& a, const D3q19<double>& b) {
    double largest = 0.0;
    for (int r = 0; r < a.rows(); ++r) {
        for (int x = 0; x < length; ++x) {
            const auto u = a.at(x, r).velocity;
            const auto v = b.at(x, r).velocity;
            for (int axis = 0; axis < 3; ++axis) {
                largest = std::max(largest, std::abs(u[axis] - v[axis]));
            }
        }
    }
    return largest / velocity;
}

/// Two opposite pushes three spacings apart, as a body without a net force gives.
template <class Real>
void push(D3q19<Real>& lattice, int x, double force) {
    const int row = lattice.row(lattice.section().ny / 2 + 3, 2);
    lattice.set_coupling(row, d3q19::Coupling::coupled);
    for (const int sign : {1, -1}) {
        const int at = x + (sign > 0 ? 0 : 3);
        lattice.force(0, row)[at] = static_cast<Real>(sign * force);
        lattice.force(1, row)[at] = static_cast<Real>(0.5 * sign * force);
    }
}

}  // namespace

TEST_CASE("3-D lattice: a flow at rest stays as it is in a window wherever it lies") {
    const auto resting = resting_exit();
    auto lattice = resting_exit();
    run(lattice, 100);
    constexpr double at_rest = 1e-5;  // of the average velocity; single precision is coarser
    CHECK(largest_difference(lattice, resting) < at_rest);
    for (const std::array<int, 2> window : {std::array{16, 80}, {32, 48}, {0, 48}, {48, 96}}) {
        CAPTURE(window[0]);
        lattice.restore(resting.state());
        lattice.set_window(window[0], window[1]);
        run(lattice, 100);
        CHECK(largest_difference(lattice, resting) < at_rest);
    }
}

TEST_CASE(
    "3-D lattice: outside its window nothing changes and inside a disturbance settles as in the whole") {
    const auto resting = resting_exit();
    auto whole = resting_exit();
    auto part = resting_exit();
    part.set_window(16, 80);
    constexpr int pushed = 44;
    constexpr double force = 5e-3;
    const int row = whole.row(whole.section().ny / 2 + 3, 2);
    for (D3q19<double>* lattice : {&whole, &part}) {
        push(*lattice, pushed, force);
        run(*lattice, 800);
    }
    const double moved = largest_difference(whole, resting);
    const double difference =
        std::abs(part.at(pushed, row).velocity[0] - whole.at(pushed, row).velocity[0]) / velocity;
    std::printf("a push in the middle moves the ink by %.3g u_avg, in a window by %.2g of that otherwise\n",
                moved, difference / moved);
    CHECK(moved > 0.05);
    // The window's ends, three radii and more away, hold the populations sent, not the flow rate.
    CHECK(difference < 3e-3 * moved);
    double outside = 0.0;
    for (int r = 0; r < whole.rows(); ++r) {
        for (const int x : {0, 10, 15, 80, 81, 95}) {
            outside = std::max(outside, std::abs(part.at(x, r).velocity[0] - resting.at(x, r).velocity[0]));
            outside = std::max(outside, std::abs(part.at(x, r).density - resting.at(x, r).density));
        }
    }
    CHECK(outside == 0.0);
}

TEST_CASE("3-D lattice: in a window the number of threads does not change a bit") {
    const auto state = [](int threads) {
        auto lattice = nozzle_exit<float>(threads);
        run(lattice, 50);
        lattice.set_window(16, 64);
        push(lattice, 40, 1e-4);
        run(lattice, 50);
        lattice.set_window(32, 96);
        run(lattice, 50);
        return lattice.state();
    };
    const auto one = state(1);
    CHECK(one == state(2));
    CHECK(one == state(5));
}

TEST_CASE("3-D lattice: a window that does not fit is refused") {
    auto open = nozzle_exit<float>(1);
    CHECK_THROWS_AS(open.set_window(8, 64), UsageError);
    CHECK_THROWS_AS(open.set_window(16, 112), UsageError);
    CHECK_THROWS_AS(open.set_window(32, 32), UsageError);
    D3q19<float> periodic({.nx = 32, .section = tube(5.0, true), .inflow = {}});
    CHECK_THROWS_AS(periodic.set_window(0, 16), UsageError);
    CHECK_NOTHROW(periodic.set_window(0, 32));
}
