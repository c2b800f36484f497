#include "io/run.hpp"

#include <cmath>

#include "bioprint/errors.hpp"
#include "io/answer_checks.hpp"
#include "io/answer_object.hpp"
#include "io/answer_path.hpp"
#include "io/csv_columns.hpp"
#include "io/processor_time.hpp"
#include "io/row_answer.hpp"
#include "numerics/parallel.hpp"

namespace bioprint {
namespace {

std::string profile_csv(const RadialProfile& profile) {
    CsvWriter writer(fresh_dialect());
    for (const char* name :
         {"r [m]", "velocity [m/s]", "shear_rate [1/s]", "viscosity [Pa.s]", "stress [Pa]"}) {
        writer.add_text(name);
    }
    writer.end_row();
    for (std::size_t i = 0; i < profile.r.size(); ++i) {
        for (const auto* column :
             {&profile.r, &profile.velocity, &profile.shear_rate, &profile.viscosity, &profile.stress}) {
            if (std::isfinite((*column)[i])) {
                writer.add_number((*column)[i]);
            } else {
                writer.add_empty();
            }
        }
        writer.end_row();
    }
    return writer.text();
}

Json answer_of(const Prediction& prediction, const RunOptions& options) {
    Json answer = answer_object(prediction);
    if (options.ladder) answer["choice"] = ladder_object(*options.ladder);
    return answer;
}

/// One question, whose refusal is the call's refusal.
void answer_one(const Settings& row, const RunOptions& options, const Sink& sink, const Sink& notice,
                CheckTally& tally, RunResult& result) {
    Prediction prediction = predict(row.make_case(), options.jobs);
    if (const auto missed = options.ladder ? shortfall(*options.ladder) : std::nullopt) {
        prediction.warnings.push_back(*missed);
        result.short_of = missed->message;
    }
    const bool table_alone = options.format == Format::table && options.paths.empty() &&
                             options.extras.empty() && !options.ladder && !options.seen;
    if (table_alone) return sink(answer_table(prediction, options.style));
    Json answer = answer_of(prediction, options);
    const ExtraResults results = add_extras(answer, row, options.extras, options.jobs, true);
    tally.add(results.checks);
    if (options.seen) options.seen(answer);
    if (!options.paths.empty()) {
        for (const std::string& path : options.paths) {
            sink(value_text(value_meant(answer, path)) + "\n");
        }
        for (const Json& warning : answer["warnings"]) {
            const auto& message = warning["message"].get_ref<const std::string&>();
            if (message != result.short_of) notice(message);  // the status says that one
        }
        return;
    }
    switch (options.format) {
        case Format::table:
            return sink(answer_table(prediction, options.style) +
                        extras_sections(answer, options.extras, results, options.style) +
                        (options.ladder ? ladder_section(*options.ladder, options.style) : ""));
        case Format::json:
            return sink(json_text(answer, 2) + "\n");
        case Format::jsonl:
            return sink(json_text(answer) + "\n");
        case Format::csv:
            break;
    }
    if (prediction.profile) {
        notice("--profile: as CSV or a workbook the answer is the profile alone; --format json has both");
        return sink(profile_csv(*prediction.profile));
    }
    const RowWriter writer(options, shape_of(row));
    sink(writer.head() + writer.csv_row(answer));
}

struct SweepRow {
    Settings settings;
    std::optional<Prediction> prediction;
    std::string error;
    ExtraResults extras;
};

void write_table(const Sweep& sweep, const RunOptions& options, const Sink& sink, RunResult& result,
                 CheckTally& tally) {
    constexpr std::size_t most_rows = 10000;  // a table is held whole to align it
    if (sweep.size() > most_rows) {
        throw UsageError("--format: a table holds at most 10000 rows and the sweep has " +
                             std::to_string(sweep.size()) + "; use --format csv or jsonl",
                         "--format");
    }
    SweepTable table(sweep.swept(), !options.extras.checks.empty());
    std::vector<SweepRow> rows(sweep.size());
    for_each_index(rows.size(), options.jobs, [&](std::size_t i) {
        rows[i].settings = sweep.row(i);
        try {
            rows[i].prediction = predict(rows[i].settings.make_case());
        } catch (const Error& e) {
            rows[i].error = e.what();
            rows[i].extras = no_extras(options.extras);
            if (options.row_seen) options.row_seen(i, refusal_object(current_refusal()));
            return;
        }
        if (options.extras.empty() && !options.row_seen) return;
        Json answer = answer_object(*rows[i].prediction);
        rows[i].extras = add_extras(answer, rows[i].settings, options.extras, 1, false);
        if (options.row_seen) options.row_seen(i, answer);
    });
    for (const SweepRow& row : rows) {
        tally.add(row.extras.checks);
        if (row.prediction) {
            table.add(row.settings, *row.prediction, verdict(row.extras.checks));
        } else {
            table.add_refusal(row.settings, row.error);
            ++result.refused;
        }
    }
    result.rows = rows.size();
    sink(table.text(options.style));
}

}  // namespace

bool writes_head(const RunOptions& options, const RunResult& so_far) {
    return so_far.read == 0 && (!options.shard || options.shard->piece == 1);
}

RunResult run_sweep(const Sweep& sweep, const RunOptions& options, const Sink& sink, const Sink& notice) {
    RunResult result;
    CheckTally tally(options.extras.checks);
    if (sweep.swept().empty()) {
        answer_one(sweep.fixed(), options, sink, notice, tally, result);
        result.rows = 1;
        result.failed_checks = tally.lines();
        return result;
    }
    const bool has_lists =
        options.format == Format::json || options.format == Format::jsonl || !options.paths.empty();
    if (sweep.fixed().has(Key::profile) && !has_lists) {
        throw UsageError("--profile: a sweep carries profiles in json and jsonl only; choose one of them",
                         "--profile");
    }
    if (options.extras.uncertainty.wanted && options.format == Format::table && options.paths.empty()) {
        throw UsageError(
            "--uncertainty: a sweep shows spreads in csv, json and jsonl; choose one of them, or --get",
            "--uncertainty");
    }
    if (options.format == Format::table && options.paths.empty()) {
        write_table(sweep, options, sink, result, tally);
        result.failed_checks = tally.lines();
        return result;
    }

    const RowWriter writer(options, shape_of(sweep.fixed()));
    PathTally paths(options.paths);
    result = options.start;
    result.format = options.format;
    if (writes_head(options, result)) sink(writer.head());
    const RowRange rows = rows_of(options.shard.value_or(Shard{.piece = 1, .pieces = 1}), sweep.size());
    const std::size_t chunk = options.answer ? options.jobs : chunk_rows;
    for (std::size_t begin = rows.begin + result.read; begin < rows.end; begin += chunk) {
        const std::size_t count = std::min(chunk, rows.end - begin);
        std::vector<RowText> texts(count);
        const double rows_begin = processor_time();
        for_each_index(count, options.jobs, [&](std::size_t i) {
            RowAnswer answer =
                answer_row([&] { return sweep.row(begin + i); }, options.extras, options.answer);
            if (options.row_seen) options.row_seen(begin + i, answer.object);
            if (answer.refused) add_question(answer.object, sweep.swept_values(begin + i));
            texts[i] = writer.written(answer);
        });
        result.row_time += processor_time() - rows_begin;
        // What a simulation had when it was interrupted is no answer.
        if (options.answer && options.interrupted && *options.interrupted) {
            result.interrupted = true;
            if (options.keep) options.keep(result);
            break;
        }
        for (std::size_t i = 0; i < count; ++i) {
            sink(writer.placed(texts[i].text, begin + i));
            result.refused += texts[i].refused ? 1 : 0;
            tally.add(texts[i].extras.checks);
            paths.add(texts[i].absent);
        }
        result.rows += count;
        result.read += count;
        result.interrupted = options.interrupted && *options.interrupted;
        if (options.keep) options.keep(result);
        if (result.interrupted) break;
    }
    if (!(options.keep && result.interrupted)) sink(writer.tail());
    paths.say(notice);
    result.failed_checks = tally.lines();
    return result;
}

int exit_status_of_current() {
    try {
        throw;
    } catch (const UsageError&) {
        return 2;
    } catch (const NoSteadyFlow&) {
        return 3;
    } catch (const DataError&) {
        return 4;
    } catch (const NotConverged&) {
        return 5;
    } catch (...) {
        return 1;
    }
}

}  // namespace bioprint
