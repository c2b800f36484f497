#include "io/history.hpp"

#include "bioprint/errors.hpp"
#include "bioprint/predict/exit_passage.hpp"
#include "bioprint/predict/prediction.hpp"
#include "io/csv.hpp"
#include "io/row_answer.hpp"

namespace bioprint {
namespace {

constexpr int points_a_radius = 40;

}  // namespace

std::vector<AxisCellState> exit_history(const Case& question, const Prediction& prediction) {
    const NozzleFlow flow =
        NozzleFlow::from_wall_rate(question.ink.law, question.radius, prediction.nozzle.shear_rate_max);
    ExitPassageRequest request =
        exit_passage_request(flow, {.radius = question.cell.radius,
                                    .shear_modulus = question.cell.shear_modulus,
                                    .viscosity_ratio = question.cell.viscosity_ratio});
    request.observe_every = question.radius / points_a_radius;
    std::vector<AxisCellState> states;
    exit_passage(flow, request, [&](const AxisCellState& state) { states.push_back(state); });
    return states;
}

std::string history_csv(const Settings& settings) {
    Case question = settings.make_case();
    question.transient = false;
    const Prediction prediction = predict(question);
    if (prediction.nozzle.velocity_average <= 0.0) {
        throw UsageError("--history: nothing flows; give a flow rate, velocity or pressure", "--history");
    }
    CsvWriter writer(fresh_dialect());
    for (const char* name : {"x [m]", "time [s]", "stretch_axial", "stretch_radial", "von_mises [Pa]",
                             "fluid_stress [Pa]", "exposure [Pa.s]"}) {
        writer.add_text(name);
    }
    writer.end_row();
    for (const AxisCellState& state : exit_history(question, prediction)) {
        for (const double value : {state.position, state.time, state.axial_stretch, state.radial_stretch,
                                   state.von_mises, state.fluid_stress, state.stress_exposure}) {
            writer.add_number(value);
        }
        writer.end_row();
    }
    return writer.text();
}

}  // namespace bioprint
