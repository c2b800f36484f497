#pragma once

#include "io/design.hpp"
#include "io/run.hpp"

/// `design`: the value found, how each limit stands at it, and the whole prediction there.
namespace bioprint {

/// Answers as table, json or jsonl, or the values of `--get`. Where no value keeps the limits, the answer is at
/// the one that comes closest, and `failed_checks` has a line for each limit it breaks.
/// @throws UsageError    also for csv
/// @throws NoSteadyFlow  nowhere in the range
RunResult answer_design(const DesignQuestion& question, const Settings& base, const RunOptions& options,
                        const Sink& sink, const Sink& notice);

}  // namespace bioprint
