#include "cell/shear_curve.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "bioprint/cell/shape_integrals.hpp"
#include "numerics/roots.hpp"

namespace {

using namespace bioprint;

/// The same point by adaptive quadrature and Brent's root search.
ShearCurve by_quadrature(const AxisRatio& r) {
    const double z = log_ratio(r);
    const auto squares = [&](double ell) {
        return std::array<double, 3>{1.0, r.s * r.s, std::exp(-2.0 * r.delta * ell)};
    };
    const double ell = find_root(
        [&](double x) {
            const ShapeIntegrals g = shape_integrals_adaptive(squares(x)).value;
            const double top = -std::expm1(-2.0 * r.delta * x);
            const double bottom = r.s * r.s * std::expm1(2.0 * (z - r.delta * x));
            return top * g.second[1] - bottom * g.second[0];
        },
        {.low = 0.45, .high = 1.6}, {.absolute = 1e-15, .relative = 1e-15});
    const ShapeIntegrals g = shape_integrals_adaptive(squares(ell)).value;
    const double third = std::exp(-r.delta * ell);
    const auto& b = g.second;
    return {.lean = (ell - 0.5) / r.delta,
            .slip = (1.0 - 0.5 * (1.0 + r.s * r.s) * r.s * third * g.first[2]) / r.s,
            .bearing = (b[0] * b[1] + b[1] * b[2] + b[2] * b[0]) / (b[0] + b[1])};
}

}  // namespace

TEST_CASE("shear curve: the table repeats what quadrature and root search give") {
    // The quadrature's 1e-13 is divided by δ in `lean` and by s in `slip`.
    for (const double s : {0.99, 0.9, 0.7, 0.45, 0.2, 0.08, 0.02, 5e-3, 1e-3}) {
        const AxisRatio r{.s = s, .delta = 1.0 - s};
        const ShearCurve table = shear_curve(r);
        const ShearCurve exact = by_quadrature(r);
        CHECK(std::abs(table.lean - exact.lean) < 2e-12 / r.delta);
        CHECK(std::abs(table.slip - exact.slip) < 1e-12 / r.s);
        CHECK(std::abs(table.bearing / exact.bearing - 1.0) < 1e-12);
    }
}

TEST_CASE("shear curve: the sphere's end has the small-strain values") {
    const ShearCurve c = shear_curve({.s = 1.0, .delta = 0.0});
    CHECK(c.lean == doctest::Approx(3.0 / 14.0).epsilon(1e-14));
    CHECK(c.slip == doctest::Approx(0.6).epsilon(1e-14));
    CHECK(c.bearing == doctest::Approx(0.4).epsilon(1e-14));
}

TEST_CASE("shear curve: ln s and its excess over delta agree across the switch of formulas") {
    for (const double delta : {1e-12, 1e-3, 0.0999, 0.1001, 0.4, 0.7}) {
        const AxisRatio r{.s = 1.0 - delta, .delta = delta};
        CHECK(log_ratio(r) == doctest::Approx(-std::log1p(-delta)).epsilon(1e-15));
        const long double d = delta;
        const long double excess = -std::log1p(-d) - d;
        const double accuracy = 1e-15 + 1e-19 / (delta * delta);  // the long double reference cancels too
        CHECK(std::abs(log_ratio_excess(r) / static_cast<double>(excess) - 1.0) <
              std::fmax(2e-15, 10 * accuracy));
    }
    CHECK(log_ratio_excess({.s = 1.0, .delta = 1e-9}) == doctest::Approx(0.5e-18).epsilon(1e-8));
}
