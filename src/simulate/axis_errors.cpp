#include "simulate/axis_errors.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/rheology/ink.hpp"
#include "simulate/scenes.hpp"

namespace bioprint {
namespace {

/// What two resolutions cannot see: the coupling's own error against the exact stiff limit at 6 and 12 nodes.
constexpr double coupling_error = 5e-3;
/// The same of a centred cell in a thinning ink, for each unit of thinning (one less the index at the wall) and of the
/// root of G R_c/μ, times nodes a cell radius: at α 0.75 and 6 nodes, 4.2 % at 0.70 and 2.8 % at 0.27 against 12 nodes;
/// 1.3 % at 0.01, where the first term alone counts.
constexpr double thinning_error = 0.3;
/// Of the shift of the lip.
constexpr double lip_uncertainty = 0.2;
/// Relative errors times nodes a cell radius (squared for the flow), the largest seen on the reference cases.
constexpr double draft_cell_error = 0.35;
constexpr double draft_deformation_error = 1.45;  ///< of a cell that is hardly deformed
/// By how much those grow with G R_c/μ from where on: at 1.2, in a cell of half the nozzle's radius, a stress was 24 % off
/// at 6 nodes.
constexpr double draft_softness = 8.0;
constexpr double draft_softness_from = 0.7;
constexpr double draft_flow_error = 0.05;
/// And with its radius over the nozzle's from where on: at 0.45 drafts were off by 9 to 13 %.
constexpr double draft_size = 4.0;
constexpr double draft_size_from = 0.2;
/// The same softness after a comparison of two resolutions: 11 % at 1.9, where both are drawn out too little.
constexpr double drawn_out = 8.0;
/// Of the nozzle's pressure gradient, times nodes a nozzle radius squared: what the extrapolation leaves in a thinning ink.
constexpr double gradient_error = 0.3;

/// Around a stiff cell the viscosity of a thinning ink jumps by the contrast c within less than a spacing. Runs at 3, 6
/// and 12 nodes, G R_c/μ 0.001 to 0.05, c from 2 to 300: stresses of a draft are off by up to 0.35 ln c (nozzle) and
/// 0.65 of that (exit) over the nodes a cell radius.
constexpr double channel_contrast = 1.0;
constexpr double exit_contrast = 0.65;
constexpr double draft_exit_contrast = 1.35;  ///< times that: 18 % of a cell of 50 kPa at α 0.75 and 5 mm/s
/// What is left after a comparison of two resolutions, for each unit by which those exceed one.
constexpr double contrast_error = 0.6;
/// Spacings by which the peak of a draft lies too far downstream: 0.5 at α 0, 1.4 at 0.75, 2.0 at 0.9.
constexpr double draft_shift = 0.5;
constexpr double draft_shift_of_alpha = 1.7;

/// The contrast as it tells on a stress; below one it does not.
double contrast_of(const Scene& scene, const NozzleFlow& flow, const std::string& name) {
    const bool peak = name == "von_mises_peak";
    if (!peak && name != "von_mises" && name != "von_mises_channel") return 0.0;
    Scene place = scene;
    place.kind = peak ? SceneKind::exit : SceneKind::channel;
    return (peak ? exit_contrast : channel_contrast) * std::log(viscosity_contrast(place, flow));
}

double draft_error(const Scene& scene, const NozzleFlow& flow, const SimulatedValue& v,
                   const LatticeReport& lattice) {
    const double nodes = lattice.nodes_per_cell_radius;
    if (scene.kind == SceneKind::exit_flow) return draft_flow_error / (nodes * nodes) * std::abs(v.value);
    if (v.name == "peak_position") {
        return (draft_shift + draft_shift_of_alpha * cross_law(scene.ink).alpha) * lattice.spacing;
    }
    const double relative = v.name == "deformation" ? draft_deformation_error : draft_cell_error;
    const double pull = flow.pressure_gradient() * scene.cell.radius / scene.cell.shear_modulus;
    const double softness = 1.0 + draft_softness * std::max(0.0, pull - draft_softness_from);
    const double size = scene.cell.radius / scene.nozzle_radius;
    const double largeness = 1.0 + draft_size * std::max(0.0, size - draft_size_from);
    const double contrast =
        contrast_of(scene, flow, v.name) * (v.name == "von_mises_peak" ? draft_exit_contrast : 1.0);
    return relative * std::max({1.0, softness, contrast}) * largeness / nodes * std::abs(v.value);
}

const SimulatedValue* find(const SimulationResult& result, const std::string& name) {
    const auto found = std::find_if(result.values.begin(), result.values.end(),
                                    [&](const SimulatedValue& v) { return v.name == name; });
    return found == result.values.end() ? nullptr : &*found;
}

/// How a value converges with the lattice spacing, as measured on three resolutions.
enum class Convergence { second_order, first_order, not_extrapolated };

Convergence convergence(SceneKind scene, const std::string& name) {
    if (scene == SceneKind::exit_flow) {
        return Convergence::second_order;
    }
    // In straining flow the coupled cell acts as one 0.14 spacings larger; in the channel no excess is seen.
    const bool strained = name == "von_mises_peak" || name == "stretch_axial_min" ||
                          name == "stretch_radial_max" || name == "peak_position";
    return strained ? Convergence::first_order : Convergence::not_extrapolated;
}

/// What is left after a first-order extrapolation whose coarse run is not yet asymptotic.
double least_strained_error(const SimulationResult& fine, const SimulatedValue& v, const Scene& scene,
                            const NozzleFlow& flow) {
    if (v.name == "peak_position") {
        return 0.3 * fine.lattice.spacing;
    }
    const double pull = flow.pressure_gradient() * scene.cell.radius / scene.cell.shear_modulus;
    const double softness = 1.0 + drawn_out * std::max(0.0, pull - draft_softness_from);
    // A stretch is known by its distance from one, a stress by itself.
    return softness * 0.1 / fine.lattice.nodes_per_cell_radius *
           (v.name == "von_mises_peak" ? std::abs(v.value) : std::abs(v.value - 1.0));
}

/// Of a value that is not extrapolated, relative.
double least_error(const SimulationResult& fine, const SimulatedValue& v, const Scene& scene,
                   const NozzleFlow& flow) {
    if (!v.name.starts_with("von_mises")) return coupling_error;
    const double thinning = 1.0 - flow_index(flow.ink(), flow.shear_rate_max());
    const double pull = flow.pressure_gradient() * scene.cell.radius / scene.cell.shear_modulus;
    return coupling_error * (1.0 + thinning) +
           thinning_error * thinning * std::sqrt(std::min(pull, 1.0)) / fine.lattice.nodes_per_cell_radius;
}

}  // namespace

void extrapolate(SimulationResult& fine, const SimulationResult& coarse, const Scene& scene,
                 const NozzleFlow& flow, double ratio) {
    for (SimulatedValue& v : fine.values) {
        const SimulatedValue* c = find(coarse, v.name);
        if (c == nullptr) {
            continue;
        }
        const double difference = v.value - c->value;
        switch (convergence(fine.scene, v.name)) {
            case Convergence::second_order:
                v.value += difference / (ratio * ratio - 1.0);
                v.error = std::abs(difference) / (ratio * ratio - 1.0);
                if (v.name == "pressure_gradient") {
                    v.error = std::max(v.error, gradient_error * std::abs(v.value) /
                                                    std::pow(fine.lattice.nodes_per_radius, 2.0));
                }
                break;
            case Convergence::first_order:
                v.value += difference / (ratio - 1.0);
                v.error = std::max(0.5 * std::abs(difference) / (ratio - 1.0),
                                   least_strained_error(fine, v, scene, flow));
                break;
            case Convergence::not_extrapolated:
                v.error = std::max(std::abs(difference) / (ratio * ratio - 1.0),
                                   least_error(fine, v, scene, flow) * std::abs(v.value));
                break;
        }
    }
}

void hold_against_nozzle(SimulationResult& result, const NozzleFlow& flow) {
    if (result.scene != SceneKind::exit_flow) return;
    for (SimulatedValue& v : result.values) {
        const bool gradient = v.name == "pressure_gradient";
        if (!gradient && v.name != "velocity_max") continue;
        const double exact = gradient ? flow.pressure_gradient() : flow.velocity(0.0);
        v.error = std::max(v.error, std::abs(v.value - exact));
    }
}

void assume_errors(SimulationResult& result, const Scene& scene, const NozzleFlow& flow) {
    // No reference case is drawn out like that: nothing is known of such a value's error.
    const bool drawn_out =
        std::any_of(result.warnings.begin(), result.warnings.end(),
                    [](const SimulationWarning& warning) { return warning.code == "strong-deformation"; });
    for (SimulatedValue& v : result.values) {
        v.error = draft_error(scene, flow, v, result.lattice);
        if (drawn_out) v.error = std::max(v.error, std::abs(v.value));
    }
}

void allow_for_contrast(SimulationResult& result, const Scene& scene, const NozzleFlow& flow) {
    for (SimulatedValue& v : result.values) {
        const double excess = contrast_of(scene, flow, v.name) - 1.0;
        const double least = contrast_error * excess / result.lattice.nodes_per_cell_radius;
        v.error = std::max(v.error, least * std::abs(v.value));
    }
}

void correct_lip(SimulationResult& fine, const SimulationResult& coarse, double ratio, double gradient) {
    const SimulatedValue* peak = find(fine, "peak_position");
    const SimulatedValue* coarse_peak = find(coarse, "peak_position");
    if (peak == nullptr || coarse_peak == nullptr) {
        return;
    }
    const double shift = (coarse_peak->resolved - peak->resolved) / (ratio - 1.0);
    for (auto& row : fine.series.rows) {
        row[0] -= shift;
    }
    for (SimulatedValue& v : fine.values) {
        if (v.name == "peak_position") {
            v.value = v.resolved - shift;
            v.error = lip_uncertainty * std::abs(shift);
        } else if (v.name == "excess_pressure") {
            v.value = v.resolved - gradient * shift;
            v.error = std::max(v.error, lip_uncertainty * gradient * std::abs(shift));
        }
    }
}

}  // namespace bioprint
