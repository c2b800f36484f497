#include "predict/exit_axis.hpp"

#include <algorithm>
#include <cmath>

#include "predict/exit_axis_table.hpp"
#include "predict/exit_series.hpp"

namespace bioprint {
namespace {

/// β(X) from X = −1.4 in steps of 0.1: the r² part of the velocity near the axis of the Newtonian
/// finite-element solution over its value in the nozzle. It leaves as 1 − β = 8e-4 e^((X+1.4)/0.11) and fades
/// as e^(−X/0.31).
constexpr double shear_first = -1.4;
constexpr double shear_step = 0.1;
constexpr std::array<double, 35> shear{0.9992, 0.9979, 0.9956, 0.9915, 0.9848, 0.9741, 0.9577, 0.9339, 0.9011,
                                       0.8588, 0.8082, 0.7527, 0.6971, 0.6461, 0.6013, 0.5603, 0.5183, 0.4708,
                                       0.4166, 0.3576, 0.2976, 0.2408, 0.1901, 0.1470, 0.1117, 0.0837, 0.0621,
                                       0.0456, 0.0332, 0.0241, 0.0174, 0.0125, 0.0089, 0.0064, 0.0045};

/// Cubic through b and c with the slopes their neighbours give.
double cubic(double a, double b, double c, double d, double t) {
    const double m = 0.5 * (c - a);
    const double n = 0.5 * (d - b);
    return b + t * (m + t * (3.0 * (c - b) - 2.0 * m - n + t * (2.0 * (b - c) + m + n)));
}

double shear_part(double x) {
    const double u = (x - shear_first) / shear_step;
    if (u <= 0.0) return 1.0 - (1.0 - shear.front()) * std::exp(shear_step * u / 0.11);
    const auto last = static_cast<double>(shear.size() - 1);
    if (u >= last) return shear.back() * std::exp(-shear_step * (u - last) / 0.31);
    const auto i = std::min(static_cast<std::size_t>(u), shear.size() - 2);
    return cubic(i > 0 ? shear[i - 1] : 1.0, shear[i], shear[i + 1], shear[std::min(i + 2, shear.size() - 1)],
                 u - static_cast<double>(i));
}

ExitNodes nodes_of(const ExitKind& kind) {
    const ExitTerms terms = exit_terms(kind);
    ExitNodes nodes = exit_newtonian;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        for (std::size_t k = 0; k < nodes.size(); ++k) nodes[k] += terms[i] * exit_thinning[i][k];
    }
    return nodes;
}

}  // namespace

ExitAxis::ExitAxis(const NozzleFlow& flow)
    : radius_(flow.radius()),
      velocity_average_(flow.velocity_average()),
      velocity_excess_(flow.velocity_excess()),
      pressure_gradient_(flow.pressure_gradient()) {
    const ExitKind kind = exit_kind(flow);
    extrapolated_ = beyond_exit_table(kind);
    const ExitSpline spline(nodes_of(kind));
    std::size_t piece = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const ExitSpline::Point y = spline.at(first + step * static_cast<double>(i), piece);
        const ExitShare f = exit_share(y.logit);
        knots_[i] = {.value = f.value,
                     .slope = f.slope * y.slope * step,
                     .bend = (f.slope * y.bend + f.bend * y.slope * y.slope) * step * step};
    }
}

ExitAxis::Shape ExitAxis::shape(double x_over_radius) const {
    const double position = (std::clamp(x_over_radius, first, last) - first) / step;
    const auto i = std::min(static_cast<std::size_t>(position), size - 2);
    const double t = position - static_cast<double>(i);
    const Knot& a = knots_[i];
    const Knot& b = knots_[i + 1];
    // The polynomial of degree five with the knots' values, slopes and bends.
    const double d0 = b.value - a.value - a.slope - 0.5 * a.bend;
    const double d1 = b.slope - a.slope - a.bend;
    const double d2 = b.bend - a.bend;
    const double c3 = 10.0 * d0 - 4.0 * d1 + 0.5 * d2;
    const double c4 = -15.0 * d0 + 7.0 * d1 - d2;
    const double c5 = 6.0 * d0 - 3.0 * d1 + 0.5 * d2;
    return {.value = a.value + t * (a.slope + t * (0.5 * a.bend + t * (c3 + t * (c4 + t * c5)))),
            .slope = (a.slope + t * (a.bend + t * (3.0 * c3 + t * (4.0 * c4 + t * 5.0 * c5)))) / step,
            .bend = (a.bend + t * (6.0 * c3 + t * (12.0 * c4 + t * 20.0 * c5))) / (step * step)};
}

AxisFlow ExitAxis::operator()(double x) const {
    const Shape f = shape(x / radius_);
    return {.velocity = velocity_average_ + velocity_excess_ * f.value,
            .elongation = velocity_excess_ * f.slope / radius_,
            .axial = 0.5 * velocity_excess_ * f.bend / (radius_ * radius_),
            .radial = -0.25 * pressure_gradient_ * shear_part(x / radius_)};
}

}  // namespace bioprint
