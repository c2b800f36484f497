#include "cli/long_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"

namespace bioprint {
namespace {

/// How to answer, not what: these may differ when a run goes on.
constexpr std::array<std::string_view, 16> of_this_call = {
    "--jobs",      "--quiet",  "--verbose", "--no-color", "--output", "--history", "--plot",
    "--plot-kind", "--report", "--shard",   "--list",     "--out",    "--resume",  "--checkpoint-interval",
    "--help",      "--version"};
constexpr std::array<std::string_view, 6> of_the_answer = {"--format", "--json",        "--get",
                                                           "--check",  "--uncertainty", "--samples"};

constexpr double most_snapshots = 1000.0;

template <class List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

std::vector<std::string> texts_of(const TypedQuestion& question, const std::string& name) {
    std::vector<std::string> texts;
    for (const TypedOption& option : question) {
        if (option.name == name) texts.push_back(option.text);
    }
    return texts;
}

std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : " ") + text;
    return all;
}

}  // namespace

void add_long_run_options(CLI::App& app, RawLongRun& raw) {
    const std::string group = "A long run";
    app.add_option("--out", raw.out, "keep a simulation, batch or sweep in a new directory")
        ->type_name("DIR")
        ->group(group);
    app.add_option("--resume", raw.resume, "go on with the run in a directory, to the same numbers")
        ->type_name("DIR")
        ->group(group);
    app.add_option("--checkpoint-interval", raw.interval, "between checkpoints (default 10s)")
        ->type_name("QUANTITY")
        ->group(group);
    app.add_option("--snapshots", raw.snapshots,
                   "with --out: pictures for ParaView of each stage of a simulation (default 20, 0: none)")
        ->type_name("N")
        ->group(group);
}

TypedQuestion typed_question(const CLI::App& app) {
    TypedQuestion question;
    std::vector<std::string> seen;
    for (const CLI::Option* option : app.parse_order()) {
        const std::string name = option->get_name();
        if (contains(of_this_call, name) || contains(seen, name)) continue;
        seen.push_back(name);
        for (const std::string& text : option->results()) question.push_back({name, text});
    }
    return question;
}

void collect_long_run(const RawLongRun& raw, Arguments& arguments, Problems& problems) {
    for (const auto& [name, value] : {std::pair{"--out", raw.out}, {"--resume", raw.resume}}) {
        if (value && value->empty())
            problems.add(std::string(name) + ": got an empty name; it takes a directory", name);
    }
    if (raw.out && raw.resume) {
        problems.add("--out: cannot be combined with --resume, which goes on in the run's own directory",
                     "--out");
    }
    LongRun run{.directory = raw.resume ? *raw.resume : raw.out.value_or(""),
                .resumed = raw.resume.has_value()};
    if (raw.interval) {
        problems.collect([&] {
            run.interval = parse_quantity(*raw.interval, Dimension::time, "--checkpoint-interval");
            if (run.interval < 0.0)
                throw UsageError("--checkpoint-interval: takes a time of 0 s or more",
                                 "--checkpoint-interval");
        });
    }
    if (raw.out || raw.resume) {
        arguments.long_run = run;
    } else if (raw.interval) {
        problems.add("--checkpoint-interval: belongs to a run that is kept; add --out",
                     "--checkpoint-interval");
    }
    if (raw.snapshots) {
        problems.collect([&] {
            const double count = parse_quantity(*raw.snapshots, Dimension::dimensionless, "--snapshots");
            if (count != std::floor(count) || count < 0.0 || count > most_snapshots) {
                throw UsageError("--snapshots: takes a whole number from 0 to 1000", "--snapshots");
            }
            if (arguments.simulation) arguments.simulation->snapshots = static_cast<int>(count);
        });
        // Beside --resume it must be what it was, like the question.
        if (!raw.resume && !(raw.out && arguments.simulation)) {
            problems.add("--snapshots: belongs to a simulation that is kept; add --simulate and --out",
                         "--snapshots");
        }
    }
    const bool many = arguments.batch || !arguments.sweep.swept().empty();
    if (raw.out && !arguments.simulation && !many) {
        problems.add("--out: keeps a simulation, a batch or a sweep; for this answer use --output", "--out");
    }
    if (raw.out && arguments.batch == "-") {
        problems.add("--batch: standard input cannot be read again when the run goes on; name a file",
                     "--batch");
    }
    if (raw.out && many && arguments.format == Format::table) {
        problems.add("--format: rows are kept as csv, jsonl or json, not as a table", "--format");
    }
    if ((raw.out || raw.resume) && arguments.list) {
        problems.add("--list: shows presets and asks nothing; leave out --out and --resume", "--list");
    }
}

std::vector<std::string> resumed_words(const std::string& directory, const TypedQuestion& now) {
    const TypedQuestion asked = question_in(directory);
    const bool simulation = !texts_of(asked, "--simulate").empty();
    Problems problems;
    std::vector<std::string> seen;
    for (const TypedOption& option : now) {
        if ((simulation && contains(of_the_answer, option.name)) || contains(seen, option.name)) continue;
        seen.push_back(option.name);
        const std::vector<std::string> before = texts_of(asked, option.name);
        const std::vector<std::string> here = texts_of(now, option.name);
        if (before == here) continue;
        problems.add(option.name + ": got '" + joined(here) + "', but the run in " + directory +
                         " was asked " + (before.empty() ? "without it" : "with '" + joined(before) + "'") +
                         "; leave it out, or begin another run with --out",
                     option.name);
    }
    problems.raise();
    std::vector<std::string> words = {std::string(program_name), "--out=" + directory};
    for (const TypedOption& option : lasting_question_in(directory)) {
        words.push_back(option.name + "=" + option.text);
    }
    return words;
}

Arguments with_call(Arguments then, const Arguments& now) {
    then.jobs = now.jobs;
    then.output = now.output;
    then.history = now.history;
    then.quiet = now.quiet;
    then.verbose = now.verbose;
    then.no_color = now.no_color;
    then.long_run = now.long_run;
    then.pictures = now.pictures;
    if (now.format) then.format = now.format;
    if (!now.paths.empty()) then.paths = now.paths;
    if (!now.checks.empty()) then.checks = now.checks;
    if (now.uncertainty.wanted) then.uncertainty = now.uncertainty;
    return then;
}

}  // namespace bioprint
