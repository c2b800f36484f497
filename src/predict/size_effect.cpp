#include "predict/size_effect.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/bullet.hpp"
#include "predict/resting_ink.hpp"
#include "predict/streamline_path.hpp"

namespace bioprint {

double combined_stress(double uniform, double linear, double shear_part) {
    if (linear <= 0.0) return std::sqrt(std::max(0.0, (uniform - linear) * (uniform + linear)));
    const double u = uniform * uniform;
    const double l = linear * linear;
    return std::sqrt(u + l * (1.0 - 0.5 * shear_part * u / (u + l)));
}

SizeEffect::SizeEffect(const NozzleFlow& flow, const AxisCell& cell)
    : first_(-StreamlinePath::before * flow.radius()),
      step_((StreamlinePath::before + StreamlinePath::after) * flow.radius() /
            static_cast<double>(knots - 1)),
      nozzle_linear_(inside_plug(flow, cell.radius)
                         ? 0.0
                         : bullet({.pressure_gradient = flow.pressure_gradient(),
                                   .viscosity = viscosity(flow.ink(), least_rate(flow)),
                                   .cell_radius = cell.radius,
                                   .shear_modulus = cell.shear_modulus})
                               .von_mises) {
    ExitPassageRequest request = exit_passage_request(flow, cell);
    keeps_shape_ = request.effects.quadratic_share == 1.0;
    request.observe_every = step_;
    std::size_t i = 0;
    std::array<double, knots> time{};
    axis_ = exit_passage(flow, request, [&](const AxisCellState& s) {
        if (i >= knots) return;
        const double axial = s.axial_stretch;
        const double uniform = cell.shear_modulus * (axial * axial - 1.0 / axial);
        const double square = (s.von_mises - uniform) * (s.von_mises + uniform);
        time[i] = s.time;
        value_[i++] = {.log_stretch = std::log(axial),
                       .linear = std::copysign(std::sqrt(std::abs(square)), square),
                       .slip = 0.0};
    });
    request.effects = {.volume_average = false, .quadratic_flow = false, .disturbed_viscosity = false};
    i = 0;
    std::array<double, knots> time_of_ink{};
    exit_passage(flow, request, [&](const AxisCellState& s) {
        if (i >= knots) return;
        value_[i].log_stretch -= std::log(s.axial_stretch);
        time_of_ink[i++] = s.time;
    });
    for (i = 1; i + 1 < knots; ++i) {
        value_[i].slip =
            2.0 * step_ *
            (1.0 / (time_of_ink[i + 1] - time_of_ink[i - 1]) - 1.0 / (time[i + 1] - time[i - 1]));
    }
    value_.front().slip = value_[1].slip;
    value_.back().slip = value_[knots - 2].slip;
}

SizeEffect::Effect SizeEffect::at(double x) const {
    if (!axis_) return {};
    const double u = std::clamp((x - first_) / step_, 0.0, static_cast<double>(knots - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(u), knots - 2);
    const double t = u - static_cast<double>(i);
    const Effect& b = value_[i];
    const Effect& c = value_[i + 1];
    const Effect& a = i > 0 ? value_[i - 1] : b;
    const Effect& d = i + 2 < knots ? value_[i + 2] : c;
    const auto cubic = [&](double Effect::*v) {
        const double m = 0.5 * (c.*v - a.*v);
        const double n = 0.5 * (d.*v - b.*v);
        return b.*v + t * (m + t * (3.0 * (c.*v - b.*v) - 2.0 * m - n + t * (2.0 * (b.*v - c.*v) + m + n)));
    };
    return {.log_stretch = cubic(&Effect::log_stretch),
            .linear = cubic(&Effect::linear),
            .slip = cubic(&Effect::slip)};
}

PlanarStrain SizeEffect::lengthened(const PlanarStrain& b, double square_stretch) {
    const double along = square_stretch;
    const double stretch = std::sqrt(1.0 + along);
    const double across = -along / (stretch * (1.0 + stretch));
    return {.xx = b.xx + along + along * b.xx,
            .xr = b.xr * std::sqrt(stretch),
            .rr = b.rr + across + across * b.rr,
            .tt = b.tt + across + across * b.tt};
}

}  // namespace bioprint
