#include "predict/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/cell/roscoe.hpp"
#include "bioprint/flow/nozzle_exit.hpp"
#include "numerics/brief.hpp"

namespace bioprint {
namespace {

/// Up to this stress ratio the ellipsoid theory was compared with full simulations (Müller et al.).
constexpr double checked_stress_ratio = 1.5;
/// Below this u_max/u_avg the sheared layer at the wall is so thin that slip, which is left out, decides.
constexpr double plug_velocity_ratio = 1.1;
/// Up to this G R_c/μ the first-order bullet stays a small deformation.
constexpr double bullet_range = 0.3;
/// Share of the passage time through the exit that the cell's own response may take before the steady theory
/// misleads.
constexpr double slow_cell_share = 0.1;
/// The exit and nozzle theories have no inertia; water's density bounds it for every bioink.
constexpr double density = 1000.0;

std::string micrometres(double length) {
    return brief(length * 1e6) + " µm";
}

class Collector {
  public:
    explicit Collector(std::vector<Warning>& out) : out_(out) {}
    void add(const char* code, std::string message) { out_.push_back({code, std::move(message)}); }

  private:
    std::vector<Warning>& out_;
};

void check_sizes(const Case& question, Collector& warn) {
    if (question.radius > 5e-3 || question.radius < 1e-6) {
        warn.add("suspicious_size", "the nozzle radius is " + brief(question.radius) +
                                        " m; a number without a unit is in metres: did you mean 50um?");
    }
    if (question.cell.radius > 200e-6 || question.cell.radius < 0.5e-6) {
        warn.add("suspicious_size", "the cell radius is " + brief(question.cell.radius) +
                                        " m; a number without a unit is in metres: did you mean 8um?");
    }
    if (question.cell.radius > question.radius / 3.0) {
        warn.add("large_cell", "the cell is larger than a third of the nozzle (R_c/R = " +
                                   brief(question.cell.radius / question.radius) +
                                   "): it changes the flow that these theories take as undisturbed");
    }
}

void check_needle(const Case& question, Collector& warn) {
    if (!question.needle) return;
    if (!question.needle->remark.empty()) warn.add("needle_bore", question.needle->remark);
    if (question.needle->tapered) {
        warn.add("tapered_tip",
                 "the tapered tip is treated as a straight tube of its orifice; stress at the orifice is "
                 "right, pressure drop over its length is too high");
    }
}

void check_positions(const Prediction& prediction, Collector& warn) {
    const Case& question = prediction.question;
    const double cell_radius = question.cell.radius;
    std::string near_axis;
    std::string near_wall;
    for (const CellPosition& position : question.positions) {
        if (position.value > 0.0 && position.value < cell_radius)
            near_axis += ", " + micrometres(position.value);
        if (position.value > 0.0 && question.radius - position.value < 2.0 * cell_radius * (1.0 - 1e-12)) {
            near_wall += ", " + micrometres(position.value);
        }
    }
    if (!near_axis.empty()) {
        warn.add("near_axis",
                 "cell within one radius of the axis (offset " + near_axis.substr(2) +
                     "): the shear differs across it; " +
                     (question.transient ? "the ellipsoid has that in it, the steady entry has not"
                                         : "the truth lies between this and the centred cell"));
    }
    if (!near_wall.empty()) {
        warn.add("near_wall", "cell within one radius of the wall (offset " + near_wall.substr(2) +
                                  "): the theory knows no wall; expect a higher stress");
    }
}

void check_length(const Prediction& prediction, Collector& warn) {
    std::string unsettled;
    for (const PassageAnswer& passage : prediction.passages) {
        if (passage.settles == false) unsettled += ", " + micrometres(passage.offset);
    }
    if (!unsettled.empty()) {
        warn.add("unsettled",
                 "the nozzle is too short for cells at offset " + unsettled.substr(2) +
                     " to settle: the steady entry is not what they bear; the ellipsoid, carried "
                     "from the entrance, is the better value");
    }
}

void check_flow(const Prediction& prediction, const NozzleFlow& flow, Collector& warn) {
    const NozzleAnswer& nozzle = prediction.nozzle;
    if (nozzle.velocity_average <= 0.0) return;
    if (nozzle.velocity_max < plug_velocity_ratio * nozzle.velocity_average) {
        warn.add("plug_flow", "the ink flows almost as a plug (u_max/u_avg = " +
                                  brief(nozzle.velocity_max / nozzle.velocity_average) +
                                  "): slip at the wall, which is left out, may decide the pressure");
    }
    const double reynolds = density * nozzle.velocity_average * 2.0 * flow.radius() / nozzle.viscosity_wall;
    if (reynolds > 1.0) {
        warn.add("inertia", "the Reynolds number is " + brief(reynolds) +
                                " (density of water): the exit is computed without inertia");
    }
}

void check_stress_ratios(const Prediction& prediction, Collector& warn) {
    double largest = 0.0;
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.model == Model::roscoe_shear) largest = std::max(largest, cell.stress_ratio);
    }
    if (largest > checked_stress_ratio) {
        warn.add("stress_ratio",
                 "stress ratio up to " + brief(largest) + ": past " + brief(checked_stress_ratio) +
                     ", the range in which the ellipsoid theory was checked against simulations");
    }
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.model == Model::roscoe_shear && !cell.stress) {
            warn.add("beyond_range",
                     "stress ratio " + brief(cell.stress_ratio) +
                         ": beyond what numbers hold, the entry is empty; check the units of load and cell");
        }
    }
    const double bullet = prediction.nozzle.pressure_gradient * prediction.question.cell.radius /
                          prediction.question.cell.shear_modulus;
    const bool centred = std::any_of(prediction.cells.begin(), prediction.cells.end(),
                                     [](const CellAnswer& c) { return c.model == Model::bullet; });
    if (centred && bullet > bullet_range) {
        warn.add("bullet_range",
                 "the centred cell in the nozzle is a small-deformation estimate, and G R_c/μ = " +
                     brief(bullet) + " is past " + brief(bullet_range));
    }
}

/// What the cell has to follow the load at the exit, and what it needs [s].
struct ExitTimes {
    double passage;
    double response;
};

ExitTimes exit_times(const Prediction& prediction, const NozzleFlow& flow) {
    const CellChoice& cell = prediction.question.cell;
    return {.passage = 2.0 * flow.radius() / flow.velocity_average(),
            .response =
                relaxation_time(viscosity(flow.ink(), std::numbers::sqrt3 * prediction.exit.elongation_rate),
                                cell.shear_modulus, cell.viscosity_ratio)};
}

void check_exit(const Prediction& prediction, const NozzleFlow& flow, Collector& warn) {
    const Case& question = prediction.question;
    const std::string carried = question.transient ? "; the ellipsoid, carried in time, is the better value"
                                                   : "; --model ellipsoid carries it in time";
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.model != Model::roscoe_elongation) continue;
        if (!cell.stress) {
            const double limit =
                elongation_limit_stress(question.cell.shear_modulus, ElongationDirection::compression);
            const auto edge = flow_at_elongational_stress(flow.ink(), flow.radius(), limit);
            warn.add("no_steady_shape",
                     "the exit loads the cell with " + brief(cell.fluid_stress) +
                         " Pa, but no steady shape exists above " + brief(limit) + " Pa" +
                         (edge ? ", reached at a flow rate of " + brief(edge->flow_rate()) + " m^3/s (" +
                                     brief(edge->velocity_average() * 1e3) + " mm/s)"
                               : std::string{}) +
                         "; the cell passes before it could collapse" + carried);
            continue;
        }
        const auto [passage, response] = exit_times(prediction, flow);
        if (flow.velocity_average() > 0.0 && response > slow_cell_share * passage) {
            warn.add("exit_transient", "the cell passes the exit in " + brief(passage * 1e3) +
                                           " ms and needs " + brief(response * 1e3) +
                                           " ms to follow the load: the steady entry is not what it bears" +
                                           carried);
        }
    }
}

bool shear_applies(const Prediction& prediction, const CellAnswer& cell) {
    const Case& question = prediction.question;
    if (!cell.stress || cell.offset < question.cell.radius ||
        question.radius - cell.offset < 2.0 * question.cell.radius * (1.0 - 1e-12)) {
        return false;
    }
    return std::none_of(prediction.passages.begin(), prediction.passages.end(), [&](const PassageAnswer& p) {
        return p.offset == cell.offset && p.settles == false;
    });
}

}  // namespace

void judge_steady_models(Prediction& prediction, const NozzleFlow& flow) {
    const CellChoice& choice = prediction.question.cell;
    for (CellAnswer& cell : prediction.cells) {
        switch (cell.model) {
            case Model::bullet:
                cell.applies =
                    flow.pressure_gradient() * choice.radius <= bullet_range * choice.shear_modulus;
                break;
            case Model::roscoe_shear:
                cell.applies = shear_applies(prediction, cell);
                break;
            case Model::roscoe_elongation: {
                const auto [passage, response] = exit_times(prediction, flow);
                cell.applies =
                    cell.stress && !(flow.velocity_average() > 0.0 && response > slow_cell_share * passage);
                break;
            }
            case Model::ellipsoid:
                break;
        }
    }
}

std::vector<Warning> warnings_of(const Prediction& prediction, const NozzleFlow& flow) {
    std::vector<Warning> warnings;
    Collector warn(warnings);
    check_sizes(prediction.question, warn);
    check_needle(prediction.question, warn);
    if (!prediction.question.cell.remark.empty()) warn.add("borrowed_value", prediction.question.cell.remark);
    check_flow(prediction, flow, warn);
    check_positions(prediction, warn);
    check_length(prediction, warn);
    check_stress_ratios(prediction, warn);
    check_exit(prediction, flow, warn);
    return warnings;
}

}  // namespace bioprint
