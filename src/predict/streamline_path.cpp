#include "predict/streamline_path.hpp"

#include <algorithm>
#include <cmath>

#include "predict/resting_ink.hpp"

namespace bioprint {
namespace {

constexpr double fine = 0.4;  // of the radius: the length over which steps are even

enum Column : std::size_t {
    xx,
    xr,
    rx,
    tt,
    thick,
    radius,
    slowness,
    viscous,
    strain_rate,
    share,
    longer,
    linear,
    slipping
};

}  // namespace

StreamlinePath::StreamlinePath(const ExitField& field, const NozzleFlow& flow, const SizeEffect& size,
                               double start_radius)
    : scale_(fine * field.radius()),
      first_(std::asinh(-before / fine)),
      step_((std::asinh(after / fine) - first_) / static_cast<double>(knots - 1)),
      logarithmic_(!has_rest_viscosity(flow.ink())) {
    const double least = least_rate(flow);
    double r = field.streamline(start_radius, -before * field.radius());
    const double stream = field.nozzle_flux(start_radius);
    double drift = 0.0;  // dr/ds
    double drift_before = 0.0;
    double velocity = 0.0;
    for (std::size_t i = 0; i < knots; ++i) {
        const double s = first_ + step_ * static_cast<double>(i);
        const double x = scale_ * std::sinh(s);
        if (i > 0 && start_radius > 0.0) {
            // From the two knots before, then onto the stream function.
            r += step_ * (i > 1 ? 1.5 * drift - 0.5 * drift_before : drift);
            r = std::clamp(r, 0.0, field.radius());
            for (int j = 0; j < 2; ++j) {
                r = std::clamp(r - (field.stream(x, r) - stream) / (r * velocity), 0.5 * r,
                               std::min(2.0 * r, field.radius()));
            }
        }
        const ExitField::Point p = field.at(x, r);
        const double per_s = scale_ * std::cosh(s) / p.axial_velocity;
        drift_before = drift;
        drift = p.radial_velocity * per_s;
        velocity = p.axial_velocity;
        const double eta = viscosity(flow.ink(), std::max(p.rate, least));
        const SizeEffect::Effect effect = size.at(x);
        const double stretch = (1.0 - p.shear_share) * effect.log_stretch;
        value_[i] = {p.gradient[0][0] * per_s,
                     p.gradient[0][1] * per_s,
                     p.gradient[1][0] * per_s,
                     p.gradient[2][2] * per_s,
                     logarithmic_ ? std::log(eta / per_s) : eta / per_s,
                     r,
                     per_s,
                     logarithmic_ ? std::log(eta) : eta,
                     p.rate,
                     p.shear_share,
                     std::expm1(2.0 * stretch),
                     effect.linear,
                     per_s * p.axial_velocity / SizeEffect::velocity(p.axial_velocity, effect.slip)};
    }
    for (std::size_t c = 0; c < columns; ++c) {
        const auto v = [&](std::size_t i) { return value_[i][c]; };
        // Of fourth order inside, of second at the ends, where nothing changes any more.
        for (std::size_t i = 2; i + 2 < knots; ++i)
            slope_[i][c] = (8.0 * (v(i + 1) - v(i - 1)) - (v(i + 2) - v(i - 2))) / 12.0;
        slope_[1][c] = 0.5 * (v(2) - v(0));
        slope_[0][c] = 2.0 * (v(1) - v(0)) - slope_[1][c];
        slope_[knots - 2][c] = 0.5 * (v(knots - 1) - v(knots - 3));
        slope_[knots - 1][c] = 2.0 * (v(knots - 1) - v(knots - 2)) - slope_[knots - 2][c];
    }
}

double StreamlinePath::at_position(double x) const {
    return std::asinh(x / scale_);
}

double StreamlinePath::position(double s) const {
    return scale_ * std::sinh(s);
}

double StreamlinePath::stride(double s) const {
    return scale_ * std::cosh(s);
}

StreamlinePath::Spot StreamlinePath::spot(double s) const {
    const double u = std::clamp((s - first_) / step_, 0.0, static_cast<double>(knots - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(u), knots - 2);
    return {.index = i, .part = u - static_cast<double>(i)};
}

double StreamlinePath::read(const Spot& at, std::size_t column) const {
    const double a = value_[at.index][column];
    const double d = value_[at.index + 1][column] - a;
    const double m = slope_[at.index][column];
    const double n = slope_[at.index + 1][column];
    const double t = at.part;
    return a + t * (m + t * (3.0 * d - 2.0 * m - n + t * (m + n - 2.0 * d)));
}

double StreamlinePath::read_positive(const Spot& at, std::size_t column) const {
    return logarithmic_ ? std::exp(read(at, column)) : read(at, column);
}

PlanarFlow StreamlinePath::flow(double s) const {
    const Spot at = spot(s);
    const double along = read(at, xx);
    const double around = read(at, tt);
    return {.xx = along,
            .xr = read(at, xr),
            .rx = read(at, rx),
            .rr = -along - around,
            .tt = around,
            .viscosity = read_positive(at, thick)};
}

StreamlinePath::Place StreamlinePath::place(double s) const {
    const Spot at = spot(s);
    return {.radius = read(at, radius),
            .slowness = read(at, slowness),
            .viscosity = read_positive(at, viscous),
            .rate = std::max(0.0, read(at, strain_rate)),
            .shear_share = std::clamp(read(at, share), 0.0, 1.0)};
}

StreamlinePath::Size StreamlinePath::size(double s) const {
    const Spot at = spot(s);
    return {.square_stretch = read(at, longer), .linear = read(at, linear)};
}

double StreamlinePath::cell_slowness(double s) const {
    return read(spot(s), slipping);
}

}  // namespace bioprint
