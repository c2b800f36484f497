#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "cli/call_problems.hpp"
#include "cli/design_options.hpp"
#include "cli/ladder_options.hpp"
#include "cli/long_run.hpp"
#include "cli/picture_options.hpp"
#include "io/whole_file.hpp"

namespace bioprint {
namespace {

constexpr const char* description =
    "Predicts the stress and strain of cells during extrusion bioprinting: give nozzle, flow and ink.\n"
    "Without options it answers for the reference case (50 µm, 5 mm/s, alginate, cell of 8 µm and 1 kPa).";

constexpr const char* footer = R"(
Quantities: a number alone is SI; units convert: 50um, 141uL/h, 5mm/s, 10Pa.s, 1kPa, 30psi.
  A list 0,0.3,0.75 or a range 0:0.75:0.15 makes a sweep, the last option fastest.
Examples:
  bioprint-predict --radius 50um --flowrate 141uL/h --alpha 0.75
  bioprint-predict --needle 25G --tip steel --flowrate 20uL/min --ink alginate-2-25C --json
  bioprint-predict --batch runs.csv --output answers.csv
  bioprint-predict --alpha 0.75 --simulate=exit --fidelity draft
  bioprint-predict fit rheometer.csv          (its own options: bioprint-predict fit --help)
Exit status: 0 answered, 1 a bug, 2 the call is wrong, 3 no steady flow, 4 a file could not be
  read or written, 5 a simulation did not come to its end, or --tolerance or --budget is not
  kept, 6 some rows of a batch failed, 7 a --check or a limit does not hold, 130 interrupted.
The full reference: man bioprint-predict)";

struct Raw {
    std::vector<std::string> values[key_count];
    std::optional<std::string> batch;
    std::optional<std::string> format;
    std::optional<std::string> output;
    std::optional<std::string> list;
    std::optional<std::string> jobs;
    std::vector<std::string> paths;
    std::vector<std::string> checks;
    bool uncertainty = false;
    std::optional<std::string> samples;
    std::string scene;
    std::string population;
    std::optional<std::string> history;
    RawPictures pictures;
    std::optional<std::string> fidelity;
    std::optional<std::string> resolution;
    std::optional<std::string> fluid_stress;
    std::optional<std::string> channel_time;
    bool json = false;
    RawDesign design;
    RawLongRun long_run;
    RawLadder ladder;
};

std::string option_names(const KeyInfo& info) {
    std::string names = "--" + std::string(info.option);
    if (!info.short_name.empty()) names = "-" + std::string(info.short_name) + "," + names;
    return names;
}

void add_prediction_options(CLI::App& app, Raw& raw) {
    for (const KeyInfo& info : key_table()) {
        if (info.key == Key::population) {
            app.add_flag("--population{yes}", raw.population, std::string(info.help))->group("The question");
            continue;
        }
        auto* option = app.add_option(option_names(info), raw.values[static_cast<std::size_t>(info.key)],
                                      std::string(info.help));
        option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->group("The question");
        option->type_name(info.dimension && info.key != Key::profile ? "QUANTITY"
                          : info.key == Key::profile                 ? "N"
                                                                     : "TEXT");
    }
}

void add_answer_options(CLI::App& app, Raw& raw, Arguments& arguments) {
    const std::string group = "The answer";
    app.add_option("--batch", raw.batch, "one question a row: a CSV or JSON Lines file, - for standard input")
        ->type_name("FILE")
        ->group(group);
    app.add_option("-f,--format", raw.format,
                   "table, json, jsonl or csv (default table; a batch answers in kind)")
        ->type_name("FORMAT")
        ->group(group);
    app.add_flag("--json", raw.json, "the same as --format json")->group(group);
    app.add_option("--get", raw.paths, "print this value alone, such as nozzle.stress_max; may be repeated")
        ->type_name("PATH")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(group);
    app.add_option("--check", raw.checks,
                   "exit status 7 unless this holds, such as 'nozzle.stress_max<2kPa'; may be repeated")
        ->type_name("EXPR")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->group(group);
    app.add_flag("--uncertainty", raw.uncertainty,
                 "spread of the answer by that of the inputs (0.75±0.05) and the presets' scatter")
        ->group(group);
    app.add_option("--samples", raw.samples,
                   "of the inputs, for the spread (default 1024, with --population 256)")
        ->type_name("N")
        ->group(group);
    app.add_option("-o,--output", raw.output, "write there, whole or not at all")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--history", raw.history, "write the cells' way through nozzle and exit there, as CSV")
        ->type_name("FILE")
        ->group(group);
    add_picture_options(app, raw.pictures, group);
    app.add_option("--list", raw.list, "show the presets: inks, cells or nozzles")
        ->type_name("KIND")
        ->group(group);
    app.add_option("-j,--jobs", raw.jobs,
                   "threads of a batch, sweep, simulation or population (default all cores)")
        ->type_name("N")
        ->group(group);
    app.add_flag("-q,--quiet", arguments.quiet, "no notes, no remarks")->group(group);
    app.add_flag("-v,--verbose", arguments.verbose, "add the reference quadrature's error estimates")
        ->group(group);
    app.add_flag("--no-color", arguments.no_color, "no colour, as does NO_COLOR")->group(group);
}

void add_simulation_options(CLI::App& app, Raw& raw) {
    const std::string group = "The simulation";
    app.add_flag("--simulate{auto}", raw.scene,
                 "verify by simulation; --simulate=SCENE with shear, channel, exit-flow, exit or auto")
        ->group(group);
    app.add_option("--fidelity", raw.fidelity, "draft, standard or fine: 3, 6 or 12 nodes a cell radius")
        ->type_name("WORD")
        ->group(group);
    app.add_option("--resolution", raw.resolution, "nodes a cell radius, in place of --fidelity")
        ->type_name("N")
        ->group(group);
    app.add_option("--fluid-stress", raw.fluid_stress,
                   "stress of the ink in the scene shear (default that at the first position off the axis)")
        ->type_name("QUANTITY")
        ->group(group);
    app.add_option("--channel-time", raw.channel_time,
                   "how long the cell flows in the nozzle (default until its shape is steady)")
        ->type_name("QUANTITY")
        ->group(group);
}

void print(const std::string& text) {
    WholeFile output("-");
    output.write(text);
    output.commit();
}

std::optional<Format> parse_format(const std::string& text) {
    if (text == "table") return Format::table;
    if (text == "json") return Format::json;
    if (text == "jsonl") return Format::jsonl;
    if (text == "csv") return Format::csv;
    return std::nullopt;
}

std::optional<unsigned> parse_jobs(const std::string& text) {
    const bool digits = !text.empty() && text.size() <= 4 &&
                        std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    const int jobs = digits ? std::stoi(text) : 0;
    return jobs > 0 ? std::optional(static_cast<unsigned>(jobs)) : std::nullopt;
}

/// The prediction's options in the order typed, so that the last one is the fastest of a sweep.
void collect_question(const CLI::App& app, const Raw& raw, Arguments& arguments, Problems& problems) {
    std::vector<Key> order;
    for (const CLI::Option* option : app.parse_order()) {
        const std::optional<Key> key = find_key(option->get_name());
        if (key && std::find(order.begin(), order.end(), *key) == order.end()) order.push_back(*key);
    }
    for (const Key key : order) {
        if (key == Key::population) {
            problems.collect([&] { arguments.sweep.add(key, raw.population, "--population"); });
            continue;
        }
        if (key == Key::threshold) {
            std::string all;
            for (const std::string& text : raw.values[static_cast<std::size_t>(key)])
                all += (all.empty() ? "" : ",") + text;
            problems.collect([&] { arguments.sweep.add(key, all, "--threshold"); });
            continue;
        }
        for (const std::string& text : raw.values[static_cast<std::size_t>(key)]) {
            problems.collect(
                [&] { arguments.sweep.add(key, text, "--" + std::string(info_of(key).option)); });
            arguments.given.emplace_back(key, text);
        }
    }
}

void collect_uncertainty(const Raw& raw, Arguments& arguments, Problems& problems) {
    arguments.uncertainty.presets = raw.uncertainty;
    arguments.uncertainty.wanted = raw.uncertainty || arguments.sweep.fixed().has_deviation();
    if (!raw.samples) return;
    const std::string& text = *raw.samples;
    const bool digits = !text.empty() && text.size() <= 5 &&
                        std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t samples = digits ? std::stoul(text) : 0;
    if (samples < 8 || samples > 65536) {
        problems.add("--samples: got '" + text + "'; it takes a number from 8 to 65536, best a power of 2",
                     "--samples");
    } else if (!arguments.uncertainty.wanted && !arguments.batch) {
        problems.add(
            "--samples: belongs to an uncertainty; add --uncertainty, or a spread such as --alpha 0.75±0.05",
            "--samples");
    }
    arguments.uncertainty.samples = samples;
}

void collect_answer(const Raw& raw, Arguments& arguments, Problems& problems) {
    arguments.batch = raw.batch;
    arguments.output = raw.output;
    arguments.history = raw.history;
    if (raw.history && (raw.batch || !arguments.sweep.swept().empty())) {
        problems.add("--history: one question at a time; leave out --batch and lists", "--history");
    }
    for (const auto& [name, value] :
         {std::pair{"--batch", raw.batch}, {"--output", raw.output}, {"--history", raw.history}}) {
        if (value && value->empty())
            problems.add(std::string(name) + ": got an empty name; it takes a file", name);
    }
    if (raw.format) {
        arguments.format = parse_format(*raw.format);
        if (!arguments.format) {
            problems.add("--format: got '" + *raw.format + "'; it takes table, json, jsonl or csv",
                         "--format");
        } else if (raw.json && arguments.format != Format::json) {
            problems.add("--json: cannot be combined with --format " + *raw.format + "; give one of the two",
                         "--json");
        }
    } else if (raw.json) {
        arguments.format = Format::json;
    }
    arguments.paths = raw.paths;
    collect_uncertainty(raw, arguments, problems);
    for (const std::string& text : raw.checks) {
        problems.collect([&] { arguments.checks.push_back(parse_check(text, "--check")); });
    }
    if (needs_population(arguments.checks) && !arguments.sweep.fixed().has(Key::population)) {
        arguments.sweep.add(Key::population, "yes", "--check");
    }
    if (raw.list) {
        if (*raw.list == "inks" || *raw.list == "cells" || *raw.list == "nozzles") {
            arguments.list = raw.list;
        } else {
            problems.add("--list: got '" + *raw.list + "'; it takes inks, cells or nozzles", "--list");
        }
    }
    if (raw.jobs) {
        arguments.jobs = parse_jobs(*raw.jobs);
        if (!arguments.jobs) {
            problems.add("--jobs: got '" + *raw.jobs + "'; it takes a number of threads from 1 to 9999",
                         "--jobs");
        }
    }
    if (arguments.batch && !arguments.sweep.swept().empty()) {
        const std::string name = "--" + std::string(info_of(arguments.sweep.swept().front()).option);
        problems.add(
            name + ": a list cannot be combined with --batch; give one value, or put the values in rows",
            name);
    }
}

void collect_simulation(const Raw& raw, Arguments& arguments, Problems& problems) {
    SimulationQuestion question;
    if (raw.fidelity) {
        if (*raw.fidelity == "draft") {
            question.fidelity = Fidelity::draft;
        } else if (*raw.fidelity == "fine") {
            question.fidelity = Fidelity::fine;
        } else if (*raw.fidelity != "standard") {
            problems.add("--fidelity: got '" + *raw.fidelity + "'; it takes draft, standard or fine",
                         "--fidelity");
        }
    }
    if (raw.resolution) {
        problems.collect([&] {
            question.resolution = parse_quantity(*raw.resolution, Dimension::dimensionless, "--resolution");
            if (*question.resolution < 3.0 || *question.resolution > 48.0) {
                throw UsageError("--resolution: takes 3 to 48 nodes a cell radius", "--resolution");
            }
        });
    }
    const auto positive = [&](const std::optional<std::string>& text, Dimension dimension, const char* option,
                              std::optional<double>& value) {
        if (!text) return;
        problems.collect([&] {
            value = parse_quantity(*text, dimension, option);
            if (!(*value > 0.0)) {
                throw UsageError(std::string(option) + ": got '" + *text + "'; it takes a quantity above 0",
                                 option);
            }
        });
    };
    positive(raw.fluid_stress, Dimension::pressure, "--fluid-stress", question.fluid_stress);
    positive(raw.channel_time, Dimension::time, "--channel-time", question.channel_time);
    if (raw.scene.empty()) {
        for (const auto& [name, given] : {std::pair{"--fidelity", raw.fidelity.has_value()},
                                          {"--resolution", raw.resolution.has_value()},
                                          {"--fluid-stress", raw.fluid_stress.has_value()},
                                          {"--channel-time", raw.channel_time.has_value()}}) {
            if (given) problems.add(std::string(name) + ": belongs to a simulation; add --simulate", name);
        }
        return;
    }
    if (raw.fidelity && (raw.ladder.tolerance || raw.ladder.budget)) {
        const std::string name = raw.ladder.tolerance ? "--tolerance" : "--budget";
        problems.add(name + ": chooses the fidelity; leave out --fidelity, or begin at a --resolution", name);
    }
    question.scene = raw.scene;
    arguments.simulation = question;
    if (arguments.batch) problems.add("--simulate: takes a question or lists, not --batch", "--simulate");
    if (arguments.sweep.swept().empty()) return;
    const bool table = arguments.format == Format::table || arguments.format == Format::csv;
    if (table && arguments.paths.empty()) {
        problems.add("--format: simulations of a sweep are answered in json or jsonl, or by --get",
                     "--format");
    }
}

}  // namespace

namespace {

std::vector<std::string> long_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

std::optional<Arguments> parse_words(int argc, const char* const* argv) {
    CLI::App app(description, std::string(program_name));
    app.set_help_flag("-h,--help", "this text");
    app.set_version_flag("--version", std::string(program_name) + " " + std::string(program_version()));
    app.footer(footer);
    app.allow_extras();
    app.get_formatter()->column_width(34);

    take_last_of_repeated(app);
    Arguments arguments;
    Raw raw;
    add_prediction_options(app, raw);
    add_answer_options(app, raw, arguments);
    add_simulation_options(app, raw);
    const CLI::App* const design = add_design(app, raw.design);
    // For the list of --help: `fit` has options of its own and is told apart before these are read.
    CLI::App* const fit =
        app.add_subcommand("fit", "the ink of a flow curve; options: bioprint-predict fit --help");
    fit->prefix_command();
    app.require_subcommand(0, 1);
    add_long_run_options(app, raw.long_run);
    add_ladder_options(app, raw.ladder);
    Problems problems;
    bool read = true;
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        print(app.help());
        return std::nullopt;
    } catch (const CLI::CallForVersion&) {
        print(app.version() + "\n");
        return std::nullopt;
    } catch (const CLI::ParseError& e) {
        problems.add(e.what());
        read = false;
    }
    add_repeated_options(app, problems);
    add_repeated_options(*design, problems);
    if (fit->parsed()) {
        problems.add("'fit': comes first: bioprint-predict fit FILE; see bioprint-predict fit --help", "fit");
    }
    add_extra_arguments(app.remaining(), long_names(app), "bioprint-predict --help", problems);
    arguments.typed = typed_question(app);
    // Beside --resume the question is what the run was asked.
    if (!raw.long_run.resume) collect_question(app, raw, arguments, problems);
    collect_answer(raw, arguments, problems);
    if (!raw.long_run.resume) collect_simulation(raw, arguments, problems);
    collect_long_run(raw.long_run, arguments, problems);
    collect_ladder(raw.ladder, arguments, problems);
    // What is missing there is known only once every option could be read.
    if (design->parsed() && read) collect_design(raw.design, arguments, problems);
    collect_pictures(raw.pictures, arguments, problems);
    arguments.pictures.call.assign(argv, argv + argc);
    // Where the program lies is nobody's question.
    if (argc > 0) arguments.pictures.call.front() = program_name;
    if (!problems.empty() && !arguments.batch && arguments.sweep.swept().empty()) {
        add_range_problems(arguments.sweep.fixed(), problems);
    }
    problems.raise();
    return arguments;
}

}  // namespace

std::optional<Arguments> parse_arguments(int argc, const char* const* argv) {
    std::optional<Arguments> now = parse_words(argc, argv);
    if (!now || !now->long_run || !now->long_run->resumed) return now;
    const std::vector<std::string> words = resumed_words(now->long_run->directory, now->typed);
    std::vector<const char*> pointers;
    pointers.reserve(words.size());
    for (const std::string& word : words) pointers.push_back(word.c_str());
    std::optional<Arguments> then = parse_words(static_cast<int>(pointers.size()), pointers.data());
    return with_call(std::move(then).value(), *now);
}

}  // namespace bioprint
