#include "numerics/least_squares.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

/// y = a + b t at t = 0, 1, …: normal equations by hand.
struct Line {
    std::vector<double> y;
    void operator()(std::span<const double> x, std::span<double> r, std::span<double> j) const {
        for (std::size_t i = 0; i < y.size(); ++i) {
            const auto t = static_cast<double>(i);
            if (!r.empty()) r[i] = x[0] + x[1] * t - y[i];
            if (j.empty()) continue;
            j[2 * i] = 1.0;
            j[2 * i + 1] = t;
        }
    }
};

constexpr double rounding = 1e-9;

}  // namespace

TEST_CASE(
    "least squares: a line through four points has the solution and covariance of the normal equations") {
    const Line line{{1.0, 2.0, 2.0, 5.0}};
    const LeastSquaresFit fit =
        fit_least_squares({.points = 4, .parameters = 2, .evaluate = line}, std::vector<double>{0.0, 0.0});
    // Σt = 6, Σt² = 14, Σy = 10, Σty = 21: b = (4·21 − 6·10)/(4·14 − 36) = 1.2, a = 0.7
    CHECK(fit.x[0] == doctest::Approx(0.7).epsilon(rounding));
    CHECK(fit.x[1] == doctest::Approx(1.2).epsilon(rounding));
    CHECK(fit.covariance[0] == doctest::Approx(14.0 / 20.0).epsilon(rounding));
    CHECK(fit.covariance[1] == doctest::Approx(-6.0 / 20.0).epsilon(rounding));
    CHECK(fit.covariance[3] == doctest::Approx(4.0 / 20.0).epsilon(rounding));
    CHECK(fit.cost == doctest::Approx(1.8).epsilon(rounding));
    CHECK(fit.converged);
}

TEST_CASE("least squares: a weight of two is the point measured twice") {
    const Line once{{1.0, 2.0, 2.0, 5.0}};
    const LeastSquaresFit weighted =
        fit_least_squares({.points = 4, .parameters = 2, .evaluate = once}, std::vector<double>{0.0, 0.0},
                          std::vector<double>{1.0, 1.0, 1.0, 2.0});
    // With t = 3, y = 5 twice: Σ1 = 5, Σt = 9, Σt² = 23, Σy = 15, Σty = 36
    CHECK(weighted.x[1] == doctest::Approx((5.0 * 36 - 9.0 * 15) / (5.0 * 23 - 81)).epsilon(rounding));
    CHECK(weighted.covariance[3] == doctest::Approx(5.0 / 34.0).epsilon(rounding));
}

TEST_CASE("least squares: a curved valley is followed to its end") {
    // Rosenbrock's: residuals 10 (x1 − x0²) and 1 − x0.
    const auto valley = [](std::span<const double> x, std::span<double> r, std::span<double> j) {
        if (!r.empty()) {
            r[0] = 10.0 * (x[1] - x[0] * x[0]);
            r[1] = 1.0 - x[0];
        }
        if (j.empty()) return;
        j[0] = -20.0 * x[0];
        j[1] = 10.0;
        j[2] = -1.0;
        j[3] = 0.0;
    };
    const LeastSquaresFit fit =
        fit_least_squares({.points = 2, .parameters = 2, .evaluate = valley}, std::vector<double>{-1.2, 1.0});
    CHECK(fit.x[0] == doctest::Approx(1.0).epsilon(rounding));
    CHECK(fit.x[1] == doctest::Approx(1.0).epsilon(rounding));
}

TEST_CASE("least squares: a parameter without influence has an infinite variance") {
    const auto blind = [](std::span<const double> x, std::span<double> r, std::span<double> j) {
        for (std::size_t i = 0; i < 5; ++i) {
            if (!r.empty()) r[i] = x[0] - static_cast<double>(i);
            if (!j.empty()) {
                j[2 * i] = 1.0;
                j[2 * i + 1] = 0.0;
            }
        }
    };
    const LeastSquaresFit fit =
        fit_least_squares({.points = 5, .parameters = 2, .evaluate = blind}, std::vector<double>{0.0, 7.0});
    CHECK(fit.x[0] == doctest::Approx(2.0).epsilon(rounding));
    CHECK(std::isinf(fit.covariance[3]));
}

TEST_CASE("least squares: the robust fit lets a third of the points be anything") {
    Line line{{}};
    for (int i = 0; i < 30; ++i) line.y.push_back(1.0 + 0.5 * i + 0.01 * ((i * 7) % 5 - 2));
    for (const int i : {0, 3, 6, 9, 12, 15, 18, 21, 24, 27}) line.y[static_cast<std::size_t>(i)] += 40.0;
    const LeastSquaresFit fit = fit_robustly({.points = 30, .parameters = 2, .evaluate = line},
                                             std::vector<double>{1.5, 0.4}, {}, 1e-3);
    CHECK(fit.x[0] == doctest::Approx(1.0).epsilon(0.02));
    CHECK(fit.x[1] == doctest::Approx(0.5).epsilon(0.002));
}

TEST_CASE("least squares: fewer points than parameters or a start without residuals is refused") {
    const Line line{{1.0}};
    CHECK_THROWS_AS(
        fit_least_squares({.points = 1, .parameters = 2, .evaluate = line}, std::vector<double>{0.0, 0.0}),
        NotConverged);
    const Line four{{1.0, 2.0, 3.0, 4.0}};
    CHECK_THROWS_AS(fit_least_squares({.points = 4, .parameters = 2, .evaluate = four},
                                      std::vector<double>{std::nan(""), 0.0}),
                    NotConverged);
}

TEST_CASE("least squares: quantiles of Student match the tables") {
    CHECK(student_t(0.975, 10.0) == doctest::Approx(2.228138852).epsilon(1e-8));
    CHECK(student_t(0.975, 1.0) == doctest::Approx(12.70620474).epsilon(1e-8));
}
