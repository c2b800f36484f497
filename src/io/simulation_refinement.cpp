#include "io/simulation_refinement.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

/// The numerical error of a scene's judged number, relative.
double own_error(const SimulationResult& run) {
    const SimulatedValue& value = run.at(std::string(judged_value(run.scene)));
    return std::abs(value.error / value.value);
}

std::string gave_up(const SimulationQuestion& question, const std::string& why) {
    return "a finer one, of " + format_shortest(resolution_of(question)) +
           " nodes a cell radius, did not come to its end: " + why;
}

}  // namespace

/// Why a run that came to its end is not to be believed; empty when it is.
std::string breakdown(const SimulationResult& run) {
    const std::string remedy = "; lower the velocity, use a stiffer cell, or a higher --fidelity";
    for (const SimulatedValue& value : run.values) {
        const bool stress = value.name.starts_with("von_mises") || value.name.starts_with("stretch");
        if (!std::isfinite(value.value) || (stress && value.value < 0.0)) {
            return "the simulation broke down (" + value.name + ")" + remedy;
        }
    }
    for (const SimulationWarning& warning : run.warnings) {
        if (warning.code == "distorted-elements") return warning.message + remedy;
    }
    return {};
}

Refinement refine(const SimulationQuestion& question, FunctionRef<Comparison(const SimulationQuestion&)> run,
                  FunctionRef<bool(const SimulationQuestion&, const SimulationResult&)> trusted,
                  FunctionRef<std::string(const SimulationQuestion&)> why_not_finer,
                  FunctionRef<bool()> cancelled) {
    const auto judge = [&](Refinement& r) {
        r.how.error = own_error(r.comparison.run);
        r.how.within =
            r.how.error <= question.tolerance.value_or(1.0) && trusted(r.question, r.comparison.run);
    };
    Refinement best{.comparison = run(question),
                    .question = question,
                    .how = {.error = 0.0, .refined = false, .within = false, .stop = {}}};
    judge(best);
    // One that broke down has no error to go by.
    while (!best.how.within && breakdown(best.comparison.run).empty()) {
        best.how.stop = why_not_finer(best.question);
        if (!best.how.stop.empty()) break;
        const SimulationQuestion finer = finer_than(best.question);
        try {
            Comparison next = run(finer);
            best.how.stop = breakdown(next.run);
            if (best.how.stop.empty()) {
                best.comparison = std::move(next);
                best.question = finer;
                best.how.refined = true;
                judge(best);
                continue;
            }
        } catch (const SimulationIncomplete& e) {
            if (cancelled()) throw;
            best.how.stop = e.what();
        }
        best.how.stop = gave_up(finer, best.how.stop);
        break;
    }
    return best;
}

}  // namespace bioprint
