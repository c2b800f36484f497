#pragma once

#include <string>

#include "bioprint/function_ref.hpp"
#include "bioprint/predict/comparison.hpp"
#include "io/ladder_answer.hpp"
#include "io/simulation_question.hpp"

/// Finer and finer runs, until one is within the tolerance.
namespace bioprint {

/// Why a run that came to its end is not to be believed; empty when it is.
std::string breakdown(const SimulationResult& run);

struct Refinement {
    Comparison comparison;        ///< of the finest run that did not break down
    SimulationQuestion question;  ///< it answers
    RefinedRun how;
};

/// Doubles the resolution until the run's own error is within the tolerance, or a finer one is out of reach or
/// breaks down; the coarser answer then stands.
/// @param run            simulates one question
/// @param trusted        whether a run like this may be taken within the tolerance once its own error is
/// @param why_not_finer  why no run finer than this is tried; empty when it is
/// @param cancelled      whether a run that did not come to its end was stopped by the user: its error goes on
/// @throws what `run` throws the first time
Refinement refine(const SimulationQuestion& question, FunctionRef<Comparison(const SimulationQuestion&)> run,
                  FunctionRef<bool(const SimulationQuestion&, const SimulationResult&)> trusted,
                  FunctionRef<std::string(const SimulationQuestion&)> why_not_finer,
                  FunctionRef<bool()> cancelled);

}  // namespace bioprint
