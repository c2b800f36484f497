#include "numerics/boundary.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using bioprint::Boundary;
using bioprint::BoundaryRequest;
using bioprint::find_boundary;

namespace {

constexpr double tolerance = 1e-9;

BoundaryRequest line(double low, double high, double start) {
    return {.low = low, .high = high, .start = start, .first_step = 0.5, .tolerance = tolerance};
}

struct Counted {
    double root;
    double slope;
    double curvature;
    int* calls;
    double operator()(double s) const {
        ++*calls;
        return slope * (s - root) + curvature * std::expm1(s - root);
    }
};

}  // namespace

TEST_CASE("boundary: both ends are evaluated and bracket the root within the tolerance from any start") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> anywhere(-12.0, 12.0);
    std::uniform_real_distribution<double> positive(0.05, 3.0);
    int most = 0;
    for (int i = 0; i < 500; ++i) {
        int calls = 0;
        const double root = anywhere(random);
        const Counted f{
            .root = root, .slope = positive(random), .curvature = positive(random), .calls = &calls};
        const Boundary b = find_boundary(f, line(-15.0, 15.0, anywhere(random)));
        REQUIRE(b.inside);
        REQUIRE(b.outside);
        CHECK(*b.inside <= root + 1e-12);
        CHECK(*b.outside > root - 1e-12);
        CHECK(*b.outside - *b.inside <= tolerance);
        most = std::max(most, calls);
    }
    CHECK(most <= 55);  // exponentials over 27 e-folds, of up to e^3 each: 51; a straight line takes about 8
}

TEST_CASE("boundary: a straight line takes no more than a dozen evaluations") {
    int calls = 0;
    const Counted f{.root = 3.7, .slope = 0.8, .curvature = 0.0, .calls = &calls};
    find_boundary(f, line(-15.0, 15.0, 0.0));
    CHECK(calls <= 12);
}

TEST_CASE("boundary: a jump and an infinite excess are narrowed down too") {
    const auto jump = [](double s) { return s < 1.25 ? -1.0 : std::numeric_limits<double>::infinity(); };
    const Boundary b = find_boundary(jump, line(-10.0, 10.0, -3.0));
    REQUIRE(b.inside);
    REQUIRE(b.outside);
    CHECK(*b.inside < 1.25);
    CHECK(*b.outside >= 1.25);
    CHECK(*b.outside - *b.inside <= tolerance);
}

TEST_CASE("boundary: a condition that holds everywhere or nowhere has one end alone") {
    const Boundary everywhere = find_boundary([](double) { return -1.0; }, line(-2.0, 2.0, 0.0));
    CHECK(everywhere.inside == 2.0);
    CHECK_FALSE(everywhere.outside);
    const Boundary nowhere = find_boundary([](double) { return 1.0; }, line(-2.0, 2.0, 2.0));
    CHECK_FALSE(nowhere.inside);
    CHECK(nowhere.outside == -2.0);
}
