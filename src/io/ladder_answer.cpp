#include "io/ladder_answer.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

double load_of(QuestionKind kind, const Prediction& prediction) {
    const double modulus = prediction.question.cell.shear_modulus;
    switch (kind) {
        case QuestionKind::exit_flow:
            return 0.0;
        case QuestionKind::channel:
            return prediction.nozzle.pressure_gradient * prediction.question.cell.radius / modulus;
        case QuestionKind::exit:
            return prediction.exit.elongational_stress / modulus;
        case QuestionKind::channel_off_axis:
        case QuestionKind::exit_off_axis:
        case QuestionKind::shear:
            break;
    }
    for (const CellAnswer& cell : prediction.cells)
        if (cell.offset > 0.0 && cell.place == Place::nozzle) return cell.stress_ratio;
    return prediction.exit.elongational_stress / modulus;
}

bool on_axis(const Prediction& prediction) {
    const auto& positions = prediction.question.positions;
    return std::any_of(positions.begin(), positions.end(), [](const auto& p) { return p.value == 0.0; });
}

QuestionKind kind_of(const Prediction& prediction, const std::optional<SceneKind>& scene) {
    const bool centred = on_axis(prediction);
    switch (scene.value_or(SceneKind::exit)) {
        case SceneKind::exit_flow:
            return QuestionKind::exit_flow;
        case SceneKind::shear:
            return QuestionKind::shear;
        case SceneKind::channel:
            return centred ? QuestionKind::channel : QuestionKind::channel_off_axis;
        case SceneKind::exit:
            break;
    }
    return centred ? QuestionKind::exit : QuestionKind::exit_off_axis;
}

std::string percent(const std::optional<double>& error) {
    return error ? percent_text(*error) : "not known";
}

std::string duration(const std::optional<double>& time) {
    if (!time) return "not known";
    const LabNumber n = format_lab(*time, Dimension::time, 2);
    return n.number + " " + n.unit;
}

Json number(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

std::string softness(double load) {
    if (load < 0.1) return "stiff";
    return load < 1.0 ? "moderately soft" : "soft";
}

std::string reason(const LadderAnswer& answer) {
    const auto& ladder = answer.choice.ladder;
    const auto chosen = std::find_if(ladder.begin(), ladder.end(),
                                     [&](const auto& v) { return v.rung == answer.choice.rung; });
    std::string text = std::string(name_of(chosen->rung)) + ": measured error " + percent(chosen->error);
    if (answer.request.tolerance) {
        text += answer.choice.met ? ", the cheapest within " + percent(answer.request.tolerance)
                                  : ", the least there is; nothing was measured to be within " +
                                        percent(answer.request.tolerance);
        if (answer.request.budget) text += " and " + duration(answer.request.budget);
    } else if (answer.request.budget) {
        text += answer.choice.met ? ", the most accurate within " + duration(answer.request.budget)
                                  : "; no model of known error is within " + duration(answer.request.budget);
    }
    const auto better = std::find_if(chosen + 1, ladder.end(), [&](const auto& v) {
        return v.error && (!chosen->error || *v.error < *chosen->error);
    });
    if (better != ladder.end()) {
        text += ". Next: " + std::string(name_of(better->rung)) + ", " + percent(better->error) + " in " +
                duration(better->time);
    }
    return text;
}

}  // namespace

LadderAnswer climb(const Prediction& prediction, const LadderQuestion& question,
                   const std::optional<SceneKind>& scene) {
    const QuestionKind kind = kind_of(prediction, scene);
    LadderAnswer answer{.request = {.kind = kind,
                                    .load = load_of(kind, prediction),
                                    .tolerance = question.tolerance,
                                    .budget = question.budget},
                        .choice = {}};
    answer.choice = choose_rung(answer.request);
    return answer;
}

Rung first_simulation(const LadderAnswer& answer) {
    const auto& ladder = answer.choice.ladder;
    const auto fits = [](const RungVerdict& v) {
        return resolution_of(v.rung) > 0.0 && v.error && v.accurate && v.affordable;
    };
    const auto found = std::find_if(ladder.begin(), ladder.end(), fits);
    return found == ladder.end() ? Rung::standard : found->rung;
}

std::string_view judged_value(SceneKind scene) {
    if (scene == SceneKind::exit_flow) return "elongational_stress_average";
    return scene == SceneKind::exit ? "von_mises_peak" : "von_mises";
}

Json ladder_object(const LadderAnswer& answer) {
    Json rungs = Json::array();
    for (const RungVerdict& v : answer.choice.ladder) {
        rungs.push_back({{"model", name_of(v.rung)},
                         {"error", number(v.error)},
                         {"time", number(v.time)},
                         {"accurate", v.accurate},
                         {"affordable", v.affordable}});
    }
    return {{"question", name_of(answer.request.kind)},
            {"load", number(answer.request.load)},
            {"tolerance", number(answer.request.tolerance)},
            {"budget", number(answer.request.budget)},
            {"model", name_of(answer.choice.rung)},
            {"met", answer.choice.met},
            {"reason", reason(answer)},
            {"models", std::move(rungs)}};
}

std::string ladder_section(const LadderAnswer& answer, TableStyle style) {
    std::vector<std::vector<std::string>> rows = {{"model", "error", "time", ""}};
    for (const RungVerdict& v : answer.choice.ladder) {
        rows.push_back({std::string(name_of(v.rung)), percent(v.error), duration(v.time),
                        v.rung == answer.choice.rung ? "← taken" : ""});
    }
    const std::string question = "Models for " + std::string(name_of(answer.request.kind)) + ", a " +
                                 softness(answer.request.load) +
                                 " cell: largest error measured, processor time";
    return "\n" + table_heading(question, style) + table_grid(rows, 1) + "  " + reason(answer) + "\n";
}

}  // namespace bioprint
