#include "cli/ladder_options.hpp"

#include "bioprint/errors.hpp"
#include "bioprint/io/quantity.hpp"

namespace bioprint {
namespace {

constexpr double largest_tolerance = 1.0;

Fidelity fidelity_of(Rung rung) {
    if (rung == Rung::fine) return Fidelity::fine;
    return rung == Rung::draft ? Fidelity::draft : Fidelity::standard;
}

double above_zero(const std::string& text, Dimension dimension, const char* option) {
    const double value = parse_quantity(text, dimension, option);
    if (!(value > 0.0)) {
        throw UsageError(std::string(option) + ": got '" + text + "'; it takes a quantity above 0", option);
    }
    return value;
}

/// What the question is answered by when nothing was asked of its accuracy.
Rung present_rung(const Arguments& arguments) {
    if (arguments.simulation) return rung_of(resolution_of(*arguments.simulation));
    const Settings& settings = arguments.sweep.fixed();
    return settings.has(Key::model) && settings.at(Key::model).text == "steady" ? Rung::steady
                                                                                : Rung::ellipsoid;
}

}  // namespace

void add_ladder_options(CLI::App& app, RawLadder& raw) {
    const std::string group = "The trade of speed for accuracy";
    app.add_option("--tolerance", raw.tolerance,
                   "answer by the cheapest model measured to be within this relative error, such as 5%; a "
                   "simulation is refined until it is")
        ->type_name("SHARE")
        ->group(group);
    app.add_option("--budget", raw.budget, "answer by the most accurate model within this time, such as 10s")
        ->type_name("TIME")
        ->group(group);
    app.add_flag("--explain", raw.explain,
                 "say which model answers and why, and what the others would cost and gain")
        ->group(group);
    app.add_flag(
           "--dry-run", raw.dry_run,
           "answer nothing; say how many rows, by which model, time and memory, and what would be refused")
        ->group(group);
}

void collect_ladder(const RawLadder& raw, Arguments& arguments, Problems& problems) {
    arguments.dry_run = raw.dry_run;
    if (!raw.tolerance && !raw.budget && !raw.explain) return;
    LadderQuestion question;
    if (raw.tolerance) {
        problems.collect([&] {
            question.tolerance = above_zero(*raw.tolerance, Dimension::dimensionless, "--tolerance");
            if (*question.tolerance > largest_tolerance) {
                throw UsageError("--tolerance: got '" + *raw.tolerance + "'; it takes a share up to 100%",
                                 "--tolerance");
            }
        });
    }
    if (raw.budget)
        problems.collect([&] { question.budget = above_zero(*raw.budget, Dimension::time, "--budget"); });
    const char* const name = raw.tolerance ? "--tolerance" : raw.budget ? "--budget" : "--explain";
    if (arguments.batch || !arguments.sweep.swept().empty()) {
        problems.add(std::string(name) + ": one question at a time; leave out --batch and lists", name);
    }
    if ((raw.tolerance || raw.budget) && arguments.sweep.fixed().has(Key::model)) {
        problems.add(std::string(name) + ": chooses the model; leave out --model", name);
    }
    if ((raw.tolerance || raw.budget) && arguments.long_run) {
        problems.add(std::string(name) +
                         ": chooses the resolution, and a run in a directory keeps its own; "
                         "give --fidelity with --out",
                     name);
    }
    arguments.ladder = question;
}

LadderAnswer take_rung(Arguments& arguments) {
    const Prediction prediction = predict(arguments.sweep.fixed().make_case());
    LadderAnswer answer =
        climb(prediction, *arguments.ladder, arguments.simulation ? &*arguments.simulation : nullptr);
    if (!arguments.ladder->tolerance && !arguments.ladder->budget) {
        answer.choice.rung = present_rung(arguments);
        return answer;
    }
    if (resolution_of(answer.choice.rung) > 0.0) {
        if (!arguments.simulation) arguments.simulation.emplace();
        arguments.simulation->fidelity = fidelity_of(answer.choice.rung);
        arguments.simulation->tolerance = arguments.ladder->tolerance;
        arguments.simulation->budget = arguments.ladder->budget;
    } else if (answer.choice.rung == Rung::steady) {
        arguments.sweep.add(Key::model, "steady", "--model");
    }
    return answer;
}

}  // namespace bioprint
