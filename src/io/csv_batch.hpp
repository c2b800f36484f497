#pragma once

#include "io/batch.hpp"
#include "io/byte_source.hpp"

/// A batch from a CSV. Answered as CSV, each row keeps the user's own bytes and gets our columns behind them.
namespace bioprint {

/// @throws DataError, UsageError  as run_batch()
RecordCount count_csv_records(const std::string& file);

RunResult run_csv_batch(ByteSource& source, const BatchInput& input, const RunOptions& options,
                        const Sink& sink, const Sink& notice);

}  // namespace bioprint
