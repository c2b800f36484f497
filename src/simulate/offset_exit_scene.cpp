#include "simulate/offset_exit_scene.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "simulate/decay.hpp"
#include "simulate/exit_start.hpp"
#include "simulate/offset_view.hpp"
#include "simulate/space_pictures.hpp"

namespace bioprint {

namespace {

// Nozzle before the cell's start and strand behind its end, in radii: the flow there is developed.
constexpr double margin_before = 1.5;
constexpr double margin_behind = 1.5;
constexpr double strand_length = 10.0;  ///< the period of the strand the cell relaxes in [cell radii]
constexpr double relaxed = 0.04;        ///< of the peak
// A cell is never slower than a third of the average, and relaxes long before it has gone this far.
constexpr double slowest = 1.0 / 3.0;
constexpr double longest_strand = 100.0;  ///< [radii]

OffsetChannelResult settle(const OffsetExitSetup& setup) {
    return run_offset_channel({.ink = setup.ink,
                               .radius = setup.radius,
                               .velocity_average = setup.velocity_average,
                               .cell_radius = setup.cell_radius,
                               .shear_modulus = setup.shear_modulus,
                               .offset = setup.offset,
                               .duration = setup.settle,
                               .settle_tolerance = setup.settle_tolerance,
                               .hold_offset = setup.offset > 0.0,
                               .drive = OffsetDrive::constant_flow_rate,
                               .nodes = setup.nodes,
                               .mesh_spacing = setup.mesh_spacing,
                               .single = setup.single,
                               .samples = 10,
                               .threads = setup.threads,
                               .watch = setup.watch});
}

/// Nozzle and strand, or a strand alone that is followed at its own speed.
enum class Stage { exit, strand };

template <class Real>
class Passage {
  public:
    Passage(const OffsetExitSetup& setup, Stage stage)
        : setup_(setup),
          stage_(stage),
          name_(stage == Stage::exit ? "exit" : "strand"),
          flow_(NozzleFlow::from_velocity(setup.ink, setup.radius, setup.velocity_average)),
          lu_(offset_units({setup.cell_radius, setup.shear_modulus, setup.nodes}, flow_)),
          radius_(setup.radius / lu_.spacing),
          lip_(stage == Stage::exit
                   ? static_cast<int>(std::lround((margin_before + setup.approach) * radius_))
                   : 0),
          lattice_(lattice_setup()),
          cell_({.radius = setup.nodes,
                 .spacing = setup.mesh_spacing,
                 .shear_modulus = setup.shear_modulus / lu_.stress},
                lattice_, {0.0, 0.0, 0.0}),
          rest_(mirror_ellipsoid(cell_.state().ellipsoid)) {
        start();
    }

    /// Puts the cell's nodes, given about its centre in cell radii, in at a place along x and an offset [m].
    void place(const std::vector<std::array<double, 3>>& shape, double x, double offset) {
        std::vector<Vector3> positions;
        positions.reserve(shape.size());
        for (const auto& p : shape) {
            positions.push_back(
                {x + p[0] * setup_.nodes, offset / lu_.spacing + p[1] * setup_.nodes, p[2] * setup_.nodes});
        }
        cell_.set_positions(positions);
    }
    [[nodiscard]] double start_of_passage() const { return lip_ - setup_.approach * radius_; }
    [[nodiscard]] double middle() const { return 0.5 * lattice_.nx(); }
    [[nodiscard]] const std::vector<double>* kept() const { return setup_.watch.kept(name_); }

    /// Steps without the cell until the largest elongation on the axis stands still.
    void bring_to_rest(OffsetExitResult& result) {
        const int row = lattice_.row(lattice_.section().ny / 2, 0);
        const int stride = std::max(20, static_cast<int>(radius_));
        constexpr int most_rounds = 200;
        double before = 0.0;
        double near = 0.0;
        int still = 0;
        int round = 0;
        const auto record_of_rest = [&] {
            Record r;
            for (const double value : {before, static_cast<double>(still), static_cast<double>(round),
                                       static_cast<double>(result.steps), result.updates}) {
                r.put(value);
            }
            r.put(lattice_.state());
            return r;
        };
        if (const auto* values = setup_.watch.kept("flow")) {
            Record r(*values);
            before = r.next();
            still = static_cast<int>(r.next());
            round = static_cast<int>(r.next());
            result.steps = static_cast<long>(r.next());
            result.updates = r.next();
            lattice_.restore(r.next_list());
        }
        while (round < most_rounds && still < 3) {
            ++round;
            for (int i = 0; i < stride; ++i) {
                lattice_.cycle();
            }
            count(2 * stride, result);
            double peak = 0.0;
            for (int x = lip_ / 2; x < lip_ + 2 * static_cast<int>(radius_); ++x) {
                peak = std::max(peak, std::abs(lattice_.at(x, row).viscous_stress[0]));
            }
            // Three times in a row: sound makes the peak swing through its final value.
            const double change = std::abs(peak - before) / peak;
            still = change < rest_tolerance ? still + 1 : 0;
            before = peak;
            setup_.watch.keep_state("flow", still == 3, record_of_rest);
            const double reached = std::clamp(std::log(change) / std::log(rest_tolerance), 0.0, 1.0);
            near = std::max(near, 0.9 * reached);
            if (!setup_.watch.goes_on("flow", still == 3 ? 1.0 : near)) {
                result.stopped = cancelled_run;
                return;
            }
        }
        result.flow_steady = still == 3;
    }

    /// Carries the cell until a sample is `enough`. What was kept of this stage is taken up.
    template <class Enough, class Fraction>
    void carry(OffsetExitResult& result, double from, const Enough& enough, const Fraction& fraction) {
        origin_ = from;
        first_ = result.series.empty() ? 0.0 : result.series.back().time;
        if (const auto* values = kept()) {
            resume(*values, result);
        } else {
            follow();
        }
        // The cell's way past the lip takes some hundreds of samples, its relaxing as many.
        const double path = (setup_.approach + setup_.travel) * radius_;
        const double crossing = path * lu_.spacing / (setup_.velocity_average * lu_.time);
        const long stride =
            std::max<long>(2, static_cast<long>(crossing / std::max(setup_.samples, 1)) / 2 * 2);
        const double farthest = stage_ == Stage::exit ? setup_.approach + setup_.travel : longest_strand;
        const auto most =
            static_cast<long>(farthest * setup_.radius / (slowest * setup_.velocity_average * lu_.time));
        bool ended = done_ > 0 && enough(result.series.back());
        while (!ended && result.stopped.empty() && done_ < most) {
            for (long i = 0; i < stride; ++i) {
                cell_.load();
                lattice_.step();
                cell_.move();
            }
            done_ += stride;
            count(stride, result);
            add(result, observe());
            follow();
            ended = enough(result.series.back());
            const auto picture = [&] {
                return space_picture(lattice_, cell_, scale(), result.series.back().time);
            };
            if (!setup_.watch.attend(name_, ended ? 1.0 : fraction(result.series.back()), ended, picture,
                                     [&] { return record(result); })) {
                result.stopped = cancelled_run;
            }
        }
        result.complete = ended;
    }

    /// The cell's nodes about its centre, in cell radii.
    [[nodiscard]] std::vector<std::array<double, 3>> shape() const {
        const Vector3 centre = cell_.state().ellipsoid.centre;
        std::vector<std::array<double, 3>> shape;
        shape.reserve(cell_.positions().size());
        for (const Vector3& p : cell_.positions()) {
            shape.push_back(
                {(p[0] - centre[0]) / setup_.nodes, (p[1] - centre[1]) / setup_.nodes, p[2] / setup_.nodes});
        }
        return shape;
    }
    [[nodiscard]] long nodes() const { return lattice_.fluid_nodes(); }
    [[nodiscard]] double lip() const { return lip_; }
    [[nodiscard]] double spacing() const { return lu_.spacing; }
    [[nodiscard]] OffsetLattice report() const {
        return lattice_report(lu_, flow_, {setup_.cell_radius, setup_.shear_modulus, setup_.nodes},
                              lattice_.nx());
    }

  private:
    static constexpr double rest_tolerance = 1e-3;

    D3q19Setup lattice_setup() const {
        const bool exit = stage_ == Stage::exit;
        const double wanted =
            exit ? lip_ + (setup_.travel + margin_behind) * radius_ : strand_length * setup_.nodes;
        const int nx = static_cast<int>(std::ceil(wanted / 16.0)) * 16;
        D3q19Setup setup{.nx = nx,
                         .section = tube(radius_, true),
                         .viscosity = {.nu0 = lu_.nu0,
                                       .nu_inf = lu_.nu0 * setup_.ink.eta_inf / setup_.ink.eta0,
                                       .time_constant = setup_.ink.time_constant / lu_.time,
                                       .alpha = setup_.ink.alpha},
                         .slip_begin = lip_,
                         .slip_end = nx,
                         .threads = setup_.threads};
        if (exit) {
            setup.ends = Ends::inflow_outflow;
            setup.inflow = [this](double y, double z) { return profile(std::hypot(y, z)); };
        }
        return setup;
    }

    [[nodiscard]] double profile(double r) const {
        return flow_.velocity(std::min(r * lu_.spacing, setup_.radius)) * lu_.time / lu_.spacing;
    }

    /// The flow that settled in the plane; a strand alone is at rest.
    void start() {
        if (stage_ == Stage::strand) {
            return;
        }
        const ExitStart settled(flow_, radius_);
        const double velocity = setup_.velocity_average * lu_.time / lu_.spacing;
        const double density = lu_.nu0 * velocity / radius_;
        lattice_.initialise([&](double x, double y, double z) {
            FlowState state = settled.at((x - lip_) / radius_, y / radius_, z / radius_);
            state.density *= density;
            for (double& u : state.velocity) {
                u *= velocity;
            }
            for (double& s : state.strain_rate) {
                s *= velocity / radius_;
            }
            return state;
        });
    }

    /// Moves the window with the cell; the flow beyond it stays as it was at rest, or as the cell left it.
    void follow() {
        if (stage_ == Stage::strand) {
            return;
        }
        const auto [first, last] =
            std::minmax_element(cell_.positions().begin(), cell_.positions().end(),
                                [](const Vector3& a, const Vector3& b) { return a[0] < b[0]; });
        const double reach = setup_.window * radius_;
        const auto block = [&](double at) { return std::clamp(static_cast<int>(at) * 16, 0, lattice_.nx()); };
        lattice_.set_window(block(std::floor(((*first)[0] - reach) / 16.0)),
                            block(std::ceil(((*last)[0] + reach) / 16.0)));
    }

    void count(long steps, OffsetExitResult& result) const {
        result.steps += steps;
        result.updates += static_cast<double>(steps) * static_cast<double>(lattice_.stepped_nodes());
    }

    OffsetExitSample observe() const {
        const OffsetView<Real> view(lattice_, cell_, rest_);
        const double time = done_ * lu_.time;
        const double drift = stage_ == Stage::strand ? setup_.velocity_average * time : 0.0;
        return {.time = first_ + time,
                .position = origin_ + drift + view.centre()[0] * lu_.spacing,
                .offset = view.centre()[1] * lu_.spacing,
                .von_mises = view.von_mises() * lu_.stress,
                .stretch = view.stretch(),
                .axial = view.axial_stretch(),
                .radial = view.radial_stretch(),
                .angle = view.angle(),
                .viscous = view.viscous_stress() * lu_.stress,
                .volume = view.volume()};
    }

    [[nodiscard]] SpaceScale scale() const {
        const bool strand = stage_ == Stage::strand;
        const double drift = strand ? setup_.velocity_average * done_ * lu_.time : 0.0;
        return {.spacing = lu_.spacing,
                .time = lu_.time,
                .stress = lu_.stress,
                .offset = origin_ + drift,
                .velocity = strand ? setup_.velocity_average : 0.0};
    }

    static void add(OffsetExitResult& result, const OffsetExitSample& s) {
        result.series.push_back(s);
        if (s.von_mises > result.peak_von_mises) {
            result.peak_von_mises = s.von_mises;
            result.peak_position = s.position;
        }
        result.axial_min = std::min(result.axial_min, s.axial);
        result.radial_max = std::max(result.radial_max, s.radial);
    }

    [[nodiscard]] Record record(const OffsetExitResult& result) const {
        Record r;
        r.put(static_cast<double>(done_));
        r.put(first_);
        r.put(origin_);
        r.put(result.flow_steady ? 1.0 : 0.0);
        r.put(static_cast<double>(result.steps));
        r.put(result.updates);
        r.put(static_cast<double>(result.series.size()));
        for (const OffsetExitSample& s : result.series) {
            for (const double value : {s.time, s.position, s.offset, s.von_mises, s.axial, s.radial, s.angle,
                                       s.viscous, s.volume}) {
                r.put(value);
            }
            r.put(s.stretch);
        }
        r.put(static_cast<double>(lattice_.window_begin()));
        r.put(static_cast<double>(lattice_.window_end()));
        r.put(cell_.record());
        r.put(lattice_.state());
        return r;
    }

    void resume(const std::vector<double>& values, OffsetExitResult& result) {
        Record r(values);
        done_ = static_cast<long>(r.next());
        first_ = r.next();
        origin_ = r.next();
        result.flow_steady = r.next() != 0.0;
        result.steps = static_cast<long>(r.next());
        result.updates = r.next();
        result.series.clear();
        for (auto n = static_cast<long>(r.next()); n > 0; --n) {
            OffsetExitSample s{};
            for (double* value : {&s.time, &s.position, &s.offset, &s.von_mises, &s.axial, &s.radial,
                                  &s.angle, &s.viscous, &s.volume}) {
                *value = r.next();
            }
            s.stretch = r.next_three();
            add(result, s);
        }
        const int begin = static_cast<int>(r.next());
        const int end = static_cast<int>(r.next());
        cell_.restore(r.next_list());
        lattice_.restore(r.next_list());
        lattice_.set_window(begin, end);
    }

    const OffsetExitSetup& setup_;
    Stage stage_;
    const char* name_;
    NozzleFlow flow_;
    OffsetUnits lu_;
    double radius_;
    int lip_;
    D3q19<Real> lattice_;
    ImmersedBody<Real> cell_;
    MirrorEllipsoid rest_;
    long done_ = 0;        ///< steps with the cell
    double first_ = 0.0;   ///< the time when this stage began [s]
    double origin_ = 0.0;  ///< of the lattice's x, behind the lip [m]
};

/// The strand goes on where the exit ended.
template <class Real>
void relax(const OffsetExitSetup& setup, const Passage<Real>& exit, OffsetExitResult& result) {
    Passage<Real> strand(setup, Stage::strand);
    strand.place(exit.shape(), strand.middle(), result.series.back().offset);
    const double from = result.series.back().position - strand.middle() * strand.spacing();
    const double start = std::max(result.series.back().von_mises / result.peak_von_mises, relaxed);
    strand.carry(
        result, from,
        [&](const OffsetExitSample& s) { return s.von_mises < relaxed * result.peak_von_mises; },
        [&](const OffsetExitSample& s) {
            const double now = std::max(s.von_mises / result.peak_von_mises, relaxed);
            return std::clamp(std::log(now / start) / std::log(relaxed / start), 0.0, 0.99);
        });
}

template <class Real>
void run(const OffsetExitSetup& setup, OffsetExitResult& result) {
    Passage<Real> exit(setup, Stage::exit);
    result.nodes = exit.nodes();
    result.lattice = exit.report();
    if (exit.kept() == nullptr) {
        exit.bring_to_rest(result);
        exit.place(result.channel.shape, exit.start_of_passage(), result.channel.series.back().offset);
    }
    const double path = setup.approach + setup.travel;
    const auto fraction = [&](const OffsetExitSample& s) {
        return (s.position / setup.radius + setup.approach) / path;
    };
    if (result.stopped.empty()) {
        exit.carry(
            result, -exit.lip() * exit.spacing(),
            [&](const OffsetExitSample& s) { return fraction(s) >= 1.0; }, fraction);
    }
    if (result.complete && setup.relax && result.series.back().von_mises >= relaxed * result.peak_von_mises) {
        relax(setup, exit, result);
    }
}

}  // namespace

OffsetExitResult run_offset_exit(const OffsetExitSetup& setup) {
    if (!(setup.approach >= 0.5 && setup.approach <= 10.0) ||
        !(setup.travel >= 0.5 && setup.travel <= 20.0)) {
        throw UsageError("the exit scene starts 0.5 to 10 radii before the lip and ends 0.5 to 20 behind it");
    }
    OffsetExitResult result{};
    result.axial_min = 1e300;
    result.channel = settle(setup);
    result.steps = result.channel.steps;
    result.updates = static_cast<double>(result.channel.steps) * static_cast<double>(result.channel.nodes);
    result.stopped = result.channel.stopped;
    result.lattice = result.channel.lattice;
    if (!result.stopped.empty() || result.channel.series.empty()) {
        return result;
    }
    result.channel_von_mises = result.channel.series.back().von_mises;
    try {
        if (setup.single) {
            run<float>(setup, result);
        } else {
            run<double>(setup, result);
        }
    } catch (const NotConverged& e) {
        result.stopped = e.what();
        result.complete = false;
    }
    if (!result.complete && result.stopped.empty()) {
        result.stopped = "the cell did not come to the end of its way";
    }
    std::vector<double> time;
    std::vector<double> stress;
    time.reserve(result.series.size());
    stress.reserve(result.series.size());
    for (const OffsetExitSample& s : result.series) {
        time.push_back(s.time);
        stress.push_back(s.von_mises);
    }
    const double strand = strand_at_rest * setup.radius;
    const auto free = std::find_if(result.series.begin(), result.series.end(),
                                   [&](const OffsetExitSample& s) { return s.position >= strand; });
    result.relaxation_time = decay_time(time, stress, static_cast<std::size_t>(free - result.series.begin()));
    return result;
}

}  // namespace bioprint
