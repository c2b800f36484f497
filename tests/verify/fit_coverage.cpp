#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include "bioprint/rheology/cross.hpp"
#include "bioprint/rheology/flow_curve_fit.hpp"

// Do the error bars hold what they say? Random inks, measured with a known relative error, fitted; the truth lies
// within two standard errors and within the 95 % interval as often as it should.

using namespace bioprint;

namespace {

struct Count {
    int inside_error = 0;
    int inside_interval = 0;
    int all = 0;
    void add(const FittedParameter& p, double truth) {
        ++all;
        inside_error += std::abs(p.value - truth) <= 2.0 * p.standard_error ? 1 : 0;
        inside_interval += p.low <= truth && truth <= p.high ? 1 : 0;
    }
    [[nodiscard]] double error_share() const { return static_cast<double>(inside_error) / all; }
    [[nodiscard]] double interval_share() const { return static_cast<double>(inside_interval) / all; }
};

std::vector<FlowPoint> measured(const CrossInk& ink, double low, double high, int count, double error,
                                std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, error);
    std::vector<FlowPoint> points;
    for (int i = 0; i < count; ++i) {
        const double rate = low * std::pow(high / low, static_cast<double>(i) / (count - 1));
        points.push_back({rate, viscosity(ink, rate) * std::exp(noise(random))});
    }
    return points;
}

}  // namespace

TEST_CASE("fit: two standard errors hold the truth of random Cross inks as often as they should") {
    std::mt19937 random(20221);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    constexpr int cases = 100;
    Count eta0;
    Count time;
    Count alpha;
    for (int k = 0; k < cases; ++k) {
        const CrossInk ink{.eta0 = std::pow(10.0, -1.0 + 4.0 * uniform(random)),
                           .time_constant = std::pow(10.0, -2.0 + 2.0 * uniform(random)),
                           .alpha = 0.4 + 0.6 * uniform(random)};
        const double error = std::pow(10.0, -2.5 + 1.2 * uniform(random));
        const int count = 15 + static_cast<int>(30 * uniform(random));
        const FlowCurveFit fit = fit_flow_curve(measured(ink, 0.01, 1000.0, count, error, random));
        const LawFit* const cross = fit.find({FittedLaw::cross, false});
        REQUIRE(cross != nullptr);
        CHECK(cross->converged);
        eta0.add(*cross->find("eta0"), ink.eta0);
        time.add(*cross->find("time_constant"), ink.time_constant);
        alpha.add(*cross->find("alpha"), ink.alpha);
    }
    // The least count that a true share of 95 % gives once in a million sets of 1000 is 915.
    for (const Count& count : {eta0, time, alpha}) {
        MESSAGE("within two standard errors " << count.error_share() << ", within the interval "
                                              << count.interval_share());
        CHECK(count.error_share() > 0.90);
        CHECK(count.error_share() < 0.99);
        CHECK(count.interval_share() > 0.915);
        CHECK(count.interval_share() < 0.985);
    }
}
