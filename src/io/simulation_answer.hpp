#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "bioprint/predict/comparison.hpp"
#include "io/run.hpp"
#include "io/simulation_files.hpp"
#include "io/simulation_question.hpp"

/// `--simulate`: a prediction, its simulation, their difference and the simulation's own error side by side.
namespace bioprint {

/// The answer to a row of a sweep: prediction, simulation and their difference.
/// @throws NotConverged  the simulation did not come to its end; and as below
Json simulated_row(const Settings& settings, const SimulationQuestion& question,
                   const SimulationOptions& simulation);

/// Predicts, simulates and writes the answer. What an interrupted run had is written before its error goes
/// on. `files`, where there are any, keep the run's state, its series and its answer. Returns a line for each
/// check that does not hold.
/// @param seen  gets prediction and comparison once the answer is written, for a picture or report
/// @throws SimulationIncomplete  and what predict() and simulate() throw
std::vector<std::string> answer_with_simulation(
    const Settings& settings, SimulationQuestion question, RunOptions options, SimulationOptions simulation,
    const Sink& sink, SimulationFiles* files = nullptr,
    const std::function<void(const Prediction&, const Comparison&)>& seen = {});

}  // namespace bioprint
