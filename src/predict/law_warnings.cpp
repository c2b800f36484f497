#include "predict/law_warnings.hpp"

#include <cmath>
#include <string>

#include "numerics/brief.hpp"

namespace bioprint {
namespace {

std::string micrometres(double length) {
    return brief(length * 1e6) + " µm";
}

/// A sphere in an elastic matrix under a shear stress bears (5/2)√3 of it at most, when the matrix is the softer one.
const double most_of_matrix_stress = 2.5 * std::sqrt(3.0);

void add_plug(const Prediction& prediction, const NozzleFlow& flow, std::vector<Warning>& warnings) {
    std::string inside;
    for (const CellPosition& position : prediction.question.positions) {
        const bool centred = position.value == 0.0;
        const double reach = centred ? prediction.question.cell.radius : position.value;
        if (reach <= flow.plug_radius()) inside += (inside.empty() ? "" : ", ") + micrometres(position.value);
    }
    const double yield = yield_stress(flow.ink());
    if (!inside.empty()) {
        warnings.push_back(
            {"in_plug", "cell inside the plug (offset " + inside + "; radius of the plug " +
                            micrometres(flow.plug_radius()) +
                            "): below its yield stress the ink is rigid in this law and puts no load on "
                            "it; a gel that is softer than the cell would pass on up to " +
                            brief(most_of_matrix_stress * yield) + " Pa"});
    }
    const double strand = flow.radius() * std::sqrt(flow.velocity_average() / flow.velocity_max());
    warnings.push_back(
        {"plug_exit",
         "the load at the exit supposes that the plug yields and slows down to a strand as wide as the "
         "nozzle; a plug that leaves whole makes a strand of radius " +
             micrometres(strand) + " and spares the cell in it"});
}

}  // namespace

void add_law_warnings(const Prediction& prediction, const NozzleFlow& flow, std::vector<Warning>& warnings) {
    const bool flows = flow.velocity_average() > 0.0;
    const bool yields = yield_stress(flow.ink()) > 0.0;
    if (flows && yields) add_plug(prediction, flow, warnings);
    if (!has_rest_viscosity(flow.ink())) {
        warnings.push_back(
            {"no_rest_viscosity",
             yields ? "below its yield stress this ink has no viscosity: the strand holds the cell as it "
                      "is, and there is no relaxation time"
                    : "a power law has no viscosity at rest: there is no relaxation time in the strand"});
    }
    if (flows && prediction.question.transient && !std::holds_alternative<CrossInk>(flow.ink())) {
        warnings.push_back(
            {"exit_of_cross_ink",
             "the exit flows are simulated for Cross inks: the ellipsoid passes that of the Cross ink "
             "with the same u_max/u_avg in the nozzle and the same thinning at the wall"});
    }
}

}  // namespace bioprint
