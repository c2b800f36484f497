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

/// How a simulation that was refined to a tolerance ended.
struct RefinedRun {
    double error;      ///< its own numerical one, relative
    bool refined;      ///< it was not the first
    bool within;       ///< the tolerance, by that and by what was measured of such runs
    std::string stop;  ///< why it was not refined further; empty: no finer one is tried
};

struct LadderAnswer {
    RungRequest request;
    RungChoice choice;
    std::optional<RefinedRun> run = {};
    bool timed = true;  ///< the longest times measured hold for this question
};

struct SimulationQuestion;

/// The kind and softness of a question: its cell at the exit, on the axis where there is one; with a simulation, the cell
/// of its scene, and no rung below the drafts. A rung that would refuse the question says so.
/// @param simulation  null when none was asked for
LadderAnswer climb(const Prediction& prediction, const LadderQuestion& question,
                   const SimulationQuestion* simulation);

/// The answer once its simulation has been run: `met` follows the run's own error.
LadderAnswer after_run(LadderAnswer answer, Rung rung, RefinedRun run);

/// The number of a scene by which a tolerance is judged: "von_mises_peak" …
std::string_view judged_value(SceneKind scene);

/// What was asked for and is not had; none when all is.
std::optional<Warning> shortfall(const LadderAnswer& answer);

Json ladder_object(const LadderAnswer& answer);
std::string ladder_section(const LadderAnswer& answer, TableStyle style);

}  // namespace bioprint
