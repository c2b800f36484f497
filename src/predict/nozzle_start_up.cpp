#include "predict/nozzle_start_up.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/errors.hpp"
#include "predict/scan.hpp"
#include "predict/size_effect.hpp"

namespace bioprint {
namespace {

constexpr double tolerance = 1e-6;
constexpr int most_steps = 20000;
constexpr double most_strain = 3000.0;
constexpr double at_rest = 2e-5;
constexpr double settled_share = 0.05;

/// The three numbers of the planar cell, and the fading e^(−t/τ) of the faster mode of the linear part, which
/// keeps the steps short enough for it.
using State = OdeState<4>;

PlanarState shape_of(const State& y) {
    return {y[0], y[1], y[2]};
}

bool close(const PlanarStrain& b, const PlanarStrain& s) {
    const double size = std::max({std::abs(s.xx), std::abs(s.xr), std::abs(s.rr), std::abs(s.tt)});
    return std::max({std::abs(b.xx - s.xx), std::abs(b.xr - s.xr), std::abs(b.rr - s.rr),
                     std::abs(b.tt - s.tt)}) <= at_rest * size;
}

class Observer {
  public:
    Observer(const StartUpQuestion& question, double time_scale,
             FunctionRef<void(const StartUpState&)> observe)
        : question_(question),
          time_scale_(time_scale),
          observe_(observe),
          steady_(stress(question.settled, question.linear)),
          scan_(0.0, 0.0) {
        observe_({.time = 0.0, .strain = {}, .linear = 0.0, .exposure = 0.0});
    }

    bool operator()(const OdeStep<4>& step) {
        const double length = step.to - step.from;
        const auto value = [&](double theta) {
            return stress(planar_strain(shape_of(step.at(theta))), linear(step.from + theta * length));
        };
        scan_.take(step.from, step.to, value, [](double) { return 1.0; });
        const auto off = [&](double theta) {
            return std::abs(value(theta) - steady_) > settled_share * steady_;
        };
        constexpr int parts = 4;
        for (int i = 1; i <= parts; ++i) {
            const bool before = off_;
            off_ = off(static_cast<double>(i) / parts);
            if (off_) settled_at_ = step.from + length * i / parts;
            if (before && !off_)
                settled_at_ = step.from + length * crossing(off, (i - 1.0) / parts, 1.0 / parts);
        }
        const PlanarStrain strain = planar_strain(shape_of(step.end));
        const double now = linear(step.to);
        observe_({.time = step.to, .strain = strain, .linear = now, .exposure = scan_.integral()});
        rests_ = close(strain, question_.settled) && now >= (1.0 - at_rest) * question_.linear;
        return !rests_;
    }

    [[nodiscard]] StartUp result(const State& y, double time, bool cut_short) const {
        StartUp r{
            .end = rests_ ? planar_state(question_.settled) : shape_of(y),
            .at_rest = rests_,
            .growth = question_.linear > 0.0 ? linear(time) / question_.linear : 1.0,
            .peak = scan_.top().value,
            .peak_time = scan_.top().at,
            .exposure = scan_.integral() + (question_.duration - time) * (rests_ ? steady_ : scan_.last()),
            .settles = rests_ || settled_at_ < (cut_short ? 0.95 : 1.0) * time,
            .settling_time = {}};
        if (r.settles) r.settling_time = settled_at_;
        return r;
    }

  private:
    [[nodiscard]] double stress(const PlanarStrain& strain, double linear) const {
        const PlanarStress s = planar_stress(strain);
        return combined_stress(question_.cell.shear_modulus * s.von_mises, linear, s.shear_part);
    }

    [[nodiscard]] double linear(double time) const {
        if (question_.linear <= 0.0) return 0.0;
        return question_.linear * bullet_growth(time / time_scale_, question_.cell.viscosity_ratio);
    }

    /// Where in [from, from + width] the stress comes within its band.
    template <typename Off>
    static double crossing(const Off& off, double from, double width) {
        for (int i = 0; i < 20; ++i) {
            width *= 0.5;
            if (off(from + width)) from += width;
        }
        return from;
    }

    const StartUpQuestion& question_;
    double time_scale_;
    FunctionRef<void(const StartUpState&)> observe_;
    double steady_;
    Scan scan_;
    bool off_ = true;
    bool rests_ = false;
    double settled_at_ = 0.0;
};

}  // namespace

StartUp start_up(const StartUpQuestion& question, FunctionRef<void(const StartUpState&)> observe) {
    const PlanarCell& cell = question.cell;
    const double time_scale = question.shear.viscosity / cell.shear_modulus;
    const double rate = std::abs(question.shear.xr);
    const double relaxation = (1.5 + cell.viscosity_ratio) * time_scale;
    const double followed =
        std::min({question.duration, 30.0 * (relaxation + 1.0 / rate), most_strain / rate});
    const double fading = 1.0 / ((2.0 / 3.0 + cell.viscosity_ratio) * time_scale);
    const double load = std::clamp(rate * time_scale, 1e-30, 1.0);
    Observer observer(question, time_scale, observe);
    const OdeOptions options{
        .tolerance = tolerance, .first_step = 0.1 * std::min(followed, relaxation), .max_steps = most_steps};
    const auto f = [&](double, const State& y) {
        const PlanarState d = cell.derivative(question.shear, shape_of(y));
        return State{d[0], d[1], d[2], -fading * y[3]};
    };
    const State start{0.0, 0.0, 0.0, question.linear > 0.0 ? 1.0 : 0.0};
    // Where nothing but the linear part happens, it is the scale of the rest.
    const auto done =
        dormand_prince<4>(f, 0.0, followed, start, {load, load, load, 100.0}, options, observer);
    if (!done.finished) throw NotConverged("cell off the axis: the start-up in the nozzle gave up");
    return observer.result(done.y, done.x, followed < question.duration);
}

}  // namespace bioprint
