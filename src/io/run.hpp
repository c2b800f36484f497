#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/settings.hpp"
#include "io/sweep.hpp"
#include "io/table.hpp"

/// From questions to written answers: one, a sweep, or a batch streamed from a file.
namespace bioprint {

enum class Format { table, json, jsonl, csv };

/// Where answers go, in pieces; throws DataError when it cannot.
using Sink = std::function<void(std::string_view)>;

struct RunOptions {
    Format format = Format::table;
    std::vector<std::string> paths;  ///< of `--get`: print these values alone
    TableStyle style;
    unsigned jobs = 1;
    const std::atomic<bool>* interrupted = nullptr;  ///< set by Ctrl-C; what was finished is kept
};

struct RunResult {
    std::size_t rows = 0;
    std::size_t refused = 0;
    std::optional<int> only_status;  ///< exit status when a single question was refused
    bool interrupted = false;
};

/// Answers a question or a sweep.
RunResult run_sweep(const Sweep& sweep, const RunOptions& options, const Sink& sink);

/// Answers the rows of a CSV or JSON Lines file, `-` for standard input; `defaults` fill what a row leaves out.
/// `notice` gets remarks for standard error (columns that were not understood).
/// @throws DataError   the file cannot be read
/// @throws UsageError  it has no header, or no column that is understood
RunResult run_batch(const std::string& file, const Settings& defaults, std::optional<Format> format,
                    const RunOptions& options, const Sink& sink, const Sink& notice);

/// The exit status of the error being handled (see man page); call inside a catch block.
int exit_status_of_current();

}  // namespace bioprint
