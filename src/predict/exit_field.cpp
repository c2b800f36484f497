#include "predict/exit_field.hpp"

#include <algorithm>
#include <cmath>

#include "predict/exit_kind.hpp"

namespace bioprint {
namespace {

/// From the finite-element radial velocity of α 0, 0.3 and 0.75.
constexpr double sharpest = 0.605;
constexpr double thinning_dulls = 0.23;

}  // namespace

ExitField::ExitField(const NozzleFlow& flow)
    : axis_(flow),
      radius_(flow.radius()),
      velocity_average_(flow.velocity_average()),
      sharpening_(sharpest - thinning_dulls * (1.0 - exit_kind(flow).index)) {
    const double h = radius_ / static_cast<double>(size - 1);
    const auto slope = [&](double r) { return (flow.velocity(r) - velocity_average_) * r; };
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        const double r = h * static_cast<double>(i);
        if (i > 0) sum += h / 6.0 * (slope(r - h) + 4.0 * slope(r - 0.5 * h) + slope(r));
        knots_[i] = {.value = sum,
                     .slope = slope(r),
                     .bend = flow.velocity(r) - velocity_average_ - r * flow.shear_rate(r)};
    }
}

ExitField::Excess ExitField::excess(double r) const {
    const double h = radius_ / static_cast<double>(size - 1);
    const auto i = std::min(static_cast<std::size_t>(r / h), size - 2);
    const double t = r / h - static_cast<double>(i);
    const Excess& a = knots_[i];
    const Excess& b = knots_[i + 1];
    const double d0 = b.value - a.value - h * a.slope - 0.5 * h * h * a.bend;
    const double d1 = h * (b.slope - a.slope - h * a.bend);
    const double d2 = h * h * (b.bend - a.bend);
    const double c3 = 10.0 * d0 - 4.0 * d1 + 0.5 * d2;
    const double c4 = -15.0 * d0 + 7.0 * d1 - d2;
    const double c5 = 6.0 * d0 - 3.0 * d1 + 0.5 * d2;
    return {.value = a.value + t * (h * a.slope + t * (0.5 * h * h * a.bend + t * (c3 + t * (c4 + t * c5)))),
            .slope = a.slope + t * (h * a.bend + t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5)) / h),
            .bend = a.bend + t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5)) / (h * h)};
}

ExitField::Point ExitField::at(double x, double radial_position) const {
    // On the axis itself the quotients by r are limits; a millionth of the radius beside it they are
    // themselves.
    const double r = std::clamp(radial_position, 1e-6 * radius_, radius_);
    const double rho = r / radius_;
    const double s = 1.0 - sharpening_ * rho * rho;
    const double s_r = -2.0 * sharpening_ * rho / radius_;
    const double s_rr = -2.0 * sharpening_ / (radius_ * radius_);
    const double big_x = x / radius_;
    const ExitAxis::Shape f = axis_.shape(big_x / s);
    const Excess d = excess(r);

    const double y_r = -big_x * s_r / (s * s);
    const double y_rr = big_x * (2.0 * s_r * s_r / (s * s * s) - s_rr / (s * s));
    const double y_x = 1.0 / (s * radius_);
    const double y_xr = -s_r / (s * s * radius_);
    const double f_x = f.slope * y_x;
    const double f_r = f.slope * y_r;
    const double f_xx = f.bend * y_x * y_x;
    const double f_xr = f.bend * y_x * y_r + f.slope * y_xr;
    const double f_rr = f.bend * y_r * y_r + f.slope * y_rr;

    const double axial = velocity_average_ + (f.value * d.slope + f_r * d.value) / r;
    const double radial = -f_x * d.value / r;
    const double xx = (f_x * d.slope + f_xr * d.value) / r;
    const double xr = (2.0 * f_r * d.slope + f.value * d.bend + f_rr * d.value) / r -
                      (f.value * d.slope + f_r * d.value) / (r * r);
    const double rx = -f_xx * d.value / r;
    const double tt = radial / r;
    const double rr = -xx - tt;
    const double shear = xr + rx;
    const double square = 2.0 * (xx * xx + rr * rr + tt * tt) + shear * shear;
    return {.axial_velocity = axial,
            .radial_velocity = radial,
            .gradient = {{{xx, xr, 0.0}, {rx, rr, 0.0}, {0.0, 0.0, tt}}},
            .rate = std::sqrt(square),
            .shear_share = square > 0.0 ? shear * shear / square : 0.0};
}

double ExitField::stream(double x, double r) const {
    const double rho = r / radius_;
    return 0.5 * velocity_average_ * r * r +
           axis_.shape(x / radius_ / (1.0 - sharpening_ * rho * rho)).value * excess(r).value;
}

double ExitField::streamline(double radius, double x) const {
    if (radius <= 0.0) return 0.0;
    const double target = 0.5 * velocity_average_ * radius * radius + excess(radius).value;
    double low = 0.0;
    double high = radius_;
    double r = radius;
    for (int i = 0; i < 60; ++i) {
        const double miss = stream(x, r) - target;
        (miss > 0.0 ? high : low) = r;
        double next = r - miss / (r * at(x, r).axial_velocity);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double step = std::abs(next - r);
        r = next;
        if (step < 1e-12 * radius_) break;
    }
    return r;
}

}  // namespace bioprint
