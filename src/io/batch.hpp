#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/run.hpp"

/// Many questions from a file, a row each: CSV or JSON Lines. Rows are read, answered by several threads and
/// written in order, a chunk at a time, so memory does not grow with the file.
namespace bioprint {

struct BatchInput {
    std::string file;   ///< "-" for standard input
    Settings defaults;  ///< what a row leaves out
};

/// @param format  as asked for; by default a batch is answered in kind
/// @param notice  remarks for standard error: columns that were not understood, rows that could not be
/// answered
/// @throws DataError   the file cannot be read
/// @throws UsageError  no header, no column that is understood, or a file that is neither CSV nor JSON Lines
RunResult run_batch(const BatchInput& input, std::optional<Format> format, const RunOptions& options,
                    const Sink& sink, const Sink& notice);

/// Whether a batch is JSON Lines; what is not is taken as CSV.
/// @throws DataError  the file cannot be read
bool holds_json_lines(const std::string& file);

/// The records of a batch, by which it is shared out; an empty line of a CSV is one, but no row.
struct RecordCount {
    std::size_t records = 0;
    std::vector<std::size_t> empty = {};  ///< in order

    [[nodiscard]] std::size_t rows(const RowRange& range) const;
};
/// @throws DataError, UsageError  as run_batch()
RecordCount count_records(const std::string& file);

}  // namespace bioprint
