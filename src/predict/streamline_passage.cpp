#include "bioprint/predict/streamline_passage.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"
#include "numerics/rosenbrock.hpp"
#include "predict/nozzle_start_up.hpp"
#include "predict/resting_ink.hpp"
#include "predict/scan.hpp"
#include "predict/streamline.hpp"
#include "predict/streamline_path.hpp"

namespace bioprint {
namespace {

constexpr double before = StreamlinePath::before;  // nozzle radii
constexpr double after = StreamlinePath::after;
constexpr double felt = 1.5;  // further in, what stands is the nozzle's stress
constexpr double tolerance = 1e-6;
/// An explicit step cannot be much longer than the relaxation time: from here on it is the dearer one.
constexpr double stiff_from = 100.0;
/// A stiff cell follows its load, and an error of a step is gone in the next.
constexpr double stiff_tolerance = 4e-5;
constexpr int most_steps = 20000;
/// B − 1 of Roscoe's ellipsoid in a shear whose velocity falls with r: its long axis leans towards −r.
PlanarStrain settled_strain(const EllipsoidState& cell) {
    const double c = std::cos(*cell.angle);
    const double s = -std::sin(*cell.angle);
    const auto excess = [&](std::size_t i) { return (cell.stretch[i] - 1.0) * (cell.stretch[i] + 1.0); };
    const double a = excess(0);
    const double b = excess(1);
    return {.xx = a * c * c + b * s * s, .xr = (a - b) * c * s, .rr = a * s * s + b * c * c, .tt = excess(2)};
}

class Follower {
  public:
    Follower(const NozzleFlow& flow, const ExitField& field, const SizeEffect& size,
             const StreamlineRequest& request, FunctionRef<void(const StreamlineState&)> observe)
        : request_(request),
          size_(size),
          observe_(observe),
          path_(field, flow, size, request.start_radius),
          cell_{.shear_modulus = request.shear_modulus, .viscosity_ratio = request.viscosity_ratio},
          radius_(flow.radius()),
          rate_(flow.shear_rate(request.start_radius)),
          velocity_(SizeEffect::velocity(flow.velocity(request.start_radius), size.nozzle_slip())),
          fluid_stress_(flow.stress(request.start_radius)),
          viscosity_(viscosity(flow.ink(), std::max(rate_, least_rate(flow)))),
          // Below the yield stress nothing shears the cell.
          steady_(roscoe_shear({.fluid_stress = rate_ > 0.0 ? fluid_stress_ : 0.0,
                                .shear_rate = rate_,
                                .shear_modulus = request.shear_modulus,
                                .viscosity_ratio = request.viscosity_ratio})),
          steady_strain_(settled_strain(steady_)),
          nozzle_end_(-std::min(felt * radius_, request.length ? 0.5 * *request.length : felt * radius_)) {}

    StreamlinePassage follow() {
        result_.nozzle_steady = stress(steady_strain_, size_.nozzle_linear());
        result_.nozzle_peak = result_.nozzle_steady;
        PlanarState state = planar_state(steady_strain_);
        double from = -before * radius_;
        if (!request_.length) {
            observe_(settled_state(from, 0.0, 0.0));
            result_.nozzle_end = settled_state(from, 0.0, 0.0);
        } else if (*request_.length > before * radius_) {
            state = enter();
        } else {
            from = -*request_.length;
            state = {};
            result_.nozzle_peak = 0.0;
            result_.nozzle_peak_position = from;
            result_.settles = false;
            result_.exposure = 0.0;
        }
        pass_exit(state, from);
        return result_;
    }

  private:
    double stress(const PlanarStrain& strain, double linear) const {
        const PlanarStress s = planar_stress(strain);
        return combined_stress(request_.shear_modulus * s.von_mises, linear, s.shear_part);
    }

    StreamlineState state_of(const PlanarStrain& strain, double linear, const PlanarFlow& flow,
                             double viscosity) const {
        const PlanarShape shape = planar_shape(strain);
        const double mu = request_.shear_modulus;
        const double shear = cell_.inner_shear(flow, strain);
        const double long_axis = std::max(shape.stretch[0], shape.stretch[1]);
        const double short_axis = std::min(shape.stretch[0], shape.stretch[1]);
        const double difference = (long_axis - short_axis) * (long_axis + short_axis);
        StreamlineState s{};
        s.stretch = shape.stretch;
        s.angle = shape.angle;
        s.von_mises = combined_stress(mu * shape.von_mises, linear, shape.shear_part);
        s.elastic = {mu * shape.elastic[0], mu * shape.elastic[1], mu * shape.elastic[2]};
        s.viscous = 2.0 * request_.viscosity_ratio * viscosity * shear;
        if (difference > 1e-6) s.frequency = 2.0 * long_axis * short_axis / difference * shear;
        return s;
    }

    PlanarFlow shear() const {
        return {.xx = 0.0, .xr = -rate_, .rx = 0.0, .rr = 0.0, .tt = 0.0, .viscosity = viscosity_};
    }

    StreamlineState nozzle_state(const PlanarStrain& strain, double linear, double position, double time,
                                 double exposure) const {
        StreamlineState s = state_of(strain, linear, shear(), viscosity_);
        s.position = position;
        s.time = time;
        s.radius = request_.start_radius;
        s.fluid_stress = fluid_stress_;
        s.exposure = exposure;
        return s;
    }

    /// As Roscoe's theory gives it, to its digits.
    StreamlineState settled_state(double position, double time, double exposure) const {
        StreamlineState s = nozzle_state(steady_strain_, size_.nozzle_linear(), position, time, exposure);
        s.stretch = steady_.stretch;
        s.angle = *steady_.angle;
        s.elastic = steady_.elastic;
        s.viscous = steady_.viscous;
        s.frequency = steady_.frequency;
        return s;
    }

    /// From round at the entrance through the developed shear to where the exit is felt at all.
    PlanarState enter() {
        const double length = *request_.length;
        const double duration = (length - before * radius_) / velocity_;
        const auto place = [&](double t) { return velocity_ * t - length; };
        const StartUp start =
            start_up({.shear = shear(),
                      .cell = cell_,
                      .settled = steady_strain_,
                      .linear = size_.nozzle_linear(),
                      .duration = duration},
                     [&](const StartUpState& s) {
                         observe_(nozzle_state(s.strain, s.linear, place(s.time), s.time, s.exposure));
                     });
        result_.nozzle_peak = start.peak;
        result_.nozzle_peak_position = place(start.peak_time);
        result_.settles = start.settles;
        result_.settling_time = start.settling_time;
        result_.exposure = start.exposure;
        result_.nozzle_end =
            start.at_rest ? settled_state(-before * radius_, duration, start.exposure)
                          : nozzle_state(planar_strain(start.end), start.growth * size_.nozzle_linear(),
                                         -before * radius_, duration, start.exposure);
        observe_(result_.nozzle_end);
        exposure_ = start.exposure;
        time_ = duration;
        growth_ = start.growth;
        return start.end;
    }

    /// Strain and linear part of a cell of this size, and its stress.
    struct Reading {
        PlanarStrain strain;
        double linear;
    };
    Reading reading(double s, const PlanarState& y) const {
        const StreamlinePath::Size size = path_.size(s);
        return {.strain = SizeEffect::lengthened(planar_strain(y), size.square_stretch),
                .linear = growth_ * size.linear};
    }

    StreamlineState exit_state(double s, const PlanarState& y, double time) const {
        const Reading r = reading(s, y);
        const StreamlinePath::Place place = path_.place(s);
        PlanarFlow flow = path_.flow(s);
        for (double* v : {&flow.xx, &flow.xr, &flow.rx, &flow.rr, &flow.tt}) *v /= place.slowness;
        flow.viscosity = place.viscosity;
        StreamlineState state = state_of(r.strain, r.linear, flow, place.viscosity);
        state.position = path_.position(s);
        state.time = time;
        state.radius = place.radius;
        state.fluid_stress = place.viscosity * place.rate;
        return state;
    }

    /// Part of the way, from where the exit has no influence yet or behind that.
    struct Leg {
        Scan scan;
        PlanarState end;
        PlanarState at_peak;
        double peak_time;
    };

    Leg carry(double first, double last, const PlanarState& start) {
        const auto value_at = [&](double s, const PlanarState& y) {
            const Reading r = reading(s, y);
            return stress(r.strain, r.linear);
        };
        Leg leg{
            .scan = Scan(first, value_at(first, start)), .end = start, .at_peak = start, .peak_time = time_};
        const auto take = [&](const OdeStep<3>& step) {
            const double length = step.to - step.from;
            const auto slowness = [&](double theta) {
                return path_.cell_slowness(step.from + theta * length);
            };
            const auto time_at = [&](double theta) {
                const double sum = slowness(0.0) + 4.0 * slowness(0.5 * theta) + slowness(theta);
                return time_ + theta * length * sum / 6.0;
            };
            const double stress_before = leg.scan.last();
            const double exposure_before = leg.scan.integral();
            leg.scan.take(
                step.from, step.to,
                [&](double theta) { return value_at(step.from + theta * length, step.at(theta)); }, slowness);
            if (leg.scan.top().at > step.from) {
                const double theta = (leg.scan.top().at - step.from) / length;
                leg.at_peak = step.at(theta);
                leg.peak_time = time_at(theta);
            }
            for (; observing() && path_.at_position(next_) <= step.to; next_ += request_.observe_every) {
                const double s = path_.at_position(next_);
                const double theta = std::clamp((s - step.from) / length, 0.0, 1.0);
                StreamlineState state = exit_state(s, step.at(theta), time_at(theta));
                state.exposure = exposure_ + exposure_before +
                                 0.5 * (stress_before + state.von_mises) * (state.time - time_);
                observe_(state);
            }
            time_ = time_at(1.0);
            return true;
        };
        const double load = std::clamp(fluid_stress_ / request_.shear_modulus, 1e-6, 1.0);
        const bool stiff = relaxations(first, last) > stiff_from;
        const OdeOptions options{.tolerance = stiff ? stiff_tolerance : tolerance,
                                 .first_step = 0.02 * (last - first),
                                 .max_steps = most_steps};
        const auto f = [&](double s, const PlanarState& y) { return cell_.derivative(path_.flow(s), y); };
        const PlanarState scale{load, load, load};
        const auto done = stiff ? rosenbrock<3>(f, first, last, start, scale, options, take)
                                : dormand_prince<3>(f, first, last, start, scale, options, take);
        if (!done.finished) throw NotConverged("cell off the axis: the integration through the exit gave up");
        exposure_ += leg.scan.integral();
        leg.end = done.y;
        return leg;
    }

    [[nodiscard]] bool observing() const {
        return request_.observe_every > 0.0 && next_ <= after * radius_ * (1.0 + 1e-9);
    }

    /// How many relaxation times a part of the way lasts.
    [[nodiscard]] double relaxations(double first, double last) const {
        constexpr int parts = 32;
        double sum = 0.0;
        for (int i = 0; i < parts; ++i)
            sum += 1.0 / path_.flow(first + (last - first) * (i + 0.5) / parts).viscosity;
        return sum * (last - first) / parts * request_.shear_modulus / (1.5 + request_.viscosity_ratio);
    }

    void pass_exit(const PlanarState& start, double from) {
        const double before_exit = exposure_;
        next_ = from + request_.observe_every;
        const double nozzle_end = path_.at_position(nozzle_end_);
        const double last = path_.at_position(after * radius_);
        const Leg nozzle = carry(path_.at_position(from), nozzle_end, start);
        if (request_.length) {
            if (from > -before * radius_) {
                result_.nozzle_end = exit_state(nozzle_end, nozzle.end, time_);
                result_.nozzle_end.exposure = exposure_;
            }
            if (nozzle.scan.top().value > result_.nozzle_peak) {
                result_.nozzle_peak = nozzle.scan.top().value;
                result_.nozzle_peak_position = path_.position(nozzle.scan.top().at);
            }
        }
        const double before_peak = exposure_;
        const Leg exit = carry(nozzle_end, last, nozzle.end);
        const Scan::Top& top = exit.scan.top();
        result_.exit = exit_state(top.at, exit.at_peak, exit.peak_time);
        result_.exit.frequency.reset();
        result_.exit.exposure = before_peak;
        result_.exit_peak = top.value;
        result_.exit_position = path_.position(top.at);
        result_.exit_shear_share = path_.place(top.at).shear_share;
        result_.place =
            result_.exit_peak > result_.nozzle_peak ? StreamlinePlace::exit : StreamlinePlace::nozzle;
        result_.end_radius = path_.place(last).radius;
        result_.exit_exposure = exposure_ - before_exit;
    }

    const StreamlineRequest& request_;
    const SizeEffect& size_;
    FunctionRef<void(const StreamlineState&)> observe_;
    StreamlinePath path_;
    PlanarCell cell_;
    double radius_;
    double rate_;
    double velocity_;
    double fluid_stress_;
    double viscosity_;
    EllipsoidState steady_;
    PlanarStrain steady_strain_;
    double nozzle_end_;
    double time_ = 0.0;
    double exposure_ = 0.0;
    double growth_ = 1.0;  ///< of the linear part, where the nozzle was too short for it
    double next_ = 0.0;    ///< place of the next call of the observer
    StreamlinePassage result_{};
};

void check(const NozzleFlow& flow, const StreamlineRequest& request) {
    if (!(request.start_radius >= 0.0 && request.start_radius < flow.radius()))
        throw UsageError("streamline: the radial position must lie between axis and wall");
    if (!(flow.velocity_average() > 0.0)) throw UsageError("streamline: nothing flows through the nozzle");
    if (request.length && !(*request.length > 0.0 && std::isfinite(*request.length)))
        throw UsageError("streamline: the length must be a finite number above zero");
}

}  // namespace

StreamlinePassage streamline_passage(const NozzleFlow& flow, const ExitField& field, const SizeEffect& size,
                                     const StreamlineRequest& request,
                                     FunctionRef<void(const StreamlineState&)> observe) {
    check(flow, request);
    return Follower(flow, field, size, request, observe).follow();
}

StreamlinePassage streamline_passage(const NozzleFlow& flow, const StreamlineRequest& request,
                                     FunctionRef<void(const StreamlineState&)> observe) {
    check(flow, request);
    const ExitField field(flow);
    const SizeEffect size = request.cell_radius > 0.0
                                ? SizeEffect(flow, {.radius = request.cell_radius,
                                                    .shear_modulus = request.shear_modulus,
                                                    .viscosity_ratio = request.viscosity_ratio})
                                : SizeEffect();
    return streamline_passage(flow, field, size, request, observe);
}

StreamlinePassage streamline_passage(const NozzleFlow& flow, const StreamlineRequest& request) {
    return streamline_passage(flow, request, [](const StreamlineState&) {});
}

}  // namespace bioprint
