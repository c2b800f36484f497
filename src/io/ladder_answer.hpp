#pragma once

#include <optional>
#include <string>

#include "bioprint/predict/ladder.hpp"
#include "bioprint/predict/prediction.hpp"
#include "bioprint/simulate/simulation.hpp"
#include "io/answer_object.hpp"
#include "io/table.hpp"

/// `--tolerance`, `--budget` and `--explain`: which model answers, why, and what the next one would cost and gain.
namespace bioprint {

struct LadderQuestion {
    std::optional<double> tolerance;  ///< largest relative error wanted
    std::optional<double> budget;     ///< longest time wanted [s]
};

struct LadderAnswer {
    RungRequest request;
    RungChoice choice;
};

/// The kind and softness of a question: its cell at the exit, on the axis where there is one; with a scene, that one.
LadderAnswer climb(const Prediction& prediction, const LadderQuestion& question,
                   const std::optional<SceneKind>& scene);

/// The same when a simulation was asked for: no rung below the drafts.
Rung first_simulation(const LadderAnswer& answer);

/// The number of a scene by which a tolerance is judged: "von_mises_peak" …
std::string_view judged_value(SceneKind scene);

Json ladder_object(const LadderAnswer& answer);
std::string ladder_section(const LadderAnswer& answer, TableStyle style);

}  // namespace bioprint
