#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include "bioprint/errors.hpp"
#include "bioprint/io/answer.hpp"
#include "cli/arguments.hpp"
#include "cli/fit_command.hpp"
#include "cli/ladder_options.hpp"
#include "io/batch.hpp"
#include "io/design_answer.hpp"
#include "io/dry_run.hpp"
#include "io/history.hpp"
#include "io/kept_rows.hpp"
#include "io/pictures.hpp"
#include "io/preset_list.hpp"
#include "io/reference_report.hpp"
#include "io/whole_file.hpp"
#include "io/workbook.hpp"

// parse → validate → run → print

namespace {

using namespace bioprint;

constexpr int status_interrupted = 130;
constexpr int status_some_rows_failed = 6;
constexpr int status_check_failed = 7;
constexpr int status_not_met = 5;

std::atomic<bool> interrupted{false};

/// The first Ctrl-C lets the rows at hand be finished; the second one ends the program.
void on_interrupt(int) {
    if (interrupted.exchange(true)) {
        constexpr std::string_view line = "bioprint-predict: interrupted twice: ended at once\n";
        (void)!write(STDERR_FILENO, line.data(), line.size());
        std::_Exit(status_interrupted);
    }
    // A batch that waits for its next line sees the end of its input.
    const int nothing = open("/dev/null", O_RDONLY);
    if (nothing >= 0) dup2(nothing, STDIN_FILENO);
}

void say(std::string_view text) {
    std::size_t begin = 0;
    while (begin < text.size()) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        // In one piece: standard error and output may be one file, and the answer must not stand inside a line.
        const std::string line =
            std::string(program_name) + ": " + std::string(text.substr(begin, end - begin)) + "\n";
        std::cerr << line;
        begin = end + 1;
    }
}

RunOptions run_options(const Arguments& arguments) {
    const bool terminal = !arguments.output && isatty(STDOUT_FILENO) != 0;
    const char* const no_color = std::getenv("NO_COLOR");
    const bool colorless = arguments.no_color || (no_color != nullptr && *no_color != '\0');
    return {.format = arguments.format.value_or(Format::table),
            .paths = arguments.paths,
            .extras = {.checks = arguments.checks, .uncertainty = arguments.uncertainty},
            .style = {.color = terminal && !colorless, .quiet = arguments.quiet},
            .jobs = arguments.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())),
            .shard = arguments.shard,
            .interrupted = &interrupted};
}

int status_of(const RunResult& result, bool to_file) {
    if (result.interrupted) {
        say("interrupted after " + std::to_string(result.rows) + " rows" +
            (to_file ? "; the output file was not written" : ""));
        return status_interrupted;
    }
    for (const std::string& line : result.failed_checks) say(line);
    if (result.refused > 0) return status_some_rows_failed;
    if (!result.short_of.empty()) {
        say(result.short_of);
        return status_not_met;
    }
    return result.failed_checks.empty() ? 0 : status_check_failed;
}

/// One line on a terminal that tells how far the simulation is, and how long it will still take.
class ProgressLine {
  public:
    explicit ProgressLine(bool shown) : shown_(shown), begin_(std::chrono::steady_clock::now()) {}
    ~ProgressLine() {
        if (shown_) std::cerr << "\r\033[K" << std::flush;
    }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const SimulationProgress& progress) {
        if (!shown_) return;
        const auto now = std::chrono::steady_clock::now();
        if (progress.stage != stage_) {
            stage_ = progress.stage;
            begin_ = now;
        } else if (now - last_ < std::chrono::milliseconds(100)) {
            return;
        }
        last_ = now;
        const std::chrono::duration<double> elapsed = now - begin_;
        std::cerr << "\r\033[K" << program_name << ": " << stage_ << " " << std::lround(100.0 * progress.done)
                  << " %";
        if (progress.done > 0.05) {
            std::cerr << ", " << std::lround(elapsed.count() * (1.0 / progress.done - 1.0)) << " s left";
        }
        std::cerr << std::flush;
    }

  private:
    bool shown_;
    std::string_view stage_;
    std::chrono::steady_clock::time_point begin_;
    std::chrono::steady_clock::time_point last_;
};

RunDirectory directory_of(const Arguments& arguments) {
    const LongRun& run = *arguments.long_run;
    return run.resumed ? RunDirectory::take_up(run.directory)
                       : RunDirectory::begin(run.directory, arguments.typed);
}

std::vector<std::string> run_simulation(const Arguments& arguments, RunOptions options, const Sink& sink,
                                        Pictures& pictures) {
    Json answer;
    options.seen = [&](const Json& written) { answer = written; };
    std::optional<RunDirectory> directory;
    std::optional<SimulationFiles> files;
    if (arguments.long_run) {
        directory.emplace(directory_of(arguments));
        files.emplace(*directory, arguments.long_run->interval);
    }
    ProgressLine line(!arguments.quiet && isatty(STDERR_FILENO) != 0);
    std::mutex lock;  // two resolutions may run at once
    const SimulationOptions simulation{.threads = static_cast<int>(options.jobs),
                                       .progress =
                                           [&](const SimulationProgress& progress) {
                                               const std::lock_guard guard(lock);
                                               line.show(progress);
                                           },
                                       .cancel = &interrupted};
    try {
        return answer_with_simulation(arguments.sweep.fixed(), *arguments.simulation, options, simulation,
                                      sink, files ? &*files : nullptr,
                                      [&](const Prediction& prediction, const Comparison& comparison) {
                                          pictures.draw(prediction, comparison, answer);
                                      });
    } catch (const UsageError&) {
        if (directory) directory->abandon();
        throw;
    } catch (const NoSteadyFlow&) {
        if (directory) directory->abandon();
        throw;
    }
}

/// How an interrupted run goes on.
void say_how_to_resume(const Arguments& arguments) {
    if (!arguments.long_run) return say("with --out DIR a run can be gone on with");
    say("'" + std::string(program_name) + " --resume " + shell_word(arguments.long_run->directory) +
        "' goes on from there");
}

/// Where the answer goes: as text, or as the rows of a workbook.
class Output {
  public:
    explicit Output(const Arguments& arguments) : file_(arguments.output.value_or("-")) {
        if (names_workbook(arguments.output.value_or(""))) workbook_.emplace();
    }
    void write(std::string_view text) { workbook_ ? workbook_->add(text) : file_.write(text); }
    void flush() {
        if (!workbook_) file_.flush();
    }
    void commit() {
        if (workbook_) file_.write(workbook_->bytes());
        file_.commit();
    }

  private:
    WholeFile file_;
    std::optional<Workbook> workbook_;
};

int answer_by_simulation(const Arguments& arguments, const RunOptions& options, Output& output,
                         Pictures& pictures) {
    RunResult result;
    result.rows = 1;
    try {
        result.failed_checks = run_simulation(
            arguments, options, [&](std::string_view text) { output.write(text); }, pictures);
    } catch (const SimulationIncomplete& e) {
        output.commit();  // the prediction, and what the simulation had
        pictures.commit();
        say(e.what());
        if (interrupted) say_how_to_resume(arguments);
        return interrupted ? status_interrupted : exit_status_of_current();
    }
    output.commit();
    pictures.commit();
    return status_of(result, false);
}

/// A batch or a sweep whose answers stay in a directory.
int answer_kept_rows(const Arguments& arguments, RunOptions options, const Sink& notice, Pictures& pictures) {
    if (arguments.output) {
        throw UsageError(
            "--output: the rows are answered in " + arguments.long_run->directory + "; leave out --output",
            "--output");
    }
    if (arguments.batch && (arguments.pictures.plot || arguments.pictures.report)) {
        const std::string option = arguments.pictures.plot ? "--plot" : "--report";
        throw UsageError(option + ": one question or sweep at a time; leave it out, the run is of a batch",
                         option);
    }
    pictures.draw(options);
    RunDirectory directory = directory_of(arguments);
    KeptRows kept(directory, arguments.long_run->interval);
    kept.values = !options.paths.empty();
    RunResult result = kept.start();
    if (!kept.finished()) {
        options.start = kept.start();
        options.keep = [&](const RunResult& so_far) { kept.keep(so_far); };
        const Sink sink = [&](std::string_view text) { kept.write(text); };
        try {
            if (arguments.batch) {
                const BatchInput input{.file = *arguments.batch, .defaults = arguments.sweep.fixed()};
                result = run_batch(input, arguments.format, options, sink, notice);
            } else {
                if (!arguments.simulation) options.format = arguments.format.value_or(Format::csv);
                result = run_sweep(arguments.sweep, options, sink, notice);
            }
        } catch (const UsageError&) {
            directory.abandon();
            throw;
        }
        if (result.interrupted) {
            say("interrupted after " + std::to_string(result.rows) + " rows");
            say_how_to_resume(arguments);
            return status_interrupted;
        }
        kept.finish(result);
    }
    pictures.finish();
    pictures.commit();
    notice(std::to_string(result.rows) + " rows answered in " + kept.answers() +
           (result.refused > 0 ? ", " + std::to_string(result.refused) + " of them refused" : ""));
    return result.refused > 0 ? status_some_rows_failed : 0;
}

int answer_rows(const Arguments& arguments, RunOptions options, const Sink& notice, Output& output,
                Pictures& pictures) {
    const Sink sink = [&](std::string_view text) { output.write(text); };
    if (!arguments.design) pictures.draw(options);
    RunResult result;
    if (arguments.batch) {
        const BatchInput input{.file = *arguments.batch, .defaults = arguments.sweep.fixed()};
        const Sink row_sink = [&](std::string_view text) {
            sink(text);
            output.flush();
        };
        result = run_batch(input, arguments.format, options, row_sink, notice);
    } else if (arguments.design) {
        result = answer_design(*arguments.design, arguments.sweep.fixed(), options, sink, notice);
    } else {
        result = run_sweep(arguments.sweep, options, sink, notice);
        if (arguments.verbose && arguments.sweep.swept().empty())
            say(reference_report(arguments.sweep.fixed()));
    }
    const bool to_file = arguments.output.has_value();
    if (!result.interrupted) pictures.finish();
    if (!(result.interrupted && to_file)) output.commit();
    if (!result.interrupted) pictures.commit();
    return status_of(result, to_file);
}

/// A sweep of simulations: two on two cores rather than one after the other on both.
void simulate_rows(const Arguments& arguments, RunOptions& options) {
    options.format = arguments.format.value_or(Format::jsonl);
    options.answer = [question = *arguments.simulation](const Settings& settings) {
        return simulated_row(settings, question, {.threads = 1, .progress = {}, .cancel = &interrupted});
    };
}

int run(Arguments arguments) {
    Output output(arguments);
    const Sink notice = [&](std::string_view text) {
        if (!arguments.quiet) say(text);
    };
    if (arguments.list) {
        output.write(preset_list(*arguments.list));
        output.commit();
        return 0;
    }
    RunOptions options = run_options(arguments);
    if (arguments.ladder) options.ladder = take_rung(arguments);
    if (arguments.dry_run) {
        const Plan plan = dry_run({.sweep = arguments.sweep,
                                   .batch = arguments.batch,
                                   .simulation = arguments.simulation,
                                   .format = arguments.format,
                                   .options = options});
        output.write(plan.text);
        output.commit();
        if (plan.short_of.empty()) return 0;
        say(plan.short_of);
        return status_not_met;
    }
    if (arguments.history) {
        WholeFile history(*arguments.history);
        history.write(history_csv(arguments.sweep.fixed()));
        history.commit();
    }
    Pictures pictures(arguments.pictures, arguments.sweep, notice);
    const bool many = !arguments.sweep.swept().empty();
    if (arguments.simulation && many) simulate_rows(arguments, options);
    if (arguments.simulation && !many) return answer_by_simulation(arguments, options, output, pictures);
    if (arguments.long_run) return answer_kept_rows(arguments, options, notice, pictures);
    return answer_rows(arguments, options, notice, output, pictures);
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
    std::signal(SIGXFSZ, SIG_IGN);  // a file that would grow too large is a failed write, which is answered
    try {
        if (argc > 1 && std::string_view(argv[1]) == "fit") return run_fit_command(argc - 1, argv + 1);
        const std::optional<Arguments> arguments = parse_arguments(argc, argv);
        return arguments ? run(*arguments) : 0;
    } catch (const Error& e) {
        if (interrupted && exit_status_of_current() == 4) {
            // gnuplot gets the same Ctrl-C, and its end is not what went wrong.
            say("interrupted; no file was written");
            return status_interrupted;
        }
        say(e.what());
        return exit_status_of_current();
    } catch (const std::exception& e) {
        say(std::string("internal error: ") + e.what() + "; please report it with the call that made it");
        return 1;
    }
}
