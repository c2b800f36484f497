#include "bioprint/predict/streamline_passage.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/errors.hpp"
#include "predict/exit_field.hpp"
#include "predict/streamline.hpp"

namespace bioprint {
namespace {

constexpr double before = 4.0;  // nozzle radii
constexpr double after = 6.0;
constexpr double most_strain = 3000.0;
constexpr double felt = -1.5;  // further in, what stands is the nozzle's stress
constexpr TransientOptions accuracy{.tolerance = 1e-6, .max_steps = 20000, .samples = 4};

/// B − 1 of Roscoe's ellipsoid in a shear whose velocity falls with r: its long axis leans towards −r.
Deformation settled(const EllipsoidState& cell) {
    const double angle = -*cell.angle;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto excess = [&](std::size_t i) { return cell.stretch[i] * cell.stretch[i] - 1.0; };
    const double a = excess(0);
    const double b = excess(1);
    return deformation_of({{{a * c * c + b * s * s, (a - b) * c * s, 0.0},
                            {(a - b) * c * s, a * s * s + b * c * c, 0.0},
                            {0.0, 0.0, excess(2)}}});
}

/// The largest of values that come one after the other: where one stands above both neighbours, the top of
/// the parabola through the three.
class Peak {
  public:
    void add(double x, double value) {
        a_ = b_;
        b_ = c_;
        c_ = {.x = x, .value = value};
        if (++count_ == 1 || value > top_.value) top_ = c_;
        if (count_ < 3 || b_.value < a_.value || b_.value < c_.value) return;
        const double left = (b_.value - a_.value) / (b_.x - a_.x);
        const double right = (c_.value - b_.value) / (c_.x - b_.x);
        const double bend = (right - left) / (c_.x - a_.x);
        if (!(bend < 0.0)) return;
        const double slope = left + bend * (b_.x - a_.x);  // at b
        const Sample top{.x = b_.x - 0.5 * slope / bend, .value = b_.value - 0.25 * slope * slope / bend};
        if (top.value > top_.value) top_ = top;
    }
    [[nodiscard]] double value() const { return top_.value; }
    [[nodiscard]] double x() const { return top_.x; }

  private:
    struct Sample {
        double x = 0.0;
        double value = 0.0;
    };
    Sample a_{}, b_{}, c_{}, top_{};
    int count_ = 0;
};

struct Startup {
    Deformation end;
    Peak peak;
    double exposure = 0.0;
    double settled_at = 0.0;  ///< the last time the stress was off by 5 %
};

/// From round, in a steady shear for a given time.
Startup start_up(const AmbientFlow& shear, const TransientCell& cell, double steady, double duration) {
    Startup result{};
    double time_before = 0.0;
    double stress_before = 0.0;
    result.end = carry_cell([&](double) { return shear; }, cell, {}, 0.0, duration, accuracy,
                            [&](const TransientState& s) {
                                result.peak.add(s.time, s.von_mises);
                                result.exposure +=
                                    0.5 * (s.von_mises + stress_before) * (s.time - time_before);
                                if (std::abs(s.von_mises - steady) > 0.05 * steady)
                                    result.settled_at = s.time;
                                time_before = s.time;
                                stress_before = s.von_mises;
                            })
                     .deformation;
    return result;
}

}  // namespace

StreamlinePassage streamline_passage(const NozzleFlow& flow, const ExitField& field,
                                     const StreamlineRequest& request) {
    const double r = request.start_radius;
    if (!(r > 0.0 && r < flow.radius()))
        throw UsageError("streamline: the radial position must lie between axis and wall");
    const TransientCell cell{.shear_modulus = request.shear_modulus,
                             .viscosity_ratio = request.viscosity_ratio};
    const double rate = flow.shear_rate(r);
    const EllipsoidState steady = roscoe_shear({.fluid_stress = flow.stress(r),
                                                .shear_rate = rate,
                                                .shear_modulus = request.shear_modulus,
                                                .viscosity_ratio = request.viscosity_ratio});
    StreamlinePassage result{};
    result.nozzle_steady = steady.von_mises;
    result.nozzle_peak = steady.von_mises;
    Deformation deformation = settled(steady);
    if (request.length && *request.length > before * flow.radius()) {
        const AmbientFlow shear{.gradient = {{{0.0, -rate, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}},
                                .viscosity = viscosity(flow.ink(), rate)};
        const double duration = (*request.length - before * flow.radius()) / flow.velocity(r);
        // Settled for certain after 30 relaxation and shearing times: the rest of a long nozzle is steady. A
        // cell so soft that this takes a strain of thousands is followed no further than that and counts as
        // unsettled.
        const double relaxation = (1.5 + request.viscosity_ratio) * shear.viscosity / request.shear_modulus;
        const double settling = 30.0 * (relaxation + 1.0 / rate);
        const double followed = std::min({duration, settling, most_strain / rate});
        const Startup start = start_up(shear, cell, steady.von_mises, followed);
        deformation = start.end;
        result.nozzle_peak = start.peak.value();
        result.settles = start.settled_at < (followed < settling ? 0.95 : 1.0) * followed;
        if (*result.settles) result.settling_time = start.settled_at;
        result.exposure = start.exposure + (duration - followed) * steady.von_mises;
    }

    // Along the streamline with x in the place of time: gradients over u, viscosity times u.
    const auto along = [&](double x) {
        const ExitField::Point p = field.at(x, field.streamline(r, x));
        Tensor gradient = p.gradient;
        for (auto& row : gradient) {
            for (double& v : row) v /= p.axial_velocity;
        }
        return AmbientFlow{.gradient = gradient,
                           .viscosity = viscosity(flow.ink(), p.rate) * p.axial_velocity};
    };
    Peak peak;
    double x_before = -before * flow.radius();
    double density_before = 0.0;  // von Mises over velocity
    carry_cell(
        along, cell, deformation, x_before, after * flow.radius(), accuracy, [&](const TransientState& s) {
            const double density = s.von_mises / field.at(s.time, field.streamline(r, s.time)).axial_velocity;
            result.exit_exposure += 0.5 * (density + density_before) * (s.time - x_before);
            density_before = density;
            x_before = s.time;
            if (s.time > felt * flow.radius()) peak.add(s.time, s.von_mises);
        });
    result.exit_peak = peak.value();
    result.exit_position = peak.x();
    result.exit_shear_share =
        field.at(result.exit_position, field.streamline(r, result.exit_position)).shear_share;
    result.place = result.exit_peak > result.nozzle_peak ? StreamlinePlace::exit : StreamlinePlace::nozzle;
    result.end_radius = field.streamline(r, after * flow.radius());
    return result;
}

StreamlinePassage streamline_passage(const NozzleFlow& flow, const StreamlineRequest& request) {
    const ExitField field(flow);
    return streamline_passage(flow, field, request);
}

}  // namespace bioprint
