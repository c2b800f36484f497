#include <doctest/doctest.h>

#include <cmath>

#include "numerics/dormand_prince.hpp"
#include "numerics/rosenbrock.hpp"

namespace {

using namespace bioprint;

const auto go_on = [](const auto&) { return true; };

/// A pendulum driven in time, with a known solution: y = sin(x²), y' = 2x cos(x²).
OdeState<2> driven(double x, const OdeState<2>& y) {
    return {y[1], 2.0 * std::cos(x * x) - 4.0 * x * x * y[0]};
}

template <typename Method>
double error_at(double tolerance, Method&& method) {
    const OdeOptions options{.tolerance = tolerance, .first_step = 1e-3};
    const auto done = method(driven, 0.0, 3.0, OdeState<2>{0.0, 0.0}, OdeState<2>{1.0, 1.0}, options);
    return std::abs(done.y[0] - std::sin(9.0));
}

}  // namespace

TEST_CASE("ode: the error of Dormand and Prince's pair follows its tolerance") {
    const auto method = [](auto&&... a) { return dormand_prince<2>(a..., go_on); };
    for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10})
        CHECK(error_at(tolerance, method) < 100.0 * tolerance);
    CHECK(error_at(1e-4, method) > 1e-7);  // the tolerance decides, not a step so small that it never bites
}

TEST_CASE("ode: the error of the Rosenbrock method follows its tolerance") {
    const auto method = [](auto&&... a) { return rosenbrock<2>(a..., go_on); };
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) CHECK(error_at(tolerance, method) < 300.0 * tolerance);
    CHECK(error_at(1e-4, method) > 1e-8);
}

TEST_CASE("ode: the Rosenbrock method is of fourth order and its extension of third") {
    // Steps of one length, forced by first_step and a tolerance that never bites; y = tan(x + x²/2).
    const auto f = [](double x, const OdeState<1>& y) {
        return OdeState<1>{(1.0 + x) * (1.0 + y[0] * y[0])};
    };
    const auto linearise = [&](double x, const OdeState<1>& y, double) {
        return Linearised<1>{
            .value = f(x, y), .jacobian = {{{2.0 * (1.0 + x) * y[0]}}}, .in_x = {1.0 + y[0] * y[0]}};
    };
    const auto solution = [](double x) { return std::tan(x + 0.5 * x * x); };
    struct Errors {
        double end;
        double between;
    };
    const auto run = [&](int n) {
        const double h = 0.8 / n;
        OdeState<1> y{0.0};
        Errors errors{};
        for (int i = 0; i < n; ++i) {
            const auto keep = [&](const OdeStep<1>& s) {
                errors.between = std::abs(s.at(0.3)[0] - solution(s.from + 0.3 * h));
                return true;
            };
            const OdeOptions options{.tolerance = 1e9, .first_step = h};
            y = rosenbrock<1>(f, linearise, i * h, (i + 1) * h, y, {1.0}, options, keep).y;
        }
        errors.end = std::abs(y[0] - solution(0.8));
        return errors;
    };
    const Errors e1 = run(64);
    const Errors e2 = run(128);
    const Errors e3 = run(256);
    MESSAGE("errors " << e1.end << " " << e2.end << " " << e3.end << ", of the extension " << e1.between
                      << " " << e2.between << " " << e3.between);
    CHECK(std::log2(e1.end / e2.end) == doctest::Approx(4.0).epsilon(0.1));
    CHECK(std::log2(e2.end / e3.end) == doctest::Approx(4.0).epsilon(0.1));
    // A step of the extension's order 3 leaves an error of order 4.
    CHECK(std::log2(e1.between / e2.between) > 3.6);
    CHECK(std::log2(e2.between / e3.between) > 3.6);
}

TEST_CASE("ode: Dormand and Prince's pair is of fifth order and its extension of fourth") {
    // Steps of one length, forced by first_step and a tolerance that never bites; y = sin(x²) up to x = 2.
    struct Errors {
        double end;
        double middle;
    };
    const auto run = [](int n) {
        const double h = 2.0 / n;
        OdeState<2> y{0.0, 0.0};
        Errors errors{};
        for (int i = 0; i < n; ++i) {
            const auto keep = [&](const OdeStep<2>& s) {
                const double x = s.from + 0.5 * h;
                errors.middle = std::abs(s.at(0.5)[0] - std::sin(x * x));
                return true;
            };
            y = dormand_prince<2>(driven, i * h, (i + 1) * h, y, {1.0, 1.0},
                                  {.tolerance = 1e9, .first_step = h}, keep)
                    .y;
        }
        errors.end = std::abs(y[0] - std::sin(4.0));
        return errors;
    };
    const Errors e1 = run(64);
    const Errors e2 = run(128);
    const Errors e3 = run(256);
    MESSAGE("errors " << e1.end << " " << e2.end << " " << e3.end << ", of the extension " << e1.middle << " "
                      << e2.middle << " " << e3.middle);
    CHECK(std::log2(e1.end / e2.end) > 4.6);
    CHECK(std::log2(e2.end / e3.end) > 4.6);
    CHECK(std::log2(e1.middle / e2.middle) > 3.6);
    CHECK(std::log2(e2.middle / e3.middle) > 3.6);
}

TEST_CASE("ode: a stiff equation takes the implicit method few steps and its fast part no error") {
    const auto f = [](double x, const OdeState<1>& y) { return OdeState<1>{-1e9 * (y[0] - std::sin(x))}; };
    const auto done =
        rosenbrock<1>(f, 0.0, 2.0, {1.0}, {1.0}, {.tolerance = 1e-6, .first_step = 1e-3}, go_on);
    CHECK(done.finished);
    CHECK(done.steps < 400);
    CHECK(done.y[0] == doctest::Approx(std::sin(2.0)).epsilon(1e-6));
}

TEST_CASE("ode: a right side that is no number ends the integration and says so") {
    const auto f = [](double, const OdeState<1>& y) {
        return OdeState<1>{y[0] > 0.5 ? std::sqrt(-1.0) : 1.0};
    };
    const OdeOptions options{.tolerance = 1e-6, .first_step = 0.01};
    CHECK(!dormand_prince<1>(f, 0.0, 2.0, {0.0}, {1.0}, options, go_on).finished);
    CHECK(!rosenbrock<1>(f, 0.0, 2.0, {0.0}, {1.0}, options, go_on).finished);
}
