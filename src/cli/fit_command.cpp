#include "cli/fit_command.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iostream>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "bioprint/io/quantity.hpp"
#include "cli/call_problems.hpp"
#include "cli/named_files.hpp"
#include "io/fit_answer.hpp"
#include "io/fit_picture.hpp"
#include "io/fit_table.hpp"
#include "io/gnuplot.hpp"
#include "io/plot.hpp"
#include "io/settings.hpp"
#include "io/whole_file.hpp"
#include "io/workbook.hpp"

namespace bioprint {
namespace {

constexpr const char* description =
    "Fits the viscosity law of an ink to a rheometer's flow curve, with errors, and says what the data leave "
    "open.\n"
    "Reads exports of Anton Paar RheoCompass, TA TRIOS, Malvern rSpace, CSV, and plain columns; finds the "
    "columns by unit.";

constexpr const char* footer = R"(
Examples:
  bioprint-predict fit alginate.csv
  bioprint-predict fit export.txt --interval 2 --preset ink.json && bioprint-predict --ink ink.json
  bioprint-predict fit export.txt --law best --get fit.law
Exit status: 0 fitted, 2 the call or the file's content is wrong, 4 a file could not be read or written.
The full reference: man bioprint-predict)";

struct Raw {
    std::optional<std::string> file;
    std::optional<std::string> law;
    std::optional<std::string> interval;
    std::optional<std::string> eta_inf;
    std::optional<std::string> name;
    std::optional<std::string> preset;
    std::optional<std::string> plot;
    std::optional<std::string> format;
    std::optional<std::string> output;
    std::vector<std::string> paths;
    bool json = false;
    bool quiet = false;
    bool no_color = false;
};

enum class FitFormat { table, json, csv };

struct FitCall {
    FitQuestion question;
    std::optional<PlotQuestion> plot;
    FitFormat format = FitFormat::table;
};

void add_options(CLI::App& app, Raw& raw) {
    app.add_option("FILE", raw.file, "the rheometer's export, - for standard input")->type_name("");
    app.add_option("--law", raw.law,
                   "cross (default), newtonian, power-law, carreau-yasuda, herschel-bulkley, or best")
        ->type_name("LAW");
    app.add_option("--interval", raw.interval,
                   "these intervals alone, 1,3 (default every flow curve in the file)")
        ->type_name("N");
    app.add_option("--eta-inf", raw.eta_inf, "infinite-shear viscosity: held at a value (default 0), or fit")
        ->type_name("QUANTITY");
    app.add_option("--name", raw.name, "of the ink (default: of the file)")->type_name("TEXT");
    app.add_option("--preset", raw.preset, "write the ink there, as a preset")->type_name("FILE");
    app.add_option("--plot", raw.plot, "draw it there: .svg, .png or .pdf; - draws in the terminal")
        ->type_name("FILE");
    app.add_option("-f,--format", raw.format,
                   "table (default), json, or csv: the points with fit and residual")
        ->type_name("FORMAT");
    app.add_flag("--json", raw.json, "the same as --format json");
    app.add_option("--get", raw.paths,
                   "print this value alone, such as fit.parameters.eta0.value; may be repeated")
        ->type_name("PATH")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("-o,--output", raw.output, "write there, whole or not at all")->type_name("FILE");
    app.add_flag("-q,--quiet", raw.quiet, "no notes");
    app.add_flag("--no-color", raw.no_color, "no colour, as does NO_COLOR");
}

std::optional<FittedLaw> parse_law(const std::string& text) {
    for (const FittedLaw law : {FittedLaw::newtonian, FittedLaw::power_law, FittedLaw::cross,
                                FittedLaw::carreau_yasuda, FittedLaw::herschel_bulkley}) {
        if (text == law_name(law)) return law;
    }
    return {};
}

std::vector<std::size_t> parse_intervals(const std::string& text) {
    std::vector<std::size_t> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        std::size_t number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        const bool good = error == std::errc{} && number > 0 && (next == end || *next == ',');
        if (!good) {
            throw UsageError(
                "--interval: got '" + text + "'; it takes the number of an interval from 1, or a list 1,3",
                "--interval");
        }
        numbers.push_back(number);
        if (next == end) return numbers;
        at = next + 1;
    }
}

void check_plot(const Raw& raw, FitCall& call, Problems& problems) {
    if (!raw.plot) return;
    call.plot = PlotQuestion{.file = *raw.plot};
    problems.collect([&] { checked_canvas(*call.plot); });
    const bool shared = *raw.plot == "-" && !raw.output;
    if (shared && (call.format != FitFormat::table || !raw.paths.empty())) {
        problems.add(
            "--plot: - would draw between the lines of the answer; name a file, or send the answer to one "
            "with --output",
            "--plot");
    }
}

void check_files(const Raw& raw, Problems& problems) {
    const std::vector<NamedFile> files = {{.option = "FILE", .file = raw.file, .written = false},
                                          {.option = "--output", .file = raw.output},
                                          {.option = "--preset", .file = raw.preset},
                                          {.option = "--plot", .file = raw.plot}};
    refuse_shared_files(files, problems);
    require_ending(files[2], "a preset", {".json"}, problems);
    if (raw.output && names_workbook(*raw.output)) {
        problems.add("--output: a fit has no workbook; name another, such as one in .csv with --format csv",
                     "--output");
    }
}

FitCall check(const Raw& raw, Problems& problems) {
    FitCall call;
    if (!raw.file || raw.file->empty()) {
        problems.add("fit: takes a FILE with a flow curve; see bioprint-predict fit --help", "FILE");
    } else {
        call.question.file = *raw.file;
    }
    if (raw.law && *raw.law == "best") {
        call.question.law.reset();
    } else if (raw.law) {
        call.question.law = parse_law(*raw.law);
        if (!call.question.law) {
            problems.add(
                "--law: got '" + *raw.law +
                    "'; it takes cross, newtonian, power-law, carreau-yasuda, herschel-bulkley or best",
                "--law");
        }
    }
    if (raw.interval) problems.collect([&] { call.question.intervals = parse_intervals(*raw.interval); });
    if (raw.eta_inf && *raw.eta_inf == "fit") {
        call.question.fit_eta_inf = true;
    } else if (raw.eta_inf) {
        problems.collect([&] {
            call.question.eta_inf = parse_quantity(*raw.eta_inf, Dimension::viscosity, "--eta-inf");
            if (call.question.eta_inf < 0.0) {
                throw UsageError("--eta-inf: got '" + *raw.eta_inf + "'; it must not be negative",
                                 "--eta-inf");
            }
        });
    }
    if (raw.name) call.question.name = *raw.name;
    for (const auto& [name, value] :
         {std::pair{"--output", raw.output}, {"--preset", raw.preset}, {"--name", raw.name}}) {
        if (value && value->empty()) problems.add(std::string(name) + ": got an empty name", name);
    }
    if (raw.format) {
        if (*raw.format == "json") {
            call.format = FitFormat::json;
        } else if (*raw.format == "csv") {
            call.format = FitFormat::csv;
        } else if (*raw.format != "table") {
            problems.add("--format: got '" + *raw.format + "'; it takes table, json or csv", "--format");
        }
        if (raw.json && call.format != FitFormat::json) {
            problems.add("--json: cannot be combined with --format " + *raw.format + "; give one of the two",
                         "--json");
        }
    } else if (raw.json) {
        call.format = FitFormat::json;
    }
    check_plot(raw, call, problems);
    check_files(raw, problems);
    return call;
}

void say_notes(const FitAnswer& answer) {
    for (const Warning& warning : answer.warnings) {
        const std::string line = std::string(program_name) + ": " + warning.message + "\n";
        std::cerr << line;
    }
}

/// A preset that the program itself refuses is of no use.
void require_predicted(const FitAnswer& answer) {
    const std::string problem = not_predicted(answer.chosen);
    if (problem.empty()) return;
    throw UsageError("--preset: no prediction takes this ink: " + problem +
                         "; fit another law with --law, or leave --preset out",
                     "--preset");
}

std::string text_of(const FitAnswer& answer, const FitCall& call, const Raw& raw) {
    if (!raw.paths.empty()) return fit_values_text(answer, raw.paths);
    if (call.format == FitFormat::json) return fit_json_text(answer);
    if (call.format == FitFormat::csv) return fit_csv(answer);
    const char* const no_color = std::getenv("NO_COLOR");
    const bool colorless = raw.no_color || (no_color != nullptr && *no_color != '\0');
    const bool terminal = !raw.output && isatty(STDOUT_FILENO) != 0;
    return fit_table(answer, {.color = terminal && !colorless, .quiet = raw.quiet});
}

}  // namespace

int run_fit_command(int argc, const char* const* argv) {
    CLI::App app(description, std::string(program_name) + " fit");
    app.set_help_flag("-h,--help", "this text");
    app.footer(footer);
    app.allow_extras();
    app.get_formatter()->column_width(34);
    Raw raw;
    take_last_of_repeated(app);
    add_options(app, raw);
    Problems problems;
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        WholeFile output("-");
        output.write(app.help());
        output.commit();
        return 0;
    } catch (const CLI::ParseError& e) {
        problems.add(e.what());
    }
    add_repeated_options(app, problems);
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    add_extra_arguments(app.remaining(), names, "bioprint-predict fit --help", problems);
    const FitCall call = check(raw, problems);
    problems.raise();

    WholeFile output(raw.output.value_or("-"));
    std::optional<WholeFile> plot;
    if (call.plot) {
        require_gnuplot("--plot");
        plot.emplace(call.plot->file);
    }
    const FitAnswer answer = answer_fit(call.question);
    if (raw.preset) require_predicted(answer);
    output.write(text_of(answer, call, raw));
    if (plot) plot->write(draw(fit_picture(answer), checked_canvas(*call.plot), terminal_size()));
    if (raw.preset) {
        WholeFile preset(*raw.preset);
        preset.write(fit_preset_text(answer));
        preset.commit();
    }
    output.commit();
    if (plot) plot->commit();
    const bool shown =
        raw.paths.empty() && call.format != FitFormat::csv;  // there the notes are part of the answer
    if (!shown && !raw.quiet) say_notes(answer);
    return 0;
}

}  // namespace bioprint
