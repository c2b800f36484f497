#include "simulate/ellipsoid_axes.hpp"

#include <algorithm>
#include <cmath>

namespace bioprint {

MirrorEllipsoid mirror_ellipsoid(const Ellipsoid& ellipsoid) {
    int across = 0;
    for (int k = 1; k < 3; ++k) {
        if (std::abs(ellipsoid.directions[k][2]) > std::abs(ellipsoid.directions[across][2])) {
            across = k;
        }
    }
    const int first = across == 0 ? 1 : 0;
    const int second = 3 - first - across;
    const Vector3& d = ellipsoid.directions[first];
    MirrorEllipsoid result{};
    result.semi_axes = {ellipsoid.semi_axes[first], ellipsoid.semi_axes[second], ellipsoid.semi_axes[across]};
    result.angle = std::atan(d[1] / d[0]);
    const double c = std::cos(result.angle);
    const double s = std::sin(result.angle);
    result.axis = {Vector3{c, s, 0.0}, Vector3{-s, c, 0.0}, Vector3{0.0, 0.0, 1.0}};
    return result;
}

double tank_treading_frequency(const Matrix3& gradient, const MirrorEllipsoid& ellipsoid) {
    const double l12 = component(gradient, ellipsoid.axis[0], ellipsoid.axis[1]);
    const double l21 = component(gradient, ellipsoid.axis[1], ellipsoid.axis[0]);
    return std::sqrt(std::max(-l12 * l21, 0.0));
}

}  // namespace bioprint
