#pragma once

#include <array>

/// Shape integrals of an ellipsoid in creeping flow (Jeffery 1922, Eshelby 1957, Roscoe 1967).
///
/// With semi-axes α_i in units of the undeformed radius and Δ(λ)² = (α1²+λ)(α2²+λ)(α3²+λ),
///
///   g_i'  = ∫_0^∞   dλ / ((α_j²+λ)(α_k²+λ) Δ)      g_i'' = ∫_0^∞ λ dλ / ((α_j²+λ)(α_k²+λ) Δ)      (i, j, k)
///   cyclic
///
/// Sphere: g' = 2/5, g'' = 4/15. Closed forms exist (Carlson's R_D) but lose digits wherever two axes are
/// close, which is where cells are. In s = ln λ the integrands are positive, analytic in |Im s| < π and decay
/// exponentially at both ends, so equal steps converge geometrically, the same for spheres, needles and
/// discs.
///
/// Accuracy: 2e-15 relative for axis ratios up to 1e12.                 tests/verify/shape_integrals.cpp
/// Cost: below 1 µs for moderate ratios, growing with their logarithm.  tests/bench/cell.cpp
namespace bioprint {

struct ShapeIntegrals {
    std::array<double, 3> first;   ///< g_i'
    std::array<double, 3> second;  ///< g_i''
};

/// @param squares  α_i², > 0, in any order; their ratios up to 1e60
ShapeIntegrals shape_integrals(const std::array<double, 3>& squares);

/// The same to 1e-7 relative in a third of the time: enough inside an integration in time.
ShapeIntegrals shape_integrals_brief(const std::array<double, 3>& squares);

struct CheckedShapeIntegrals {
    ShapeIntegrals value;
    double relative_error;  ///< the largest relative error the quadrature estimates for any of the six
};

/// The same by adaptive Gauss-Kronrod quadrature (GSL), which estimates its own error. A thousand times
/// slower: the reference the fast routes are checked against.
/// @throws NotConverged  the quadrature gave up
CheckedShapeIntegrals shape_integrals_adaptive(const std::array<double, 3>& squares);

}  // namespace bioprint
