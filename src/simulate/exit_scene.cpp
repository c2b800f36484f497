#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "simulate/decay.hpp"
#include "simulate/exit_field.hpp"
#include "simulate/pictures.hpp"
#include "simulate/scenes.hpp"

namespace bioprint {
namespace {

constexpr double start_in_radii = -2.0;
constexpr double strand_in_radii =
    2.5;  ///< where the flow is a plug and the cell goes on in a strand of its own
constexpr double strand_length = 3.0;
constexpr double sample_in_transits = 0.01;
constexpr double longest_in_transits = 200.0;
constexpr double relaxed = 0.04;  ///< of the peak
/// Of the flow without the cell, from 6 nodes a cell radius on; on a coarser lattice larger, as its error is.
constexpr double flow_tolerance = 1e-4;
constexpr double nodes_of_tolerance = 6.0;

struct Sample {
    double time, x, stress, axial, radial, volume;
};

/// Carries the cell and samples it.
class Passage {
  public:
    Passage(const Run& run, const LatticeUnits& units, ImmersedCell& cell)
        : run_(run), units_(units), cell_(cell), rest_(cell.shape()) {
        interval_ = std::max(2L, std::lround(sample_in_transits * run.nodes / units.velocity_lu));
        run.log.result.series = {
            .columns = {"time [s]", "x [m]", "von_mises [Pa]", "stretch_axial", "stretch_radial", "volume"},
            .rows = {}};
    }

    /// Samples until one is `enough`; x of the samples is the lattice's plus `offset`, drifting by `drift` a
    /// step.
    template <class Enough>
    void carry(const char* stage, lattice::AxisymmetricFlow& flow, double offset, double drift,
               Enough enough) {
        const double nodes = static_cast<double>(flow.domain().length) * run_.nodes;
        long first = steps_;
        if (const auto* values = run_.log.found(stage)) {
            first = resume(*values, flow);
            run_.log.count(steps_ - first, nodes);
        }
        bool ended = !samples_.empty() && steps_ > first && enough(samples_.back());
        while (!ended) {
            advance(flow);
            run_.log.count(interval_, nodes);
            sample(offset + drift * static_cast<double>(steps_ - first));
            ended = enough(samples_.back());
            run_.log.picture(stage, ended ? 1.0 : progress_of(stage), ended, [&] {
                const PictureFrame frame{.offset = offset + drift * static_cast<double>(steps_ - first),
                                         .drift = drift};
                return SimulationSnapshot{.stage = stage,
                                          .time = samples_.back().time,
                                          .cell = cell_picture(cell_, units_, frame),
                                          .flow = flow_picture(flow, units_, frame)};
            });
            run_.log.keep(stage, ended, [&] { return record(flow, first); });
            if (samples_.size() % 16 == 0 || ended) {
                run_.log.progress(stage, ended ? 1.0 : progress_of(stage));
            }
            run_.log.stop_if_cancelled();
        }
    }
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
    [[nodiscard]] double peak() const { return peak_; }
    [[nodiscard]] bool too_long() const {
        return static_cast<double>(steps_) * units_.velocity_lu > longest_in_transits * run_.nodes;
    }

  private:
    void advance(lattice::AxisymmetricFlow& flow) {
        for (long n = 0; n < interval_; ++n) {
            cell_.load(flow);
            flow.step();
            if (!cell_.move(flow)) {
                run_.log.stop("the cell broke down" + where());
            }
        }
        steps_ += interval_;
    }
    void sample(double offset) {
        const solid::RingShape s = cell_.shape();
        if (!(s.smallest_jacobian > 0.0)) {
            run_.log.stop("an element of the cell turned inside out" + where());
        }
        add({.time = static_cast<double>(steps_) * units_.time_step,
             .x = (s.centre + offset) * units_.spacing,
             .stress = s.von_mises * units_.stress,
             .axial = s.length / rest_.length,
             .radial = s.width / rest_.width,
             .volume = s.volume / rest_.volume});
    }
    void add(const Sample& s) {
        samples_.push_back(s);
        peak_ = std::max(peak_, s.stress);
        run_.log.result.series.rows.push_back({s.time, s.x, s.stress, s.axial, s.radial, s.volume});
    }
    [[nodiscard]] std::string where() const {
        return samples_.empty() ? std::string(" at the start of the exit")
                                : " at x = " + std::to_string(samples_.back().x / run_.scene.nozzle_radius) +
                                      " nozzle radii from the exit";
    }
    [[nodiscard]] double progress_of(const char* stage) const {
        if (stage[0] == 'e') {
            const double x = samples_.back().x / run_.scene.nozzle_radius;
            return std::clamp((x - start_in_radii) / (strand_in_radii - start_in_radii), 0.0, 0.99);
        }
        return std::clamp(std::log(peak_ / samples_.back().stress) / std::log(1.0 / relaxed), 0.0, 0.99);
    }
    [[nodiscard]] Record record(const lattice::AxisymmetricFlow& flow, long first) const {
        Record r;
        r.put(static_cast<double>(first));
        r.put(static_cast<double>(steps_));
        r.put(cell_.state());
        r.put(flow.state());
        r.put(static_cast<double>(samples_.size()));
        for (const Sample& s : samples_) {
            for (const double value : {s.time, s.x, s.stress, s.axial, s.radial, s.volume}) {
                r.put(value);
            }
        }
        return r;
    }
    long resume(const std::vector<double>& values, lattice::AxisymmetricFlow& flow) {
        Record r(values);
        const auto first = static_cast<long>(r.next());
        steps_ = static_cast<long>(r.next());
        cell_.restore(r.next_list());
        flow.restore(r.next_list());
        samples_.clear();
        run_.log.result.series.rows.clear();
        for (auto n = static_cast<long>(r.next()); n > 0; --n) {
            const double time = r.next();
            const double x = r.next();
            const double von_mises = r.next();
            const double axial = r.next();
            const double radial = r.next();
            add({.time = time,
                 .x = x,
                 .stress = von_mises,
                 .axial = axial,
                 .radial = radial,
                 .volume = r.next()});
        }
        return first;
    }

    const Run& run_;
    const LatticeUnits& units_;
    ImmersedCell& cell_;
    solid::RingShape rest_;
    long interval_;
    long steps_ = 0;
    double peak_ = 0.0;
    std::vector<Sample> samples_;
};

std::optional<double> relaxation_time(const Run& run, const std::vector<Sample>& samples) {
    std::vector<double> time;
    std::vector<double> stress;
    time.reserve(samples.size());
    stress.reserve(samples.size());
    for (const Sample& s : samples) {
        time.push_back(s.time);
        stress.push_back(s.stress);
    }
    const double strand = strand_at_rest * run.scene.nozzle_radius;
    const auto free =
        std::find_if(samples.begin(), samples.end(), [&](const Sample& s) { return s.x >= strand; });
    return decay_time(time, stress, static_cast<std::size_t>(free - samples.begin()));
}

void leave_values(const Run& run, const std::vector<Sample>& samples, double start) {
    const auto by = [&](auto member) {
        return [member](const Sample& a, const Sample& b) { return a.*member < b.*member; };
    };
    const auto top = std::max_element(samples.begin(), samples.end(), by(&Sample::stress));
    run.log.result.values.clear();
    run.log.value("von_mises_channel", start);
    run.log.value("von_mises_peak", top->stress);
    run.log.value("stretch_axial_min",
                  std::min_element(samples.begin(), samples.end(), by(&Sample::axial))->axial);
    run.log.value("stretch_radial_max",
                  std::max_element(samples.begin(), samples.end(), by(&Sample::radial))->radial);
    run.log.value("peak_position", top->x);
    if (const auto tau = relaxation_time(run, samples)) {
        run.log.value("relaxation_time", *tau);
    } else {
        run.log.warn(
            "no-relaxation-time",
            "the stress fell while the ink still strained the cell, or not from a half to a twentieth of "
            "its peak: that is no time of the cell's own");
    }
}

}  // namespace

namespace {

/// The flow through the exit in the units of a run with a cell.
ExitField exit_field(const Run& run, const LatticeUnits& units) {
    const double coarser = std::max(1.0, nodes_of_tolerance * units.spacing / run.scene.cell.radius);
    ExitField field = settle_exit_flow(run.flow, run.nodes, exit_reach(run.flow.ink()),
                                       flow_tolerance * coarser * coarser, run.log);
    field.flow.rescale(units.velocity_lu / field.units.velocity_lu,
                       units.viscosity_lu / field.units.viscosity_lu);
    field.units = units;
    return field;
}

}  // namespace

void run_exit(const Run& run) {
    const ChannelState channel = run_channel(run);
    const double start = run.log.result.values.front().value;
    const LatticeUnits units = units_for_cell(run.scene, run.flow, run.nodes, run.log.options());
    ExitField field = exit_field(run, units);

    ImmersedCell cell(cell_setup(run, units), 0.0);
    Passage passage(run, units, cell);
    const int lip = field.flow.domain().lip;
    cell.set_positions(channel.positions);
    cell.shift(lip + start_in_radii * run.nodes);
    passage.carry("exit", field.flow, -lip, 0.0, [&](const Sample& s) {
        return s.x > strand_in_radii * run.scene.nozzle_radius || passage.too_long();
    });

    // The strand moves as a plug: followed at its own speed it is at rest.
    const int length = (static_cast<int>(strand_length * run.nodes) + 15) / 16 * 16;
    lattice::AxisymmetricFlow strand({.length = length, .radius = run.nodes, .lip = 0, .periodic = true},
                                     units.relaxation(run.flow.ink()));
    const double centre = cell.shape().centre;
    cell.shift(0.5 * length - centre);
    passage.carry("strand", strand, centre - 0.5 * length - lip, units.velocity_lu,
                  [&](const Sample& s) { return s.stress < relaxed * passage.peak() || passage.too_long(); });
    leave_values(run, passage.samples(), start);
    report(run, units, field.flow.domain().length);
}

}  // namespace bioprint
