#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/extras.hpp"
#include "io/ladder_answer.hpp"
#include "io/settings.hpp"
#include "io/shard.hpp"
#include "io/sweep.hpp"
#include "io/table.hpp"

/// From questions to written answers: one, or a sweep. Batches are in batch.hpp.
namespace bioprint {

enum class Format { table, json, jsonl, csv };

/// Where answers go, in pieces; throws DataError when it cannot.
using Sink = std::function<void(std::string_view)>;

struct RunResult {
    std::size_t rows = 0;     ///< answered or refused
    std::size_t refused = 0;  ///< of them
    std::size_t read = 0;     ///< rows of the input, empty ones too
    bool interrupted = false;
    Format format = Format::table;                ///< as answered
    std::vector<std::string> failed_checks = {};  ///< a line for each check that does not hold everywhere
    double row_time = 0.0;                        ///< processor time of the rows on this thread [s]
    std::string short_of = {};                    ///< what --tolerance or --budget asked for and is not had
};

struct RunOptions {
    Format format = Format::table;
    std::vector<std::string> paths;  ///< of `--get`: print these values alone
    Extras extras = {};
    TableStyle style = {};
    std::optional<LadderAnswer> ladder = {};  ///< which model answers, and why
    /// What answers a row of a sweep in place of `predict`: a simulation. The rows are written one by one then.
    std::function<Json(const Settings&)> answer = {};
    unsigned jobs = 1;
    std::optional<Shard> shard = {};  ///< answer this piece alone; the head stands in the first
    const std::atomic<bool>* interrupted = nullptr;  ///< set by Ctrl-C; what was finished is kept
    RunResult start =
        {};  ///< where many rows go on: those read are passed over, and their answers stand already
    std::function<void(const RunResult&)> keep = {};  ///< called now and then between two rows
    /// Gets the answer to a single question, with what was asked beyond it, before it is written.
    std::function<void(const Json&)> seen = {};
    /// Gets the answer to a row of a sweep, or its refusal; from any thread, once for each row that is answered.
    std::function<void(std::size_t, const Json&)> row_seen = {};
};

/// Whether the head of the rows is still to be written: neither an earlier part of this run nor another piece has.
bool writes_head(const RunOptions& options, const RunResult& so_far);

/// Answers a question or a sweep. `notice` gets the warnings of a single question asked with `--get`.
RunResult run_sweep(const Sweep& sweep, const RunOptions& options, const Sink& sink, const Sink& notice);

/// The exit status of the error being handled (see man page); call inside a catch block.
int exit_status_of_current();

}  // namespace bioprint
