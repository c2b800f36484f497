#include "io/dry_run.hpp"

#include <algorithm>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/batch.hpp"
#include "io/processor_time.hpp"
#include "io/row_answer.hpp"

namespace bioprint {
namespace {

constexpr double program_start = 3.5e-3;    ///< [s]; tools/bench command
constexpr double prediction_memory = 10e6;  ///< [B]; does not grow with the rows
constexpr std::size_t timed_places = 4;     ///< of a batch or sweep, where rows are timed
constexpr std::size_t rows_a_place = 3;
constexpr std::string_view schema = "bioprint-predict/plan/1";

std::string duration(double time) {
    return lab_text(time, Dimension::time, 2);
}

std::string megabytes(double bytes) {
    return format_lab(bytes / 1e6, Dimension::dimensionless, 2).number + " MB";
}

std::string_view model_of(const PlannedWork& work) {
    const Settings& settings = work.sweep.fixed();
    return settings.has(Key::model) && settings.at(Key::model).text == "steady" ? "steady" : "ellipsoid";
}

/// Rows answered for their time alone.
struct Sample {
    std::size_t rows = 0;
    double time = 0.0;  ///< of the processor [s]
};

void add_piece(const PlannedWork& work, const Shard& piece, Sample& sample) {
    RunOptions options = work.options;
    options.jobs = 1;
    options.shard = piece;
    options.ladder.reset();
    if (options.format == Format::table || options.format == Format::json) options.format = Format::jsonl;
    const auto nothing = [](std::string_view) {};
    const RunResult result = work.batch ? run_batch({.file = *work.batch, .defaults = work.sweep.fixed()},
                                                    std::nullopt, options, nothing, nothing)
                                        : run_sweep(work.sweep, options, nothing, nothing);
    sample.time += result.row_time;
    sample.rows += result.rows;
}

/// Some rows from a few places of the share, or all where they are few.
Sample timed_rows(const PlannedWork& work, const RowRange& share, std::size_t rows) {
    Sample sample;
    const std::size_t pieces = std::max<std::size_t>(1, rows / rows_a_place);
    const std::size_t first = share.begin * pieces / std::max<std::size_t>(1, rows);
    const std::size_t last = (share.end - 1) * pieces / std::max<std::size_t>(1, rows);
    const std::size_t places = std::min(timed_places, last - first + 1);
    for (std::size_t i = 0; i < places; ++i) {
        const std::size_t piece = first + (last - first) * i / std::max<std::size_t>(1, places - 1);
        add_piece(work, {.piece = std::min(piece, pieces - 1) + 1, .pieces = pieces}, sample);
    }
    return sample;
}

struct RowPlan {
    std::optional<std::size_t> rows;  ///< none: standard input is not read
    std::size_t all = 0;              ///< of every piece
    std::size_t records = 0;          ///< rows, and empty lines of a CSV
    std::size_t timed = 0;
    std::optional<double> time;  ///< [s]
};

/// One question: predicted once, which is all that it takes.
RowPlan plan_question(const PlannedWork& work) {
    const double begin = processor_time();
    (void)predict(work.sweep.row(0).make_case());
    return {.rows = 1, .all = 1, .records = 1, .timed = 1, .time = program_start + processor_time() - begin};
}

RowPlan plan_rows(const PlannedWork& work) {
    if (!work.batch && work.sweep.swept().empty()) return plan_question(work);
    if (work.batch == "-") return {.rows = {}, .time = {}};
    if (work.options.shard && work.batch) require_countable(*work.batch);
    const double begin = processor_time();
    const RecordCount count =
        work.batch ? count_records(*work.batch) : RecordCount{.records = work.sweep.size()};
    const double reading = processor_time() - begin;  // as long as the call will read, on one thread
    const RowRange share =
        rows_of(work.options.shard.value_or(Shard{.piece = 1, .pieces = 1}), count.records);
    RowPlan plan{.rows = count.rows(share),
                 .all = count.rows({.begin = 0, .end = count.records}),
                 .records = share.end - share.begin,
                 .time = {}};
    plan.time = program_start + reading;
    if (*plan.rows == 0) return plan;
    const Sample sample = timed_rows(work, share, count.records);
    plan.timed = sample.rows;
    if (sample.rows > 0) {
        const auto threads = static_cast<double>(
            std::min<std::size_t>(work.options.jobs, std::max<std::size_t>(1, *plan.rows)));
        *plan.time +=
            sample.time / static_cast<double>(sample.rows) * static_cast<double>(*plan.rows) / threads;
    }
    return plan;
}

std::string rows_text(const PlannedWork& work, const RowPlan& plan) {
    const unsigned jobs = work.options.jobs;
    std::string text = "rows     " + (plan.rows ? std::to_string(*plan.rows)
                                                : std::string("not known: standard input is not read"));
    if (work.options.shard)
        text += " of " + std::to_string(plan.all) + ", piece " + std::to_string(work.options.shard->piece) +
                " of " + std::to_string(work.options.shard->pieces);
    text += "\nmodel    " + std::string(model_of(work)) +
            (work.sweep.fixed().has(Key::population) ? ", population" : "") + "\ntime     " +
            (plan.time ? duration(*plan.time) : std::string("not known"));
    if (plan.time && plan.all > 1)
        text += " with " + std::to_string(jobs) + (jobs == 1 ? " thread" : " threads") + ", by " +
                std::to_string(plan.timed) + (plan.timed == 1 ? " row" : " rows") + " that were timed";
    return text + "\nmemory   " + megabytes(prediction_memory) + "\n";
}

Json rows_object(const PlannedWork& work, const RowPlan& plan) {
    return {{"schema", schema},
            {"rows", plan.rows ? Json(*plan.rows) : Json(nullptr)},
            {"records", plan.rows ? Json(plan.records) : Json(nullptr)},
            {"model", model_of(work)},
            {"time", plan.time ? Json(*plan.time) : Json(nullptr)},
            {"threads", work.options.jobs},
            {"memory", prediction_memory}};
}

struct SimulationPlan {
    LadderAnswer ladder;
    double resolution;
    SimulationWork work;
    const RungRecord* record;  ///< null: nothing like it was measured
    bool refined;              ///< finer runs may follow
};

SimulationPlan plan_simulation(const PlannedWork& work) {
    if (work.format == Format::csv)
        throw UsageError("--format: a simulation is answered as table, json or jsonl", "--format");
    const Prediction prediction = predict(work.sweep.fixed().make_case());
    SimulationPlan plan{.ladder = {},
                        .resolution = resolution_of(*work.simulation),
                        .work = work_of(prediction, *work.simulation),
                        .record = nullptr,
                        .refined = false};
    plan.refined = work.simulation->tolerance && why_not_finer(prediction, *work.simulation).empty();
    plan.ladder = climb(prediction, {}, &*work.simulation);
    const Rung rung = rung_of(plan.resolution);
    if (plan.ladder.timed && resolution_of(rung) == plan.resolution)
        plan.record = measured(plan.ladder.request.kind, rung, plan.ladder.request.load);
    if (plan.record != nullptr) plan.work.most = std::min(plan.work.most, plan.record->longest);
    return plan;
}

std::string simulation_text(const PlannedWork& work, const SimulationPlan& plan) {
    std::string text =
        "rows     1\nmodel    simulation of " + std::string(name_of(plan.ladder.request.kind)) + ", " +
        format_lab(plan.resolution, Dimension::dimensionless, 3).number + " nodes a cell radius\ntime     ";
    if (plan.record != nullptr && plan.record->time < plan.work.most) {
        text +=
            duration(plan.record->time) + " as a rule, at most " + duration(plan.work.most) + " of one core";
    } else {
        text += duration(plan.work.least) + " to " + duration(plan.work.most) +
                " of one core by its lattice and steps" +
                (plan.ladder.timed ? "" : "; outside what was measured");
    }
    if (plan.record != nullptr && plan.record->unjudged == 0)
        text += "\nerror    " + percent_text(plan.record->error) + " at most on questions like this one";
    if (plan.refined)
        text += "\nthen     finer runs while its own numerical error is above " +
                percent_text(work.simulation->tolerance.value_or(0.0));
    return text + "\nmemory   " + megabytes(plan.work.memory) + "\n";
}

Json simulation_object(const SimulationPlan& plan) {
    return {{"schema", schema},
            {"rows", 1},
            {"model", "simulation"},
            {"question", name_of(plan.ladder.request.kind)},
            {"nodes_per_cell_radius", plan.resolution},
            {"time", plan.record != nullptr ? Json(plan.record->time) : Json(nullptr)},
            {"time_least", plan.work.least},
            {"time_most", plan.work.most},
            {"measured", plan.ladder.timed},
            {"threads", 1},
            {"memory", plan.work.memory}};
}

/// A sweep of simulations.
struct SimulationsPlan {
    std::size_t rows = 0;
    std::size_t refused = 0;
    double least = 0.0;   ///< of all, on one core [s]
    double most = 0.0;    ///< [s]
    double memory = 0.0;  ///< of as many of the largest as run at once [B]
    unsigned threads = 1;
};

SimulationsPlan plan_simulations(const PlannedWork& work) {
    const RowRange share =
        rows_of(work.options.shard.value_or(Shard{.piece = 1, .pieces = 1}), work.sweep.size());
    SimulationsPlan plan{.rows = share.end - share.begin};
    plan.threads =
        static_cast<unsigned>(std::clamp<std::size_t>(plan.rows, 1, std::max(1U, work.options.jobs)));
    for (std::size_t i = share.begin; i < share.end; ++i) {
        try {
            const SimulationWork one = work_of(predict(work.sweep.row(i).make_case()), *work.simulation);
            plan.least += one.least;
            plan.most += one.most;
            plan.memory = std::max(plan.memory, one.memory);
        } catch (const Error&) {
            ++plan.refused;
        }
    }
    plan.memory *= plan.threads;
    return plan;
}

std::string simulations_text(const PlannedWork& work, const SimulationsPlan& plan) {
    std::string text = "rows     " + std::to_string(plan.rows);
    if (work.options.shard)
        text += " of " + std::to_string(work.sweep.size()) + ", piece " +
                std::to_string(work.options.shard->piece) + " of " +
                std::to_string(work.options.shard->pieces);
    if (plan.refused > 0) text += ", " + std::to_string(plan.refused) + " of them refused";
    return text + "\nmodel    simulations, " +
           format_lab(resolution_of(*work.simulation), Dimension::dimensionless, 3).number +
           " nodes a cell radius\ntime     " + duration(plan.least / plan.threads) + " to " +
           duration(plan.most / plan.threads) + " with " + std::to_string(plan.threads) +
           (plan.threads == 1 ? " thread" : " threads") + ", by lattices and steps\nmemory   " +
           megabytes(plan.memory) + "\n";
}

Json simulations_object(const PlannedWork& work, const SimulationsPlan& plan) {
    return {{"schema", schema},
            {"rows", plan.rows},
            {"refused", plan.refused},
            {"model", "simulation"},
            {"nodes_per_cell_radius", resolution_of(*work.simulation)},
            {"time_least", plan.least / plan.threads},
            {"time_most", plan.most / plan.threads},
            {"threads", plan.threads},
            {"memory", plan.memory}};
}

}  // namespace

Plan dry_run(const PlannedWork& work) {
    const bool as_json = work.format == Format::json || work.format == Format::jsonl;
    const std::optional<LadderAnswer>& ladder = work.options.ladder;
    Plan plan;
    Json object;
    if (work.simulation && !work.sweep.swept().empty()) {
        const SimulationsPlan simulations = plan_simulations(work);
        plan.text = simulations_text(work, simulations);
        object = simulations_object(work, simulations);
    } else if (work.simulation) {
        const SimulationPlan simulation = plan_simulation(work);
        plan.text = simulation_text(work, simulation);
        object = simulation_object(simulation);
    } else {
        const RowPlan rows = plan_rows(work);
        plan.text = rows_text(work, rows);
        object = rows_object(work, rows);
    }
    if (ladder) {
        plan.text += ladder_section(*ladder, work.options.style);
        object["choice"] = ladder_object(*ladder);
        // Whether a simulation keeps a tolerance its own error tells, once it is run.
        const auto missed = shortfall(*ladder);
        if (missed && (!work.simulation || missed->code == "budget_not_met")) plan.short_of = missed->message;
    }
    if (as_json) plan.text = json_text(object, work.format == Format::json && !work.batch ? 2 : -1) + "\n";
    return plan;
}

}  // namespace bioprint
