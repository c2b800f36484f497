#include "bioprint/rheology/flow_curve_fit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

using Law = std::function<double(double)>;

std::vector<FlowPoint> curve(const Law& law, double low, double high, int count, double error = 0.0,
                             unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    std::vector<FlowPoint> points;
    for (int i = 0; i < count; ++i) {
        const double rate = low * std::pow(high / low, static_cast<double>(i) / (count - 1));
        points.push_back({rate, law(rate) * std::exp(error * noise(random))});
    }
    return points;
}

Law cross(double eta0, double k, double alpha, double eta_inf = 0.0) {
    return [=](double g) { return eta_inf + (eta0 - eta_inf) / (1.0 + std::pow(k * g, alpha)); };
}

/// Rounding of the data and of a search that stops at relative steps of 1e-10.
constexpr double exact = 1e-8;

double value(const LawFit& fit, std::string_view name) {
    const FittedParameter* const p = fit.find(name);
    REQUIRE(p != nullptr);
    return p->value;
}

}  // namespace

TEST_CASE("fit: exact curves of every law give back their parameters") {
    SUBCASE("newtonian") {
        const FlowCurveFit fit = fit_flow_curve(curve([](double) { return 0.15; }, 0.01, 1000.0, 20));
        CHECK(value(*fit.find({FittedLaw::newtonian, false}), "eta0") ==
              doctest::Approx(0.15).epsilon(exact));
    }
    SUBCASE("power law") {
        const auto points = curve([](double g) { return 30.6 * std::pow(g, 0.46 - 1.0); }, 0.1, 100.0, 20);
        const FlowCurveFit fit = fit_flow_curve(points);
        const LawFit& law = *fit.find({FittedLaw::power_law, false});
        CHECK(value(law, "consistency") == doctest::Approx(30.6).epsilon(exact));
        CHECK(value(law, "flow_index") == doctest::Approx(0.46).epsilon(exact));
    }
    SUBCASE("cross") {
        for (const double k : {1e-4, 0.05, 3.0, 100.0}) {
            for (const double alpha : {0.3, 0.75, 1.0, 1.3}) {
                CAPTURE(k);
                CAPTURE(alpha);
                const FlowCurveFit fit = fit_flow_curve(curve(cross(10.0, k, alpha), 1e-3 / k, 1e4 / k, 25));
                const LawFit& law = *fit.find({FittedLaw::cross, false});
                CHECK(value(law, "eta0") == doctest::Approx(10.0).epsilon(exact));
                CHECK(value(law, "time_constant") == doctest::Approx(k).epsilon(exact));
                CHECK(value(law, "alpha") == doctest::Approx(alpha).epsilon(exact));
                CHECK(law.converged);
            }
        }
    }
    SUBCASE("cross with a plateau at high rates") {
        const FlowCurveFit fit = fit_flow_curve(curve(cross(200.0, 1.0, 0.8, 0.05), 1e-3, 1e6, 40));
        const LawFit& law = *fit.find({FittedLaw::cross, true});
        CHECK(value(law, "eta_inf") == doctest::Approx(0.05).epsilon(1e-6));
        CHECK(value(law, "eta0") == doctest::Approx(200.0).epsilon(1e-6));
        CHECK(fit.laws.front().choice.fit_eta_inf);
    }
    SUBCASE("carreau-yasuda") {
        const Law law = [](double g) {
            return 50.0 * std::pow(1.0 + std::pow(0.7 * g, 1.6), (0.35 - 1.0) / 1.6);
        };
        const FlowCurveFit fit = fit_flow_curve(curve(law, 1e-3, 1e4, 40));
        const LawFit& carreau = *fit.find({FittedLaw::carreau_yasuda, false});
        CHECK(value(carreau, "eta0") == doctest::Approx(50.0).epsilon(1e-6));
        CHECK(value(carreau, "time_constant") == doctest::Approx(0.7).epsilon(1e-6));
        CHECK(value(carreau, "transition") == doctest::Approx(1.6).epsilon(1e-6));
        CHECK(value(carreau, "flow_index") == doctest::Approx(0.35).epsilon(1e-6));
    }
    SUBCASE("herschel-bulkley") {
        const Law law = [](double g) { return 60.0 / g + 79.0 * std::pow(g, 0.4 - 1.0); };
        const FlowCurveFit fit = fit_flow_curve(curve(law, 1e-2, 1e3, 30));
        CHECK(fit.laws.front().choice.law == FittedLaw::herschel_bulkley);
        CHECK(value(fit.laws.front(), "yield_stress") == doctest::Approx(60.0).epsilon(1e-6));
        CHECK(value(fit.laws.front(), "consistency") == doctest::Approx(79.0).epsilon(1e-6));
        CHECK(value(fit.laws.front(), "flow_index") == doctest::Approx(0.4).epsilon(1e-6));
    }
}

TEST_CASE("fit: wild points are left out and the parameters stay") {
    auto points = curve(cross(10.0, 0.05, 0.75), 0.01, 1000.0, 30, 0.01);
    const LawFit clean = *fit_flow_curve(points).find({FittedLaw::cross, false});
    points[0].viscosity *= 3.0;
    points[7].viscosity /= 2.0;
    points[22].viscosity *= 1.4;
    const FlowCurveFit fit = fit_flow_curve(points);
    CHECK(fit.points_used == 27);
    for (const std::size_t i : {0, 7, 22}) CHECK_FALSE(fit.used[i]);
    const LawFit& law = *fit.find({FittedLaw::cross, false});
    for (const FittedParameter& p : clean.parameters) {
        CHECK(std::abs(value(law, p.name) - p.value) < 2.0 * p.standard_error);
    }
}

TEST_CASE("fit: points that scatter without outliers are all kept") {
    int dropped = 0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const FlowCurveFit fit = fit_flow_curve(curve(cross(10.0, 0.05, 0.75), 0.01, 1000.0, 25, 0.03, seed));
        dropped += 25 - static_cast<int>(fit.points_used);
    }
    // 1250 normal points: beyond 4 standard deviations lie 0.08 of them; the scatter is itself estimated.
    CHECK(dropped <= 6);
}

TEST_CASE("fit: without a plateau only the combination of eta0 and K is determined") {
    const auto points = curve(cross(1e5, 1e5, 0.7), 0.1, 1000.0, 30, 0.02);
    const FlowCurveFit fit = fit_flow_curve(points);
    const LawFit& law = *fit.find({FittedLaw::cross, false});
    CHECK_FALSE(law.find("eta0")->determined);
    CHECK_FALSE(law.find("time_constant")->determined);
    CHECK(law.find("alpha")->determined);
    const CrossConsistency m = cross_consistency(law);
    const double truth = 1e5 / std::pow(1e5, 0.7);
    CHECK(std::abs(m.value - truth) < 4.0 * m.standard_error);
    CHECK(m.standard_error > 0.0);
    CHECK(m.standard_error < 0.1 * truth);
    // In the rates measured the law is as good as ever.
    for (std::size_t i = 0; i < points.size(); ++i)
        CHECK(law.fitted[i] == doctest::Approx(points[i].viscosity).epsilon(0.1));
}

TEST_CASE("fit: without thinning K and alpha are not determined and a constant is the better law") {
    const FlowCurveFit fit = fit_flow_curve(curve([](double) { return 2.0; }, 0.01, 100.0, 20, 0.02));
    CHECK(fit.laws.front().choice.law == FittedLaw::newtonian);
    const LawFit& law = *fit.find({FittedLaw::cross, false});
    CHECK_FALSE((law.find("time_constant")->determined && law.find("alpha")->determined));
}

TEST_CASE("fit: the information criterion finds the law behind noisy points") {
    const auto best = [](const Law& law, unsigned seed) {
        return fit_flow_curve(curve(law, 0.01, 1000.0, 40, 0.02, seed)).laws.front().choice.law;
    };
    int right = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        right += best(cross(10.0, 0.5, 0.75), seed) == FittedLaw::cross ? 1 : 0;
        right += best([](double g) { return 60.0 / g + 20.0 * std::pow(g, 0.5 - 1.0); }, seed) ==
                 FittedLaw::herschel_bulkley;
        right += best([](double g) { return 30.0 * std::pow(g, -0.5); }, seed) == FittedLaw::power_law;
    }
    // AICc prefers a needless parameter in some 16 % of the cases where the smaller law is true.
    CHECK(right >= 45);
}

TEST_CASE("fit: a held viscosity at infinite rate is held") {
    const auto points = curve(cross(10.0, 0.05, 0.75, 0.2), 0.01, 1e5, 40);
    const FlowCurveFit fit = fit_flow_curve(points, {.eta_inf = 0.2});
    const LawFit& law = *fit.find({FittedLaw::cross, false});
    CHECK(law.eta_inf == 0.2);
    CHECK(value(law, "eta0") == doctest::Approx(10.0).epsilon(exact));
}

TEST_CASE("fit: the order of the points and the unit of viscosity change nothing") {
    auto points = curve(cross(10.0, 0.05, 0.75), 0.01, 1000.0, 30, 0.03);
    const LawFit law = *fit_flow_curve(points).find({FittedLaw::cross, false});
    std::reverse(points.begin(), points.end());
    for (FlowPoint& p : points) p.viscosity *= 1000.0;
    const LawFit other = *fit_flow_curve(points).find({FittedLaw::cross, false});
    CHECK(value(other, "eta0") == doctest::Approx(1000.0 * value(law, "eta0")).epsilon(1e-6));
    CHECK(value(other, "alpha") == doctest::Approx(value(law, "alpha")).epsilon(1e-6));
    CHECK(other.scatter == doctest::Approx(law.scatter).epsilon(1e-6));
}

TEST_CASE("fit: a point of weight four is worth four of weight one") {
    auto points = curve(cross(10.0, 0.05, 0.75), 0.01, 1000.0, 12, 0.001);  // too little to be an outlier
    std::vector<FlowPoint> repeated;
    for (const FlowPoint& p : points) repeated.insert(repeated.end(), 4, p);
    for (FlowPoint& p : points) p.weight = 4.0;
    const LawFit once = *fit_flow_curve(points).find({FittedLaw::cross, false});
    const LawFit four = *fit_flow_curve(repeated).find({FittedLaw::cross, false});
    for (const FittedParameter& p : once.parameters)
        CHECK(p.value == doctest::Approx(value(four, p.name)).epsilon(1e-6));
}

TEST_CASE("fit: errors and scatter do not depend on how many points the search for a start condenses") {
    for (const int count : {900, 1001, 5500, 20000}) {
        CAPTURE(count);
        const FlowCurveFit fit = fit_flow_curve(curve(cross(10.0, 0.05, 0.75), 0.01, 1000.0, count, 0.05));
        const LawFit& law = *fit.find({FittedLaw::cross, false});
        const double known[] = {10.0, 0.05, 0.75};
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(std::abs(law.parameters[i].value - known[i]) < 3.5 * law.parameters[i].standard_error);
        }
        // As 1/sqrt(n); 0.029 Pa s for 900 points.
        CHECK(law.parameters[0].standard_error * std::sqrt(count / 900.0) ==
              doctest::Approx(0.029).epsilon(0.15));
        CHECK(law.scatter == doctest::Approx(0.05).epsilon(0.06));
        // A law that does not fit scatters by its misfit, whatever the number of points.
        CHECK(fit.find({FittedLaw::power_law, false})->scatter == doctest::Approx(0.403).epsilon(0.02));
        CHECK(fit.laws.front().choice.law != FittedLaw::power_law);
    }
}

TEST_CASE("fit: of many points at few rates no rate is lost") {
    std::vector<FlowPoint> points;
    for (const auto& [rate, count] : {std::pair{0.1, 2000}, {3.0, 7}, {30.0, 1500}, {300.0, 9}}) {
        points.insert(points.end(), count, {rate, cross(10.0, 0.05, 0.75)(rate)});
    }
    const FlowCurveFit fit = fit_flow_curve(points);
    CHECK(fit.points_used == points.size());
    const LawFit& law = *fit.find({FittedLaw::cross, false});
    CHECK(value(law, "eta0") == doctest::Approx(10.0).epsilon(exact));
    CHECK(value(law, "alpha") == doctest::Approx(0.75).epsilon(exact));
}

TEST_CASE("fit: a flow index of 0 is not rounded below it") {
    const LawFit law = *fit_flow_curve(curve([](double g) { return 60.0 / g; }, 0.1, 50.0, 9))
                            .find({FittedLaw::carreau_yasuda, false});
    CHECK(value(law, "flow_index") >= 0.0);
}

TEST_CASE("fit: too few rates and values that are no measurement are refused") {
    CHECK_THROWS_AS(fit_flow_curve({}), UsageError);
    CHECK_THROWS_AS(fit_flow_curve(std::vector<FlowPoint>{{1.0, 2.0}}), UsageError);
    CHECK_THROWS_AS(fit_flow_curve(std::vector<FlowPoint>(20, {1.0, 2.0})), UsageError);
    for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        auto points = curve(cross(10.0, 0.05, 0.75), 0.01, 1000.0, 12);
        points[3].viscosity = bad;
        CHECK_THROWS_AS(fit_flow_curve(points), UsageError);
    }
}

TEST_CASE("fit: whatever the points every number is finite or says that it is unknown") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-8.0, 8.0);
    for (int k = 0; k < 60; ++k) {
        std::vector<FlowPoint> points;
        const int count = 3 + static_cast<int>(random() % 12);
        for (int i = 0; i < count; ++i)
            points.push_back({std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random))});
        const FlowCurveFit fit = fit_flow_curve(points);
        CHECK_FALSE(fit.laws.empty());
        for (const LawFit& law : fit.laws) {
            CHECK(std::isfinite(law.scatter));
            for (const double eta : law.fitted) CHECK((std::isfinite(eta) && eta > 0.0));
            for (const FittedParameter& p : law.parameters) {
                CHECK(std::isfinite(p.value));
                CHECK_FALSE(std::isnan(p.standard_error));
                if (p.determined)
                    CHECK((std::isfinite(p.low) && std::isfinite(p.high) && std::isfinite(p.standard_error)));
            }
        }
    }
}
