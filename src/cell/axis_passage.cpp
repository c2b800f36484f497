#include "bioprint/cell/axis_passage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "bioprint/errors.hpp"
#include "cell/checks.hpp"
#include "cell/disturbed_viscosity.hpp"
#include "cell/spheroid.hpp"
#include "numerics/dormand_prince.hpp"
#include "numerics/rosenbrock.hpp"

// State over z: L = ln α1; X1, X3, the quadratic displacement inside the cell in units of its radius,
//
//   u_z = A z² + B ρ²,  u_ρ = −A ρ z,   X1 = A + 2B (surface harmonic 1),  X3 = 2A − B (harmonic 3);
//
// and the time. Outside, a displacement rate Ẋ in an ambient quadratic flow x exerts (Lamb's solution, no net
// force)
//
//   (2/3 + λ) η Ẋ1 = (5/3) η x1 − μ X1          (19/16 + λ) η Ẋ3 = (35/16) η x3 − μ X3

namespace bioprint {
namespace {

/// What the iteration for the inner elongation leaves, relative; the implicit integrator multiplies it.
constexpr double close_enough = 1e-5;
constexpr double closest = 1e-8;
/// The share of the elastic shortening by the quadratic shape that the flow leaves: measured on the simulated cell in
/// the channel, whose inertia tensor has D = 0.041 (G a/μ)² for small loads; the whole would be 0.061.
constexpr double shortening = 0.75;

/// In velocities over cell radii: an ink without a viscosity at rest is taken at that of this rate there, thick enough
/// to hold the cell.
constexpr double slowest_rate = 1e-6;

using State = OdeState<4>;
enum Component : std::size_t { log_stretch, mode1, mode3, elapsed };

/// Positive halves of Gauss rules on [−1, 1].
constexpr std::array<double, 3> node{0.23861918608319691, 0.66120938646626451, 0.93246951420315203};
constexpr std::array<double, 3> weight{0.46791393457269105, 0.36076157304813861, 0.17132449237917035};
constexpr std::array<double, 2> short_node{0.33998104358485626, 0.86113631159405258};
constexpr std::array<double, 2> short_weight{0.65214515486254614, 0.34785484513745386};

/// The ink around the cell, averaged over its volume.
struct Surroundings {
    double velocity;  ///< of the cell
    double elongation;
    double viscosity;
    double x1;  ///< quadratic flow, times viscosity and cell radius [Pa]
    double x3;
};

class Passage {
  public:
    /// @param least_rate  rates below it count as it; 0 where the ink has a viscosity at rest
    Passage(FunctionRef<AxisFlow(double)> flow, const Ink& ink, const AxisCell& cell,
            const AxisEffects& effects, double least_rate)
        : flow_(flow),
          ink_(ink),
          cell_(cell),
          effects_(effects),
          least_rate_(least_rate),
          response_(ink, least_rate) {}

    [[nodiscard]] Surroundings surroundings(double z) const {
        const double a = cell_.radius;
        const AxisFlow here = flow_(z);
        const double local = local_viscosity(here);
        double elongation = here.elongation;
        if (effects_.volume_average) elongation = average_elongation(z, here.elongation, local);
        const double radial = effects_.quadratic_flow ? here.radial / local : 0.0;
        // Mean square over the cell's volume; the shear 2 U2 ρ has ⟨ρ²⟩ = (2/5) a².
        const double square = 3.0 * elongation * elongation + 1.6 * a * a * radial * radial;
        const double eta = viscosity_at(std::sqrt(square));
        const double faxen = effects_.quadratic_flow ? a * a / 6.0 * (2.0 * here.axial + 4.0 * radial) : 0.0;
        const double slip = std::clamp(faxen, -0.2 * here.velocity, 0.2 * here.velocity);
        const double share = effects_.quadratic_flow ? effects_.quadratic_share : 0.0;
        const double axial = share * eta * here.axial * a;
        const double across = share * here.radial * a;
        return {.velocity = here.velocity + slip,
                .elongation = elongation,
                .viscosity = eta,
                .x1 = axial + 2.0 * across,
                .x3 = 2.0 * axial - across};
    }

    /// For the implicit integrator: rates without the noise of an unfinished iteration.
    void be_precise() { close_enough_ = closest; }

    State derivative(double z, const State& y) {
        if (z != place_) {
            there_ = surroundings(z);
            place_ = z;
        }
        return rates(there_, y, inner_elongation(there_, y));
    }

    /// The rates about a point. The inner elongation d solves d = next(d; s, y), and next depends on y but by the
    /// balance at given viscosities: its derivatives are those of the balance over 1 − next'(d).
    /// @param length  over which the rates change [m]
    Linearised<4> linearise(double z, const State& y, double length) {
        constexpr double small = 1e-6;
        const Surroundings s = surroundings(z);
        const double d = inner_elongation(s, y);
        const double at_d = next(s, Balance(*this, s, y), d);
        const double around = around_;
        const double inside = inside_;
        const double dd = small * (std::abs(d) + std::abs(s.elongation));
        const double slope = dd > 0.0 ? (next(s, Balance(*this, s, y), d + dd) - at_d) / dd - 1.0 : -1.0;
        around_ = around;
        inside_ = inside;
        Linearised<4> l{.value = rates(s, y, d), .jacobian = {}, .in_x = {}};
        for (const Component j : {log_stretch, mode1, mode3}) {
            State moved = y;
            const double dy = small * std::max(1e-3, std::abs(y[j]));
            moved[j] += dy;
            const double shifted = Balance(*this, s, moved)(around, inside);
            l.jacobian[log_stretch][j] = (shifted - at_d) / dy / -slope / s.velocity;
        }
        const double relaxing = -cell_.shear_modulus / (s.viscosity * s.velocity);
        l.jacobian[mode1][mode1] = relaxing / (2.0 / 3.0 + cell_.viscosity_ratio);
        l.jacobian[mode3][mode3] = relaxing / (19.0 / 16.0 + cell_.viscosity_ratio);
        const double dz = small * length;
        const Surroundings ahead = surroundings(z + dz);
        const double shift = (next(ahead, Balance(*this, ahead, y), d) - at_d) / -slope;
        const State there = rates(ahead, y, d + shift);
        for (std::size_t i = 0; i < there.size(); ++i) l.in_x[i] = (there[i] - l.value[i]) / dz;
        around_ = around;
        inside_ = inside;
        return l;
    }

    /// The state a long nozzle leaves: round, its quadratic modes steady.
    [[nodiscard]] State start(double z) const {
        const Surroundings s = surroundings(z);
        const double mu = cell_.shear_modulus;
        State y{0.0, 5.0 / 3.0 * s.x1 / mu, 35.0 / 16.0 * s.x3 / mu, 0.0};
        const Bent more = bent(y);
        y[log_stretch] = -std::log((1.0 + more.axial) / (1.0 + more.radial)) / 3.0;
        return y;
    }

    /// All but the ink's stress, which only a state that is handed out needs.
    [[nodiscard]] AxisCellState state(double z, const State& y) const {
        const double radial = std::exp(-0.5 * y[log_stretch]);
        return {.position = z,
                .time = y[elapsed],
                .axial_stretch = 1.0 / (radial * radial),
                .radial_stretch = radial,
                .von_mises = von_mises(y),
                .fluid_stress = 0.0,
                .stress_exposure = 0.0};
    }
    [[nodiscard]] AxisCellState with_fluid_stress(AxisCellState s) const {
        const double centre = rate(flow_(s.position).elongation);
        s.fluid_stress = viscosity_at(centre) * centre;
        return s;
    }

    /// Volume average of |uniform + linear| stress. In a slice of the ball at height z, ρ² is distributed
    /// evenly and the square of the local stress is linear in it, so only the integral over z is left to the
    /// quadrature.
    [[nodiscard]] double von_mises(const State& y) const {
        const double mu = cell_.shear_modulus;
        const double uniform = mu * stress_difference(y);
        const double a = (y[mode1] + 2.0 * y[mode3]) / 5.0;
        const double b = (2.0 * y[mode1] - y[mode3]) / 5.0;
        const double axial = 6.0 * mu * a;
        const double shear = std::numbers::sqrt3 * 2.0 * mu * (b - 0.5 * a);
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const double breadth = 1.0 - node[i] * node[i];
            for (const double side : {node[i], -node[i]}) {
                const double inner = std::abs(uniform + axial * side);
                const double outer = std::sqrt(inner * inner + shear * shear * breadth);
                const double total = inner + outer;
                const double mean =
                    total > 0.0 ? 2.0 / 3.0 * (outer * outer + outer * inner + inner * inner) / total : 0.0;
                sum += 0.75 * weight[i] * breadth * mean;
            }
        }
        return sum;
    }

    /// What the integration will meet: the size of the deformation, and the relaxation times the way lasts.
    struct Prospect {
        double load;
        double relaxations;
    };
    [[nodiscard]] Prospect prospect(const AxisWay& way) const {
        constexpr int samples = 32;
        const double part = (way.to - way.from) / samples;
        double load = 0.0;
        double relaxations = 0.0;
        for (int i = 0; i <= samples; ++i) {
            const AxisFlow f = flow_(way.from + part * i);
            const double local = rate(f.elongation);
            const double eta = viscosity_at(local);
            load = std::max(load, eta * local + std::abs(f.radial) * cell_.radius);
            relaxations +=
                part / f.velocity * cell_.shear_modulus / (eta * (2.0 / 3.0 + cell_.viscosity_ratio));
        }
        return {.load = std::clamp(load / cell_.shear_modulus, 1e-30, 1.0), .relaxations = relaxations};
    }

  private:
    [[nodiscard]] double viscosity_at(double rate) const {
        return viscosity(ink_, std::max(rate, least_rate_));
    }

    /// Of the undisturbed ink about a point of the axis. An ink without a viscosity at rest has none there far up
    /// in the nozzle: what counts is the shear across the cell, at the root mean square of the distance.
    [[nodiscard]] double local_viscosity(const AxisFlow& here) const {
        const double elongation = rate(here.elongation);
        if (least_rate_ == 0.0 || !effects_.quadratic_flow) return viscosity_at(elongation);
        const double shear_stress = 2.0 * std::abs(here.radial) * std::sqrt(0.4) * cell_.radius;
        return viscosity_at(std::hypot(elongation, rate_at_stress(ink_, shear_stress)));
    }

    /// What the quadratic displacement adds to the mean of B = FFᵀ along the axis and across it: a cell whose
    /// layers are sheared past each other pulls itself shorter. Second order: where it is not small it means nothing and
    /// fades.
    struct Bent {
        double axial;
        double radial;
    };
    static Bent bent(const State& y) {
        const double a = (y[mode1] + 2.0 * y[mode3]) / 5.0;
        const double b = (2.0 * y[mode1] - y[mode3]) / 5.0;
        const double axial = shortening * (0.8 * a * a + 1.6 * b * b);
        const double kept = 1.0 / (1.0 + 2.0 * axial * axial);
        return {.axial = kept * axial, .radial = kept * shortening * 0.4 * a * a};
    }

    /// Elastic stress along the axis less that across it, over μ.
    static double stress_difference(const State& y) {
        const double x = y[log_stretch];
        const Bent more = bent(y);
        return stretch_difference(x) + more.axial * std::exp(2.0 * x) - more.radial * std::exp(-x);
    }

    static double rate(double elongation) { return std::numbers::sqrt3 * std::abs(elongation); }

    /// α1² − 1/α1
    static double stretch_difference(double x) { return 2.0 * std::exp(0.5 * x) * std::sinh(1.5 * x); }

    /// ⟨∂u_z/∂z⟩ over the ball: (3/(2a³)) ∫ ξ [U(ξ) + (a²−ξ²) U2(ξ)] dξ, by parts from slices. The viscosity
    /// in U2 is taken at the centre and the outer pair of points, its inverse quadratic between them.
    [[nodiscard]] double average_elongation(double z, double at_centre, double viscosity_at_centre) const {
        const double a = cell_.radius;
        const double outer = short_node[1];
        const AxisFlow ahead = flow_(z + a * outer);
        const AxisFlow behind = flow_(z - a * outer);
        const AxisFlow ahead_near = flow_(z + a * short_node[0]);
        const AxisFlow behind_near = flow_(z - a * short_node[0]);
        double far = ahead.velocity - behind.velocity;
        double near = ahead_near.velocity - behind_near.velocity;
        if (effects_.quadratic_flow) {
            const double centre = 1.0 / viscosity_at_centre;
            const double plus = 1.0 / local_viscosity(ahead);
            const double minus = 1.0 / local_viscosity(behind);
            const double t = short_node[0] / outer;
            const double odd = 0.5 * t * (plus - minus);
            const double even = centre + t * t * (0.5 * (plus + minus) - centre);
            far += a * a * (1.0 - outer * outer) * (ahead.radial * plus - behind.radial * minus);
            near += a * a * (1.0 - short_node[0] * short_node[0]) *
                    (ahead_near.radial * (even + odd) - behind_near.radial * (even - odd));
        }
        const double average =
            1.5 / a * (short_weight[1] * outer * far + short_weight[0] * short_node[0] * near);
        const double most =
            std::max({std::abs(at_centre), std::abs(ahead.elongation), std::abs(behind.elongation)}) / 3.0;
        return std::clamp(average, at_centre - most, at_centre + most);
    }

    [[nodiscard]] State rates(const Surroundings& s, const State& y, double inside) const {
        const double mu = cell_.shear_modulus;
        const double lambda = cell_.viscosity_ratio;
        const double per_length = 1.0 / s.velocity;
        const double rate_over_stress = per_length / s.viscosity;
        return {inside * per_length,
                rate_over_stress * (5.0 / 3.0 * s.x1 - mu * y[mode1]) / (2.0 / 3.0 + lambda),
                rate_over_stress * (35.0 / 16.0 * s.x3 - mu * y[mode3]) / (19.0 / 16.0 + lambda), per_length};
    }

    /// The elongation inside the cell that balances the stresses, for given viscosities of the disturbance around it and
    /// of its inside.
    class Balance {
      public:
        Balance(const Passage& passage, const Surroundings& s, const State& y)
            : drive_(s.viscosity * s.elongation - passage.cell_.shear_modulus / 3.0 * stress_difference(y)),
              elongation_(s.elongation),
              shape_(2.0 / (3.0 * spheroid_integral(y[log_stretch])) - 1.0) {}
        double operator()(double around, double inside) const {
            return (drive_ + around * shape_ * elongation_) / (inside + around * shape_);
        }

      private:
        double drive_;
        double elongation_;
        double shape_;
    };

    /// The balance with the viscosities that an inner elongation makes, which are kept.
    double next(const Surroundings& s, const Balance& balance, double inside) {
        if (!effects_.disturbed_viscosity || response_.newtonian()) {
            around_ = s.viscosity;
            inside_ = cell_.viscosity_ratio * s.viscosity;
        } else {
            around_ = response_(s.elongation, inside - s.elongation);
            inside_ = cell_.viscosity_ratio * viscosity_at(rate(inside));
        }
        return balance(around_, inside_);
    }

    /// d from the balance of stresses: a fixed point in the two viscosities that depend on it, by secant steps. The
    /// viscosities and the slope of the moment before lead to the first.
    double inner_elongation(const Surroundings& s, const State& y) {
        const Balance balance(*this, s, y);
        if (!effects_.disturbed_viscosity || response_.newtonian()) return next(s, balance, 0.0);
        double d = around_ > 0.0 ? balance(around_, inside_)
                                 : balance(s.viscosity, cell_.viscosity_ratio * s.viscosity);
        double step = next(s, balance, d) - d;
        const double scale = std::abs(d) + std::abs(s.elongation);
        // The balance grows with d, so a step up means that the root lies above: the bracket strong thinning
        // needs.
        double low = -std::numeric_limits<double>::infinity();
        double high = std::numeric_limits<double>::infinity();
        double doubt = first_doubt;
        for (int i = 0; i < 80 && step != 0.0; ++i) {
            (step > 0.0 ? low : high) = d;
            const double before = d;
            const double step_before = step;
            d -= step / slope_;
            if (!(d > low && d < high)) d = std::isfinite(low + high) ? 0.5 * (low + high) : before + step;
            // What the step leaves is its length times what is not known of the slope.
            if (doubt * std::abs(d - before) <= close_enough_ * scale || high - low <= 1e-14 * scale) break;
            step = next(s, balance, d) - d;
            const double slope = std::min((step - step_before) / (d - before), least_slope);
            doubt = std::max(std::abs(slope / slope_ - 1.0), least_doubt);
            slope_ = slope;
        }
        return d;
    }

    FunctionRef<AxisFlow(double)> flow_;
    const Ink& ink_;
    const AxisCell& cell_;
    const AxisEffects& effects_;
    double least_rate_;
    DisturbedViscosity response_;
    /// Of the slope of next(d) − d, relative: from one moment to the next, and from one secant to the next.
    static constexpr double first_doubt = 0.2;
    static constexpr double least_doubt = 0.01;
    static constexpr double least_slope = -0.05;
    double close_enough_ = close_enough;
    double around_ = 0.0;  ///< viscosity the disturbance met last
    double inside_ = 0.0;  ///< and that inside the cell
    double slope_ = -1.0;  ///< of next(d) − d over d, as met last
    // Two stages of an explicit step lie at one place.
    double place_ = std::numeric_limits<double>::quiet_NaN();
    Surroundings there_{};
};

void check(const AxisCell& cell, const AxisWay& way) {
    require_positive(cell.radius, "cell radius");
    require_positive(cell.shear_modulus, "shear modulus");
    require_not_negative(cell.viscosity_ratio, "viscosity ratio");
    if (!(way.to > way.from) || !std::isfinite(way.to - way.from)) {
        throw UsageError("cell on the axis: the way must lead forward over a finite length");
    }
}

/// Collects the extremes of a passage from its steps.
class Recorder {
  public:
    Recorder(const Passage& passage, const AxisWay& way, const State& y,
             FunctionRef<void(const AxisCellState&)> observe)
        : passage_(passage),
          way_(way),
          observe_(observe),
          last_(passage.with_fluid_stress(passage.state(way.from, y))) {
        result_ = {.start = last_,
                   .peak = last_,
                   .end = last_,
                   .axial_stretch_min = last_.axial_stretch,
                   .axial_stretch_max = last_.axial_stretch,
                   .radial_stretch_max = last_.radial_stretch,
                   .steps = 0};
        observe_(last_);
    }

    bool operator()(const OdeStep<4>& step) {
        constexpr int parts = 4;
        for (int i = 1; i <= parts; ++i)
            take(step, static_cast<double>(i - 1) / parts, static_cast<double>(i) / parts);
        if (way_.observe_every <= 0.0) observe_(passage_.with_fluid_stress(last_));
        ++result_.steps;
        return true;
    }

    AxisPassage finish() {
        result_.peak = passage_.with_fluid_stress(result_.peak);
        result_.end = passage_.with_fluid_stress(last_);
        return result_;
    }

  private:
    void take(const OdeStep<4>& step, double from, double to) {
        const double length = step.to - step.from;
        const auto at = [&](double theta) {
            return passage_.state(step.from + theta * length, step.at(theta));
        };
        const AxisCellState middle = at(0.5 * (from + to));
        AxisCellState now = at(to);
        // Simpson's rule; the three points also give the parabola on which a peak lies.
        const double mean = (last_.von_mises + 4.0 * middle.von_mises + now.von_mises) / 6.0;
        now.stress_exposure = last_.stress_exposure + mean * (now.time - last_.time);
        extremes(now);
        if (middle.von_mises > result_.peak.von_mises || now.von_mises > result_.peak.von_mises) {
            const double bend = last_.von_mises - 2.0 * middle.von_mises + now.von_mises;
            const double lean = now.von_mises - last_.von_mises;
            const double offset =
                bend < 0.0 ? std::clamp(-0.5 * lean / bend, -1.0, 1.0) : (lean > 0.0 ? 1.0 : -1.0);
            AxisCellState top = at(0.5 * (from + to) + 0.5 * (to - from) * offset);
            top.stress_exposure = last_.stress_exposure + mean * (top.time - last_.time);
            if (top.von_mises > result_.peak.von_mises) result_.peak = top;
            extremes(top);
        }
        report(step, from, to);
        last_ = now;
    }

    void extremes(const AxisCellState& s) {
        result_.axial_stretch_min = std::min(result_.axial_stretch_min, s.axial_stretch);
        result_.axial_stretch_max = std::max(result_.axial_stretch_max, s.axial_stretch);
        result_.radial_stretch_max = std::max(result_.radial_stretch_max, s.radial_stretch);
    }

    void report(const OdeStep<4>& step, double from, double to) {
        if (way_.observe_every <= 0.0) return;
        const double length = step.to - step.from;
        while (true) {
            const double z = std::min(way_.from + (observed_ + 1.0) * way_.observe_every, way_.to);
            if (z > step.from + to * length * (1.0 + 1e-12) || ended_) return;
            const double theta = std::clamp((z - step.from) / length, from, to);
            AxisCellState s = passage_.with_fluid_stress(passage_.state(z, step.at(theta)));
            s.stress_exposure =
                last_.stress_exposure + 0.5 * (last_.von_mises + s.von_mises) * (s.time - last_.time);
            observe_(s);
            observed_ += 1.0;
            ended_ = z >= way_.to;
        }
    }

    const Passage& passage_;
    const AxisWay& way_;
    FunctionRef<void(const AxisCellState&)> observe_;
    AxisCellState last_;
    AxisPassage result_{};
    double observed_ = 0.0;
    bool ended_ = false;
};

}  // namespace

AxisPassage carry_along_axis(FunctionRef<AxisFlow(double)> flow, const Ink& ink, const AxisCell& cell,
                             const AxisWay& way, const AxisEffects& effects,
                             FunctionRef<void(const AxisCellState&)> observe) {
    check(cell, way);
    const double least_rate =
        has_rest_viscosity(ink) ? 0.0 : slowest_rate * flow(way.from).velocity / cell.radius;
    Passage passage(flow, ink, cell, effects, least_rate);
    const State start = passage.start(way.from);
    const auto [load, relaxations] = passage.prospect(way);
    const double duration = (way.to - way.from) / flow(way.from).velocity;
    const State scale{load, load, load, duration};
    Recorder recorder(passage, way, start, observe);
    const auto f = [&](double z, const State& y) { return passage.derivative(z, y); };
    // An explicit step cannot be much longer than the relaxation time; the implicit method costs more a step and keeps
    // below its tolerance where the cell follows the flow.
    const bool stiff = relaxations > 400.0;
    const OdeOptions options{.tolerance = (stiff ? 3.0 : 1.0) * way.tolerance,
                             .first_step = 0.01 * (way.to - way.from),
                             .max_steps = 20000};
    if (stiff) passage.be_precise();
    const auto linearise = [&](double z, const State& y, double length) {
        return passage.linearise(z, y, length);
    };
    const auto done = stiff ? rosenbrock<4>(f, linearise, way.from, way.to, start, scale, options, recorder)
                            : dormand_prince<4>(f, way.from, way.to, start, scale, options, recorder);
    if (!done.finished) throw NotConverged("cell on the axis: the integration in time gave up");
    return recorder.finish();
}

AxisPassage carry_along_axis(FunctionRef<AxisFlow(double)> flow, const Ink& ink, const AxisCell& cell,
                             const AxisWay& way, const AxisEffects& effects) {
    return carry_along_axis(flow, ink, cell, way, effects, [](const AxisCellState&) {});
}

}  // namespace bioprint
