#include "predict/carried_cells.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/errors.hpp"
#include "numerics/brief.hpp"
#include "predict/resting_ink.hpp"
#include "predict/streamline.hpp"

namespace bioprint {
namespace {

void warn_once(Prediction& prediction, const char* code, std::string message) {
    const bool known = std::any_of(prediction.warnings.begin(), prediction.warnings.end(),
                                   [&](const Warning& w) { return w.code == code; });
    if (!known) prediction.warnings.push_back({code, std::move(message)});
}

void fill(CellAnswer& answer, const StreamlineState& state, const CellChoice& cell) {
    answer.fluid_stress = state.fluid_stress;
    answer.stress_ratio = state.fluid_stress / cell.shear_modulus;
    answer.stretch = state.stretch;
    answer.angle = state.angle;
    answer.frequency = state.frequency;
    answer.stress =
        CellStress{.von_mises = state.von_mises, .elastic = state.elastic, .viscous = state.viscous};
}

PassageAnswer passage_answer(const StreamlinePassage& way, double offset, const CellChoice& cell) {
    const bool at_exit = way.place == StreamlinePlace::exit;
    return {.offset = offset,
            .offset_in_cell_radii = offset / cell.radius,
            .von_mises = at_exit ? way.exit_peak : way.nozzle_peak,
            .place = at_exit ? Place::exit : Place::nozzle,
            .position = at_exit ? std::optional(way.exit_position) : way.nozzle_peak_position,
            .nozzle_peak = way.nozzle_peak,
            .nozzle_steady = way.nozzle_steady,
            .exit_peak = way.exit_peak,
            .exit_position = way.exit_position,
            .settles = way.settles,
            .settling_time = way.settling_time,
            .nozzle_exposure = way.exposure,
            .exit_exposure = way.exit_exposure,
            .strand_offset = way.end_radius};
}

bool sound(const StreamlinePassage& way) {
    const auto state_sound = [](const StreamlineState& s) {
        return std::isfinite(s.von_mises) && std::isfinite(s.viscous) && std::isfinite(s.stretch[0]) &&
               std::isfinite(s.stretch[1]) && std::isfinite(s.stretch[2]) &&
               std::isfinite(s.frequency.value_or(0.0));
    };
    return state_sound(way.nozzle_end) && state_sound(way.exit) && std::isfinite(way.exit_exposure) &&
           std::isfinite(way.nozzle_peak) && std::isfinite(way.exposure.value_or(0.0));
}

}  // namespace

CellAnswer blank_cell(Place place, Model model, double offset, double fluid_stress, const CellChoice& cell) {
    return {.place = place,
            .model = model,
            .offset = offset,
            .offset_in_cell_radii = offset / cell.radius,
            .fluid_stress = fluid_stress,
            .stress_ratio = fluid_stress / cell.shear_modulus,
            .stretch = std::nullopt,
            .angle = std::nullopt,
            .frequency = std::nullopt,
            .stress = std::nullopt,
            .relaxation_time = std::nullopt};
}

CarriedCells::CarriedCells(const NozzleFlow& flow, Prediction& prediction)
    : relaxation_time_(strand_relaxation(flow.ink(), prediction.question.cell.shear_modulus,
                                         prediction.question.cell.viscosity_ratio)) {
    if (!(flow.velocity_average() > 0.0)) return;
    field_.emplace(flow);
    const CellChoice& cell = prediction.question.cell;
    try {
        size_ = SizeEffect(flow, {.radius = cell.radius,
                                  .shear_modulus = cell.shear_modulus,
                                  .viscosity_ratio = cell.viscosity_ratio});
    } catch (const Error& e) {
        warn_once(prediction, "no_transient",
                  std::string("the centred cell could not be followed through the exit, and the cells off "
                              "the axis are followed without the effects of their size: ") +
                      e.what());
        return;
    }
    if (!size_.keeps_shape()) {
        warn_once(
            prediction, "no_bullet",
            "this cell is too soft to keep a shape in the nozzle (G R_c/μ above " + brief(softest_bullet) +
                "), where its stress grows with the time it spends there: the ellipsoid leaves with the "
                "shape of that load and gives a lower bound");
    }
    if (size_.axis()->extrapolated) {
        warn_once(prediction, "exit_extrapolated",
                  "the exit flow of this ink and speed lies outside the tabulated ones: the ellipsoid there "
                  "uses the nearest profile");
    }
}

void CarriedCells::add(const NozzleFlow& flow, double offset, Prediction& prediction) const {
    const CellChoice& cell = prediction.question.cell;
    if (!field_) return add_at_rest(offset, prediction);
    const bool centred = offset == 0.0;
    CellAnswer nozzle = blank_cell(Place::nozzle, Model::ellipsoid, offset, flow.stress(offset), cell);
    CellAnswer exit = blank_cell(Place::exit, Model::ellipsoid, offset, 0.0, cell);
    exit.relaxation_time = relaxation_time_;
    bool from_entrance = false;
    try {
        const StreamlinePassage way = streamline_passage(flow, *field_, size_,
                                                         {.start_radius = offset,
                                                          .shear_modulus = cell.shear_modulus,
                                                          .viscosity_ratio = cell.viscosity_ratio,
                                                          .length = prediction.question.length},
                                                         [](const StreamlineState&) {});
        if (!sound(way)) throw NotConverged("the deformation left the numbers");
        fill(nozzle, way.nozzle_end, cell);
        fill(exit, way.exit, cell);
        prediction.passages.push_back(passage_answer(way, offset, cell));
        from_entrance = prediction.question.length.has_value();
    } catch (const Error& e) {
        warn_once(prediction, "no_transient",
                  std::string("a cell could not be followed through nozzle and exit: ") + e.what());
    }
    if (centred && !(from_entrance && size_.axis())) return add_centred_exit(prediction);
    if (!centred) prediction.cells.push_back(nozzle);
    if (centred) {
        exit.angle.reset();
        if (exit.stress) exit.stress->viscous = 0.0;
    }
    prediction.cells.push_back(exit);
}

/// From the passage on the axis itself, of a cell settled in the nozzle, at the moment of its largest stress.
void CarriedCells::add_centred_exit(Prediction& prediction) const {
    const CellChoice& cell = prediction.question.cell;
    CellAnswer answer = blank_cell(Place::exit, Model::ellipsoid, 0.0, 0.0, cell);
    answer.relaxation_time = relaxation_time_;
    if (size_.axis()) {
        const AxisCellState& peak = size_.axis()->passage.peak;
        const double axial = peak.axial_stretch * peak.axial_stretch;
        const double radial = 1.0 / peak.axial_stretch;
        const double mean = cell.shear_modulus / 3.0 * 2.0 * (axial - radial);
        answer.fluid_stress = peak.fluid_stress;
        answer.stress_ratio = peak.fluid_stress / cell.shear_modulus;
        answer.stretch = {peak.axial_stretch, peak.radial_stretch, peak.radial_stretch};
        answer.stress = CellStress{
            .von_mises = peak.von_mises, .elastic = {mean, -0.5 * mean, -0.5 * mean}, .viscous = 0.0};
    }
    prediction.cells.push_back(answer);
}

/// At rest nothing happens.
void CarriedCells::add_at_rest(double offset, Prediction& prediction) const {
    for (const Place place : {Place::nozzle, Place::exit}) {
        if (offset == 0.0 && place == Place::nozzle) continue;
        CellAnswer answer = blank_cell(place, Model::ellipsoid, offset, 0.0, prediction.question.cell);
        answer.stretch = {1.0, 1.0, 1.0};
        answer.stress = CellStress{};
        if (place == Place::exit) answer.relaxation_time = relaxation_time_;
        prediction.cells.push_back(answer);
    }
}

}  // namespace bioprint
