#pragma once

#include <string_view>

#include "io/csv.hpp"

/// What the first bytes of a CSV tell about how it is written.
namespace bioprint {

struct CsvHead {
    CsvDialect dialect;
    std::size_t preamble = 0;  ///< bytes of the byte order mark and a `sep=` line
};

/// @param head    the file's first bytes, best with a few records
/// @param at_end  nothing follows them
CsvHead detect_csv(std::string_view head, bool at_end);

/// Why `head` is no text a CSV reader can take, with the remedy; empty when it is.
std::string_view refusal_of_csv(std::string_view head);

}  // namespace bioprint
