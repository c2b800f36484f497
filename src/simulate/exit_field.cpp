#include "simulate/exit_field.hpp"

#include <algorithm>
#include <cmath>

namespace bioprint {
namespace {

constexpr double strong_thinning = 0.5;

int columns(double radii, int nodes) {
    return static_cast<int>(std::lround(radii * nodes));
}

/// The value on the axis of a field even in r, from the two rows next to it.
double on_axis(const lattice::AxisymmetricFields& f, const std::vector<double>& field, int i) {
    return (9.0 * field[f.at(i, 0)] - field[f.at(i, 1)]) / 8.0;
}

/// The field at x on equidistant points, by the cubic through four of them.
double interpolated(const AxisProfile& p, const std::vector<double>& field, double x) {
    const double spacing = p.x[1] - p.x[0];
    const double z = (x - p.x.front()) / spacing;
    const auto last = static_cast<double>(p.x.size()) - 3.0;
    const auto i = static_cast<std::size_t>(std::clamp(std::floor(z), 1.0, last));
    const double t = z - static_cast<double>(i);
    return field[i - 1] * (-t * (t - 1.0) * (t - 2.0) / 6.0) + field[i] * ((t * t - 1.0) * (t - 2.0) / 2.0) +
           field[i + 1] * (-t * (t + 1.0) * (t - 2.0) / 2.0) + field[i + 2] * (t * (t * t - 1.0) / 6.0);
}

void find_peak(AxisProfile& p, double radius) {
    const auto top = static_cast<std::size_t>(std::max_element(p.stress.begin() + 1, p.stress.end() - 1) -
                                              p.stress.begin());
    const double a = p.stress[top - 1];
    const double b = p.stress[top];
    const double c = p.stress[top + 1];
    const double offset = 0.5 * (a - c) / (a - 2.0 * b + c);
    p.peak = b - 0.25 * (a - c) * offset;
    p.peak_position = p.x[top] + offset * (p.x[1] - p.x[0]);
    constexpr int samples = 2000;
    p.average = 0.0;
    for (int n = 0; n < samples; ++n) {
        const double x = p.peak_position + radius * (2.0 * (n + 0.5) / samples - 1.0);
        p.average += interpolated(p, p.stress, x) / samples;
    }
}

}  // namespace

ExitReach exit_reach(const Ink& ink) {
    return {.upstream = cross_law(ink).alpha > strong_thinning ? 5.0 : 4.0, .downstream = 4.0};
}

ExitField unsettled_exit_flow(const NozzleFlow& flow, int nodes, const ExitReach& reach) {
    return unsettled_exit_flow(flow, nodes, reach, units_for_flow(flow, nodes));
}

ExitField unsettled_exit_flow(const NozzleFlow& flow, int nodes, const ExitReach& reach,
                              const LatticeUnits& units) {
    const LatticeProfile profile = lattice_profile(flow, units);
    const int lip = columns(reach.upstream, nodes);
    // Whole vectors: the length is rounded up to a multiple of 16.
    const int length = (lip + columns(reach.downstream, nodes) + 15) / 16 * 16;
    ExitField field{
        .flow = lattice::AxisymmetricFlow({.length = length, .radius = nodes, .lip = lip},
                                          units.relaxation(flow.ink()), profile.velocity, profile.links),
        .units = units};
    field.flow.start(profile.velocity, profile.slope, profile.pressure_gradient);
    return field;
}

ExitField settle_exit_flow(const NozzleFlow& flow, int nodes, const ExitReach& reach, double tolerance,
                           RunLog& log) {
    ExitField field = unsettled_exit_flow(flow, nodes, reach);
    const int length = field.flow.domain().length;
    lattice::SteadySearch search;
    bool steady = false;
    const auto record = [&] {
        Record r;
        r.put(steady ? 1.0 : 0.0);
        r.put(static_cast<double>(search.done));
        r.put(search.last_change);
        r.put(search.before);
        r.put(field.flow.state());
        return r;
    };
    if (const auto* values = log.found("flow")) {
        Record r(*values);
        steady = r.next() != 0.0;
        search.done = static_cast<long>(r.next());
        search.last_change = r.next();
        const auto before = r.next_list();
        search.before.assign(before.begin(), before.end());
        field.flow.restore(r.next_list());
    }
    if (!steady) {
        steady = field.flow.run_to_steady(
            tolerance, exit_step_limit,
            [&](double distance) {
                log.progress("flow", std::clamp(std::log(distance) / std::log(tolerance), 0.0, 1.0));
                log.keep("flow", false, record);
                return !log.cancelled();
            },
            search);
        if (steady) {
            log.keep("flow", true, record);
        }
    }
    log.count(field.flow.steps(), static_cast<double>(length) * nodes);
    log.stop_if_cancelled();
    if (!steady) {
        log.stop("the exit flow did not become steady");
    }
    return field;
}

AxisProfile axis_profile(const ExitField& field, const NozzleFlow& flow) {
    const auto f = field.flow.measure();
    const LatticeUnits& units = field.units;
    AxisProfile p{};
    for (int i = 0; i < f.length; ++i) {
        const double rate = on_axis(f, f.elongation, i) / units.time_step;
        p.x.push_back((i + 0.5 - field.flow.domain().lip) * units.spacing);
        p.velocity.push_back(on_axis(f, f.velocity_x, i) * units.velocity);
        p.rate.push_back(rate);
        p.stress.push_back(stress(flow.ink(), std::sqrt(3.0) * std::abs(rate)));
        p.pressure.push_back(on_axis(f, f.pressure, i) * units.stress);
    }
    find_peak(p, flow.radius());
    return p;
}

double largest_radial_velocity(const ExitField& field) {
    double largest = 0.0;
    for (const double u : field.flow.measure().velocity_r) {
        largest = std::max(largest, std::abs(u));
    }
    return largest * field.units.velocity;
}

}  // namespace bioprint
