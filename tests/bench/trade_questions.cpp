#include "bench/trade_questions.hpp"

#include <algorithm>
#include <cstdio>

namespace bioprint::trade {

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> list{
        {"exit-flow", "elongational_stress_average", SceneKind::exit_flow, 0.0},
        {"channel", "von_mises", SceneKind::channel, 0.0},
        {"exit", "von_mises_peak", SceneKind::exit, 0.0},
        {"channel-off-axis", "von_mises", SceneKind::channel, 3.0},
        {"exit-off-axis", "von_mises_peak", SceneKind::exit, 3.0},
        {"shear", "von_mises", SceneKind::shear, 3.0},
    };
    return list;
}

Case Question::to_case() const {
    return {.radius = 50e-6,
            .length = std::nullopt,
            .drive = Drive::velocity,
            .drive_value = velocity,
            .ink = {.name = "trade",
                    .source = "",
                    .law = {.eta0 = 10.0, .eta_inf = 0.0, .time_constant = 0.05, .alpha = alpha}},
            .cell = {.name = "trade", .source = "", .radius = 8e-6, .shear_modulus = shear_modulus},
            .positions = {{kind->offset, true}},
            .needle = std::nullopt};
}

std::string Question::label() const {
    char text[96];
    std::snprintf(text, sizeof text, "%s alpha=%g mu=%g u=%g", kind->name.c_str(), alpha, shear_modulus,
                  velocity);
    return text;
}

std::vector<Question> questions() {
    std::vector<Question> list;
    for (const Kind& kind : kinds()) {
        const bool flow_only = kind.name == "exit-flow";
        const bool any_ink = kind.name == "shear";  // σ_f/μ alone matters there
        for (const double alpha : {0.0, 0.3, 0.75}) {
            if (any_ink && alpha != 0.0) continue;
            for (const double modulus : {2e2, 1e3, 5e4}) {
                if (flow_only && modulus != 1e3) continue;
                for (const double velocity : {5e-3, 5e-2}) list.push_back({&kind, alpha, modulus, velocity});
            }
        }
    }
    return list;
}

double load_of(const Question& question, const Prediction& prediction) {
    const double modulus = question.shear_modulus;
    if (question.kind->name == "exit-flow") return 0.0;
    if (question.kind->name == "channel")
        return prediction.nozzle.pressure_gradient * prediction.question.cell.radius / modulus;
    if (question.kind->name == "exit") return prediction.exit.elongational_stress / modulus;
    return prediction.cells.front().stress_ratio;
}

std::optional<double> predicted(const Question& question, const Prediction& prediction, bool transient) {
    if (question.kind->name == "exit-flow") return prediction.exit.elongational_stress;
    const Place place = question.kind->name.starts_with("exit") ? Place::exit : Place::nozzle;
    // The last entry of a place is the best one: the ellipsoid follows the steady theory.
    std::optional<double> answer;
    for (const CellAnswer& cell : prediction.cells) {
        if (cell.place != place || (cell.model == Model::ellipsoid && !transient)) continue;
        answer = cell.stress ? std::optional(cell.stress->von_mises) : std::nullopt;
    }
    return answer;
}

}  // namespace bioprint::trade
