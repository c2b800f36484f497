#pragma once

#include <array>

#include "solid/tetra_solid.hpp"

/// The equivalent ellipsoid of a body with a mirror plane z = 0, and tensors seen in its axes.
namespace bioprint {

struct MirrorEllipsoid {
    std::array<double, 3>
        semi_axes;  ///< the longer and the shorter in the mirror plane, and the one across it
    double angle;   ///< of the first to x, in (−π/2, π/2]
    std::array<Vector3, 3> axis;
};

inline double component(const Matrix3& m, const Vector3& a, const Vector3& b) {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            sum += a[i] * m[i][k] * b[k];
        }
    }
    return sum;
}

MirrorEllipsoid mirror_ellipsoid(const Ellipsoid& ellipsoid);

/// Angular frequency of a tank-treading interior of a mean velocity gradient: in the ellipsoid's axes
/// ∂u1/∂x2 = ∓ν α1/α2 and ∂u2/∂x1 = ±ν α2/α1. Zero when it does not turn.
double tank_treading_frequency(const Matrix3& gradient, const MirrorEllipsoid& ellipsoid);

}  // namespace bioprint
