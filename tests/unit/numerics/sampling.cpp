#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bioprint/errors.hpp"
#include "numerics/correlation.hpp"
#include "numerics/quasi_random.hpp"
#include "numerics/sample_statistics.hpp"

using namespace bioprint;

namespace {

constexpr double mean_tolerance = 0.001;  // of the value, 1024 points
constexpr double spread_tolerance = 0.015;
constexpr double share_tolerance = 0.02;

std::vector<double> normals(std::size_t dimensions, std::size_t count) {
    std::vector<double> points = sobol_points(dimensions, count);
    std::transform(points.begin(), points.end(), points.begin(), normal_quantile);
    return points;
}

}  // namespace

TEST_CASE("sampling: each coordinate of a power of two points takes every cell once") {
    for (const std::size_t count : {8U, 64U, 256U}) {
        const std::vector<double> points = sobol_points(5, count);
        for (std::size_t d = 0; d < 5; ++d) {
            std::vector<double> along;
            for (std::size_t i = 0; i < count; ++i) along.push_back(points[i * 5 + d]);
            std::sort(along.begin(), along.end());
            for (std::size_t i = 0; i < count; ++i) {
                CHECK(along[i] == (static_cast<double>(i) + 0.5) / static_cast<double>(count));
            }
        }
    }
    CHECK_THROWS_AS(sobol_points(41, 8), UsageError);
    CHECK_THROWS_AS(sobol_points(0, 8), UsageError);
}

TEST_CASE("sampling: a sum of normals has the shares of its squared coefficients") {
    constexpr std::size_t count = 1024;
    const std::vector<double> z = normals(3, count);
    const std::vector<double> factor = {3.0, 2.0, 0.5};
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        values.push_back(10.0 + factor[0] * z[3 * i] + factor[1] * z[3 * i + 1] + factor[2] * z[3 * i + 2]);
    }
    const SampleStatistics s = sample_statistics(values, z, 3);
    const double variance = 9.0 + 4.0 + 0.25;
    CHECK(s.mean == doctest::Approx(10.0).epsilon(mean_tolerance));
    CHECK(s.standard_deviation == doctest::Approx(std::sqrt(variance)).epsilon(spread_tolerance));
    CHECK(s.quantiles[1] == doctest::Approx(10.0).epsilon(mean_tolerance));
    CHECK(s.quantiles[2] == doctest::Approx(10.0 + 1.6449 * std::sqrt(variance)).epsilon(spread_tolerance));
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(s.first_order[i] - factor[i] * factor[i] / variance) < share_tolerance);
    }
}

TEST_CASE("sampling: a product of two inputs leaves its joint share to neither") {
    // y = z1 z2: no first-order effect at all.
    constexpr std::size_t count = 1024;
    const std::vector<double> z = normals(2, count);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(z[2 * i] * z[2 * i + 1]);
    const SampleStatistics s = sample_statistics(values, z, 2);
    CHECK(s.first_order[0] < share_tolerance);
    CHECK(s.first_order[1] < share_tolerance);
    CHECK(s.standard_deviation == doctest::Approx(1.0).epsilon(0.1));
}

TEST_CASE("sampling: what does not vary has no spread and no shares whatever its size") {
    const std::vector<double> z = normals(1, 16);
    for (const double value : {0.0, 1.0, -1e300, 1e-300, 3.3e-11}) {
        const SampleStatistics s = sample_statistics(std::vector<double>(16, value), z, 1);
        CHECK(s.mean == doctest::Approx(value));
        CHECK(s.standard_deviation == 0.0);
        CHECK(s.first_order[0] == 0.0);
        CHECK(s.quantiles[0] == value);
    }
}

TEST_CASE(
    "sampling: what is left of correlated normals when some are known is the conditional distribution") {
    // Of three: correlation 0.8 of the first two, 0.5 and 0.6 with the third.
    const std::vector<double> matrix = {1.0, 0.8, 0.5, 0.8, 1.0, 0.6, 0.5, 0.6, 1.0};
    REQUIRE(is_correlation(matrix, 3));
    const ConditionalNormals all = conditional_normals(matrix, {false, false, false});
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(all.spread[i] == doctest::Approx(1.0).epsilon(1e-14));
        for (std::size_t j = 0; j < 3; ++j)
            CHECK(all.correlation(i, j) == doctest::Approx(matrix[i * 3 + j]).epsilon(1e-14));
    }
    // With the second one known: variances 1 - r^2, covariance 0.5 - 0.8*0.6.
    const ConditionalNormals left = conditional_normals(matrix, {false, true, false});
    REQUIRE(left.spread.size() == 2);
    CHECK(left.spread[0] == doctest::Approx(std::sqrt(1.0 - 0.64)).epsilon(1e-14));
    CHECK(left.spread[1] == doctest::Approx(std::sqrt(1.0 - 0.36)).epsilon(1e-14));
    CHECK(left.correlation(0, 1) == doctest::Approx((0.5 - 0.48) / (0.6 * 0.8)).epsilon(1e-12));
    CHECK(conditional_normals(matrix, {true, true, true}).spread.empty());
    // One that another determines is known with it.
    const std::vector<double> same = {1.0, -1.0, -1.0, 1.0};
    CHECK(is_correlation(same, 2));
    CHECK(conditional_normals(same, {true, false}).spread[0] == 0.0);
}

TEST_CASE("sampling: what is no correlation is told apart") {
    CHECK(is_correlation(std::vector<double>{1.0, 0.999999, 0.999999, 1.0}, 2));
    CHECK_FALSE(is_correlation(std::vector<double>{1.0, 1.1, 1.1, 1.0}, 2));
    CHECK_FALSE(is_correlation(std::vector<double>{1.0, 0.5, 0.4, 1.0}, 2));
    CHECK_FALSE(is_correlation(std::vector<double>{2.0, 0.5, 0.5, 1.0}, 2));
    CHECK_FALSE(is_correlation(std::vector<double>{1.0, 0.5, 0.5}, 2));
    // Each pair may be, all three may not: the first two agree and the third agrees with one and opposes the other.
    CHECK_FALSE(is_correlation(std::vector<double>{1.0, 0.9, 0.9, 0.9, 1.0, -0.9, 0.9, -0.9, 1.0}, 3));
}

TEST_CASE("sampling: of inputs that depend on each other a share is what goes when one is known") {
    const std::vector<double> matrix = {1.0, 0.8, 0.8, 1.0};
    const ConditionalNormals pair = conditional_normals(matrix, {false, false});
    const std::vector<double> w = normals(3, 1024);
    std::vector<double> z(w);
    std::vector<double> y;
    for (std::size_t i = 0; i < w.size(); i += 3) {
        z[i + 2] = pair.mixing[2] * w[i + 1] + pair.mixing[3] * w[i + 2];
        y.push_back(1.0 + 0.1 * z[i] + 0.2 * z[i + 1] - 0.1 * z[i + 2]);
    }
    const SampleStatistics s = sample_statistics(y, z, 3, {false, true, true});
    // Variance 0.01 + 0.04 + 0.01 - 2*0.8*0.02; with b known what is left is 0.01 + 0.01 (1 - 0.64).
    const double variance = 0.06 - 0.032;
    CHECK(s.standard_deviation == doctest::Approx(std::sqrt(variance)).epsilon(spread_tolerance));
    CHECK(std::abs(s.first_order[0] - 0.01 / variance) < share_tolerance);
    CHECK(std::abs(s.first_order[1] - (1.0 - 0.0136 / variance)) < share_tolerance);
    CHECK(std::abs(s.first_order[2] - 0.06 * 0.06 / variance) < share_tolerance);
}
