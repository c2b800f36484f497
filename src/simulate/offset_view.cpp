#include "simulate/offset_view.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"

namespace bioprint {

OffsetUnits offset_units(const OffsetCell& cell, const NozzleFlow& flow) {
    constexpr double fastest = 0.08;
    constexpr double reynolds = 0.5;
    constexpr double stiffest = 0.02;
    const double dx = cell.radius / cell.nodes;
    const double wall_rate = flow.shear_rate_max();
    const double eta0 = flow.ink().eta0;
    const double thinning = viscosity(flow.ink(), wall_rate) / eta0;
    const double square = cell.nodes * cell.nodes;
    // μ_lu = nu0 dt/s with s = η0/μ. Each limit bounds dt for a given nu0; nu0 is chosen so that the last two
    // meet.
    const double s = eta0 / cell.shear_modulus;
    const double nu0 =
        std::clamp(std::sqrt(stiffest * s * wall_rate * square / (reynolds * thinning)), 0.5, 4.0);
    struct Limit {
        double step;
        const char* name;
    };
    const std::array<Limit, 3> limits{{{fastest * dx / flow.velocity_max(), "velocity"},
                                       {reynolds * thinning * nu0 / (wall_rate * square), "unsteadiness"},
                                       {stiffest * s / nu0, "elastic waves"}}};
    const Limit& tightest = *std::min_element(limits.begin(), limits.end(),
                                              [](const Limit& a, const Limit& b) { return a.step < b.step; });
    const double dt = tightest.step;
    return {dx, dt, nu0, eta0 / (nu0 * dt), tightest.name};
}

OffsetLattice lattice_report(const OffsetUnits& units, const NozzleFlow& flow, const OffsetCell& cell,
                             int length) {
    const double thinning = viscosity(flow.ink(), flow.shear_rate_max()) / flow.ink().eta0;
    const double velocity = flow.velocity_average() * units.time / units.spacing;
    const double radius = flow.radius() / units.spacing;
    return {.spacing = units.spacing,
            .time_step = units.time,
            .radius = radius,
            .length = length,
            .velocity = velocity,
            .viscosity = units.nu0,
            .wall_reynolds = velocity * radius / (units.nu0 * thinning),
            .shear_modulus = cell.shear_modulus / units.stress,
            .binding = units.binding};
}

template <class Real>
OffsetView<Real>::OffsetView(const D3q19<Real>& lattice, const ImmersedBody<Real>& body,
                             const MirrorEllipsoid& rest)
    : lattice_(lattice),
      body_(body),
      rest_(rest),
      state_(body.state()),
      now_(mirror_ellipsoid(state_.ellipsoid)) {
    if (!std::isfinite(state_.von_mises) || !std::isfinite(state_.volume)) {
        throw NotConverged("the cell's stress is no longer a number");
    }
}

template <class Real>
std::array<double, 3> OffsetView<Real>::stretch() const {
    std::array<double, 3> ratio{};
    for (int k = 0; k < 3; ++k) {
        ratio[k] = now_.semi_axes[k] / rest_.semi_axes[k];
    }
    return ratio;
}

namespace {

/// Half the width of an ellipsoid with its third axis across the plane, along x or y.
double half_width(const MirrorEllipsoid& e, int direction) {
    return std::hypot(e.semi_axes[0] * e.axis[0][direction], e.semi_axes[1] * e.axis[1][direction]);
}

}  // namespace

template <class Real>
double OffsetView<Real>::axial_stretch() const {
    return half_width(now_, 0) / half_width(rest_, 0);
}

template <class Real>
double OffsetView<Real>::radial_stretch() const {
    return half_width(now_, 1) / half_width(rest_, 1);
}

template <class Real>
double OffsetView<Real>::frequency() const {
    return tank_treading_frequency(body_.solid().mean_gradient(body_.positions(), body_.velocities()), now_);
}

template <class Real>
double OffsetView<Real>::viscous_stress() const {
    const Section& section = lattice_.section();
    const Vector3& c = centre();
    const double longest = *std::max_element(now_.semi_axes.begin(), now_.semi_axes.end());
    const int reach = static_cast<int>(std::ceil(longest)) + 1;
    const int y0 = static_cast<int>(std::floor(c[1] + section.origin_y));
    const int x0 = static_cast<int>(std::floor(c[0]));
    const int nx = lattice_.nx();
    double sum = 0.0;
    long count = 0;
    for (int z = 0; z < std::min(reach, section.nz); ++z) {
        for (int y = y0 - reach; y <= y0 + reach; ++y) {
            const int row = lattice_.row(y, z);
            for (int x = x0 - reach; row >= 0 && x <= x0 + reach; ++x) {
                const Vector3 d{x + 0.5 - c[0], section.y_of(y) - c[1], section.z_of(z)};
                double inside = 0.0;
                for (int k = 0; k < 3; ++k) {
                    const Vector3& axis = now_.axis[k];
                    const double along = axis[0] * d[0] + axis[1] * d[1] + axis[2] * d[2];
                    inside += along * along / (now_.semi_axes[k] * now_.semi_axes[k]);
                }
                if (inside <= 1.0) {
                    const auto s = lattice_.at(((x % nx) + nx) % nx, row).viscous_stress;
                    const Matrix3 m{{{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}}};
                    sum += component(m, now_.axis[0], now_.axis[1]);
                    ++count;
                }
            }
        }
    }
    return count > 0 ? sum / count : 0.0;
}

template class OffsetView<float>;
template class OffsetView<double>;

}  // namespace bioprint
