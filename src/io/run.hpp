#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

struct RunOptions {
    Format format = Format::table;
    std::vector<std::string> paths;  ///< of `--get`: print these values alone
    TableStyle style = {};
    std::optional<LadderAnswer> ladder = {};  ///< which model answers, and why
    unsigned jobs = 1;
    std::optional<Shard> shard = {};  ///< answer this piece alone; the head stands in the first
    const std::atomic<bool>* interrupted = nullptr;  ///< set by Ctrl-C; what was finished is kept
};

struct RunResult {
    std::size_t rows = 0;
    std::size_t refused = 0;
    bool interrupted = false;
};

/// Answers a question or a sweep. `notice` gets the warnings of a single question asked with `--get`.
RunResult run_sweep(const Sweep& sweep, const RunOptions& options, const Sink& sink, const Sink& notice);

/// The exit status of the error being handled (see man page); call inside a catch block.
int exit_status_of_current();

}  // namespace bioprint
