#include "io/history.hpp"

#include "bioprint/errors.hpp"
#include "bioprint/predict/prediction.hpp"
#include "bioprint/predict/streamline_passage.hpp"
#include "io/csv.hpp"
#include "io/row_answer.hpp"

namespace bioprint {
namespace {

constexpr int points_a_radius = 40;

}  // namespace

std::string history_csv(const Settings& settings) {
    Case question = settings.make_case();
    question.transient = false;
    const Prediction prediction = predict(question);
    if (prediction.nozzle.velocity_average <= 0.0) {
        throw UsageError("--history: nothing flows; give a flow rate, velocity or pressure", "--history");
    }
    const NozzleFlow flow =
        NozzleFlow::from_wall_rate(question.ink.law, question.radius, prediction.nozzle.shear_rate_max);
    CsvWriter writer(fresh_dialect());
    for (const char* name :
         {"offset [m]", "x [m]", "time [s]", "r [m]", "stretch.0", "stretch.1", "stretch.2", "angle [rad]",
          "von_mises [Pa]", "fluid_stress [Pa]", "exposure [Pa.s]"}) {
        writer.add_text(name);
    }
    writer.end_row();
    for (const CellPosition& position : prediction.question.positions) {
        const StreamlineRequest request{.start_radius = position.value,
                                        .shear_modulus = question.cell.shear_modulus,
                                        .viscosity_ratio = question.cell.viscosity_ratio,
                                        .length = question.length,
                                        .cell_radius = question.cell.radius,
                                        .observe_every = question.radius / points_a_radius};
        streamline_passage(flow, request, [&](const StreamlineState& s) {
            for (const double value :
                 {position.value, s.position, s.time, s.radius, s.stretch[0], s.stretch[1], s.stretch[2],
                  s.angle, s.von_mises, s.fluid_stress, s.exposure}) {
                writer.add_number(value);
            }
            writer.end_row();
        });
    }
    return writer.text();
}

}  // namespace bioprint
