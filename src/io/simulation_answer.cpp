#include "io/simulation_answer.hpp"

#include <algorithm>
#include <utility>

#include "bioprint/errors.hpp"
#include "io/answer_checks.hpp"
#include "io/answer_object.hpp"
#include "io/answer_path.hpp"
#include "io/ladder_answer.hpp"
#include "io/row_answer.hpp"
#include "io/simulated_answer.hpp"
#include "io/simulation_refinement.hpp"
#include "io/table.hpp"

namespace bioprint {
namespace {

/// The value at a path; null in an answer that has not come so far.
std::string value_line(const Json& answer, const std::string& path, bool whole) {
    try {
        return value_text(value_meant(answer, path)) + "\n";
    } catch (const UsageError&) {
        if (whole) throw;
        return "null\n";
    }
}

/// Returns a line for each check that does not hold.
/// @param whole  the run came to its end
std::vector<std::string> write(const Prediction& prediction, const Comparison& comparison,
                               const SimulationQuestion& question, const Settings& settings,
                               const RunOptions& options, const Sink& sink, bool whole) {
    Json answer = simulated_answer_object(prediction, comparison, question);
    if (options.ladder) answer["choice"] = ladder_object(*options.ladder);
    const ExtraResults results = add_extras(answer, settings, options.extras, options.jobs, true);
    if (options.seen) options.seen(answer);
    if (!options.paths.empty()) {
        for (const std::string& path : options.paths) {
            sink(value_line(answer, path, whole));
        }
    } else if (options.format == Format::table) {
        sink(answer_table(prediction, options.style) + simulation_table(comparison, question, options.style) +
             extras_sections(answer, options.extras, results, options.style) +
             (options.ladder ? ladder_section(*options.ladder, options.style) : ""));
    } else {
        sink(json_text(answer, options.format == Format::json ? 2 : -1) + "\n");
    }
    CheckTally tally(options.extras.checks);
    tally.add(results.checks);
    return tally.lines();
}

/// A cell that is still drawn out when it is judged has no error that two runs could tell.
bool settled(const SimulationResult& run) {
    return std::none_of(run.warnings.begin(), run.warnings.end(), [](const SimulationWarning& warning) {
        return warning.code == "channel-not-steady" || warning.code == "strong-deformation";
    });
}

/// Nothing that was measured of such runs says otherwise.
bool measured_within(const std::optional<LadderAnswer>& ladder, const SimulationQuestion& question) {
    if (!ladder) return true;
    const Rung rung = rung_of(resolution_of(question));
    return std::all_of(ladder->choice.ladder.begin(), ladder->choice.ladder.end(), [&](const auto& v) {
        return v.rung != rung || !v.error || *v.error <= question.tolerance.value_or(1.0);
    });
}

Comparison remarked(Comparison comparison, const ChosenScene& chosen) {
    if (!chosen.remark.empty()) {
        comparison.run.warnings.push_back({.code = "simulated-position", .message = chosen.remark});
    }
    return comparison;
}

}  // namespace

Json simulated_row(const Settings& settings, const SimulationQuestion& question,
                   const SimulationOptions& simulation) {
    const Prediction prediction = predict(settings.make_case());
    const ChosenScene chosen = choose_scene(question, prediction);
    check_simulation(prediction, question);
    const Comparison comparison =
        remarked(compare_with_simulation(prediction, chosen.scene, options_of(question, simulation)), chosen);
    const std::string failure = breakdown(comparison.run);
    if (!failure.empty()) throw NotConverged(failure);
    return simulated_answer_object(prediction, comparison, question);
}

std::vector<std::string> answer_with_simulation(
    const Settings& settings, SimulationQuestion question, RunOptions options, SimulationOptions simulation,
    const Sink& sink, SimulationFiles* files,
    const std::function<void(const Prediction&, const Comparison&)>& seen) {
    if (options.format == Format::csv) {
        throw UsageError("--format: a simulation is answered as table, json or jsonl", "--format");
    }
    const Prediction prediction = predict(settings.make_case());
    const ChosenScene chosen = choose_scene(question, prediction);
    check_simulation(prediction, question);
    if (files != nullptr) files->attach(simulation, question.snapshots);
    std::vector<std::string> failed;
    const auto run = [&](const SimulationQuestion& asked) {
        question = asked;
        return compare_with_simulation(prediction, chosen.scene, options_of(asked, simulation));
    };
    try {
        Comparison comparison;
        if (question.tolerance) {
            Refinement refinement = refine(
                question, run,
                [&](const SimulationQuestion& asked, const SimulationResult& result) {
                    return settled(result) && measured_within(options.ladder, asked);
                },
                [&](const SimulationQuestion& asked) { return why_not_finer(prediction, asked); },
                [&] { return simulation.cancel != nullptr && *simulation.cancel; });
            question = refinement.question;
            comparison = std::move(refinement.comparison);
            if (options.ladder)
                options.ladder = after_run(*options.ladder, rung_of(resolution_of(question)), refinement.how);
        } else {
            comparison = run(question);
        }
        comparison = remarked(std::move(comparison), chosen);
        if (const auto missed = options.ladder ? shortfall(*options.ladder) : std::nullopt)
            comparison.run.warnings.push_back({.code = missed->code, .message = missed->message});
        const std::string failure = breakdown(comparison.run);
        if (!failure.empty()) throw SimulationIncomplete(failure, comparison.run);
        if (files != nullptr) {
            files->write_series(comparison.run.series);
            files->write_answer(json_text(simulated_answer_object(prediction, comparison, question), 2) +
                                "\n");
        }
        failed = write(prediction, comparison, question, settings, options, sink, true);
        if (seen) seen(prediction, comparison);
    } catch (const SimulationIncomplete& e) {
        if (files != nullptr) files->write_series(e.result().series);
        write(prediction, remarked(compare(prediction, e.result()), chosen), question, settings, options,
              sink, false);
        throw;
    }
    // It is an answer, but not the one asked for.
    if (const auto missed = options.ladder ? shortfall(*options.ladder) : std::nullopt)
        throw SimulationIncomplete(missed->message, {});
    return failed;
}

}  // namespace bioprint
