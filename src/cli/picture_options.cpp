#include "cli/picture_options.hpp"

#include "cli/named_files.hpp"
#include "io/batch.hpp"
#include "io/shard.hpp"
#include "io/workbook.hpp"

namespace bioprint {
namespace {

void collect_plot(const RawPictures& raw, Arguments& arguments, Problems& problems) {
    if (!raw.plot) {
        if (raw.plot_kind) problems.add("--plot-kind: says which picture; add --plot FILE", "--plot-kind");
        return;
    }
    arguments.pictures.plot = PlotQuestion{.file = *raw.plot, .kind = raw.plot_kind.value_or("auto")};
    problems.collect([&] { checked_canvas(*arguments.pictures.plot); });
    if (arguments.batch) problems.add("--plot: one question or sweep at a time; leave out --batch", "--plot");
    if (arguments.design) {
        problems.add("--plot: a design is not drawn; ask for the value that it finds", "--plot");
    }
    const bool many = !arguments.sweep.swept().empty();
    if (arguments.simulation && many) {
        problems.add("--plot: draws one simulation at a time; leave out lists", "--plot");
    }
    if (arguments.simulation && raw.plot_kind) {
        problems.add("--plot-kind: a simulation has a picture of its own; leave it out", "--plot-kind");
    }
    const bool shared = raw.plot == "-" && !arguments.output.has_value();
    if (shared && (arguments.format.value_or(Format::table) != Format::table || !arguments.paths.empty())) {
        problems.add(
            "--plot: - would draw between the lines of the answer; name a file, or send the answer to one "
            "with --output",
            "--plot");
    }
}

void collect_report(const RawPictures& raw, Arguments& arguments, Problems& problems) {
    arguments.pictures.report = raw.report;
    if (raw.report && raw.report->empty())
        problems.add("--report: got an empty name; it takes a file", "--report");
    if (raw.report && arguments.batch) {
        problems.add("--report: one question or sweep at a time; leave out --batch", "--report");
    }
    if (raw.report && arguments.simulation && !arguments.sweep.swept().empty()) {
        problems.add("--report: holds one simulation at a time; leave out lists", "--report");
    }
    if (raw.report && arguments.design) {
        problems.add("--report: a design has none; ask for the value that it finds", "--report");
    }
}

/// A workbook is the CSV in another form, and nothing else.
void collect_workbook(const RawPictures& raw, Arguments& arguments, Problems& problems) {
    if (!arguments.output || !names_workbook(*arguments.output)) return;
    const auto refuse = [&](const std::string& option, const std::string& why) {
        problems.add(option + ": " + why, option);
    };
    if (arguments.format.value_or(Format::csv) != Format::csv) {
        refuse("--format", "a workbook holds rows of numbers; leave it out, or name another --output");
    }
    if (!arguments.paths.empty())
        refuse("--get", "a workbook holds every value; leave it out, or name another --output");
    if (arguments.design) refuse("--output", "a design has no workbook; name another, such as one in .json");
    if (arguments.simulation) refuse("--simulate", "has no workbook; name an --output that ends in .json");
    if (raw.shard)
        refuse("--shard", "the pieces of a workbook cannot be joined; name an --output that ends in .csv");
    if (arguments.dry_run) refuse("--dry-run", "has no workbook; name another --output");
    if (arguments.list) refuse("--list", "has no workbook; name another --output");
    arguments.format = Format::csv;
}

/// Pieces are joined as files are: whatever frames the whole, a table or an array, has no pieces.
void collect_shard(const RawPictures& raw, Arguments& arguments, Problems& problems) {
    if (!raw.shard) return;
    problems.collect([&] { arguments.shard = parse_shard(*raw.shard); });
    const auto refuse = [&](const std::string& why) { problems.add("--shard: " + why, "--shard"); };
    if (arguments.long_run) {
        refuse("the rows kept in a directory are whole; leave out --out and --resume");
        return;
    }
    if (!arguments.batch && arguments.sweep.swept().empty()) {
        refuse("a single question has no pieces; add --batch, or a list of values");
        return;
    }
    if (raw.plot || raw.report) refuse("a picture or report shows the whole; leave it out");
    if (!arguments.paths.empty()) return;
    if (arguments.format == Format::json) {
        refuse("the pieces of a JSON array cannot be joined; use --format jsonl");
    } else if (arguments.format.value_or(arguments.batch        ? Format::csv
                                         : arguments.simulation ? Format::jsonl
                                                                : Format::table) == Format::table) {
        refuse("the pieces of a table cannot be joined; use --format csv or jsonl");
    }
}

/// Whether the answer holds all that the batch holds: the rows of a CSV come back with their answers behind them.
bool holds_batch(const RawPictures& raw, const Arguments& arguments) {
    const bool whole = arguments.paths.empty() && !raw.shard && !arguments.dry_run;
    if (!whole || arguments.format.value_or(Format::csv) != Format::csv) return false;
    // Of what is no file nothing can be lost, and a first look would take from a stream.
    return !can_be_read_twice(*arguments.batch) || !holds_json_lines(*arguments.batch);
}

/// A file that is read, or that another option writes, is not to be lost.
void check_files(const RawPictures& raw, const Arguments& arguments, Problems& problems) {
    std::vector<NamedFile> files = {{.option = "--output", .file = arguments.output},
                                    {.option = "--history", .file = arguments.history},
                                    {.option = "--plot", .file = raw.plot},
                                    {.option = "--report", .file = raw.report}};
    require_ending(files.back(), "a report", {".html", ".htm"}, problems);
    for (const auto& [key, text] : arguments.given) {
        const bool file = text.find('/') != std::string::npos || text.ends_with(".json");
        if (key == Key::ink && file) files.push_back({.option = "--ink", .file = text, .written = false});
    }
    if (arguments.batch && arguments.output && !holds_batch(raw, arguments)) {
        files.push_back({.option = "--batch", .file = arguments.batch, .written = false});
    }
    refuse_shared_files(files, problems);
}

}  // namespace

void add_picture_options(CLI::App& app, RawPictures& raw, const std::string& group) {
    app.add_option("--plot", raw.plot, "draw it there: .svg, .png or .pdf; - draws in the terminal")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--plot-kind", raw.plot_kind, "overview, profile, exit, cell or nomogram")
        ->type_name("KIND")
        ->group(group);
    app.add_option("--report", raw.report, "write question, answer and pictures there, as one HTML page")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--shard", raw.shard,
                   "answer piece K of N of a batch or sweep; joined in order they are the whole")
        ->type_name("K/N")
        ->group(group);
}

void collect_pictures(const RawPictures& raw, Arguments& arguments, Problems& problems) {
    check_files(raw, arguments, problems);
    collect_plot(raw, arguments, problems);
    collect_report(raw, arguments, problems);
    collect_shard(raw, arguments, problems);
    collect_workbook(raw, arguments, problems);
}

}  // namespace bioprint
