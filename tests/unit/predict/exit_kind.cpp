#include "predict/exit_kind.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace bioprint;

namespace {

NozzleFlow nozzle(const CrossInk& ink) {
    return NozzleFlow::from_velocity(ink, 50e-6, 5e-3);
}

}  // namespace

TEST_CASE("exit kind: deep in the power law both numbers are its exponent") {
    for (const double n : {0.2, 0.5, 0.8}) {
        const ExitKind kind = exit_kind(nozzle({.eta0 = 1e6, .time_constant = 1e12, .alpha = 1.0 - n}));
        CHECK(kind.index == doctest::Approx(n).epsilon(2e-3));
        CHECK(kind.wall_index == doctest::Approx(n).epsilon(2e-3));
    }
}

TEST_CASE("exit kind: a Newtonian ink and an ink at rest have both numbers 1") {
    const ExitKind newtonian = exit_kind(nozzle({.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.0}));
    CHECK(newtonian.index == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(newtonian.wall_index == doctest::Approx(1.0).epsilon(1e-12));
    const ExitKind resting = exit_kind(
        NozzleFlow::from_velocity({.eta0 = 10.0, .time_constant = 0.05, .alpha = 0.75}, 50e-6, 0.0));
    CHECK(resting.index == 1.0);
    CHECK(resting.wall_index == 1.0);
}

TEST_CASE("exit kind: weak thinning leaves the ratio of the two that its exponent has") {
    // To first order in X = (K γ̇_w)^α: 1 − n_w = α X and 1 − n_e = 8αX/((2+α)(4+α)).
    for (const double alpha : {0.3, 0.6, 0.95}) {
        const ExitKind kind =
            exit_kind(nozzle({.eta0 = 10.0, .time_constant = std::pow(1e-8, 1.0 / alpha), .alpha = alpha}));
        CHECK((1.0 - kind.wall_index) / (1.0 - kind.index) ==
              doctest::Approx((2.0 + alpha) * (4.0 + alpha) / 8.0).epsilon(1e-3));
    }
}
