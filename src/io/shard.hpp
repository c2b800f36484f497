#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// One of several pieces of a batch or sweep. Pieces are runs of neighbouring rows, so that joining them in
/// order gives the whole, byte for byte.
namespace bioprint {

struct Shard {
    std::size_t piece;  ///< 1 to pieces
    std::size_t pieces;
};

/// @throws UsageError  not of the form K/N with 1 ≤ K ≤ N
Shard parse_shard(std::string_view text, std::string_view option = "--shard");

/// Rows from `begin` up to, without, `end`.
struct RowRange {
    std::size_t begin;
    std::size_t end;
};

/// The rows of a piece; the first pieces get one more where they cannot all be alike.
RowRange rows_of(const Shard& shard, std::size_t rows);

/// True of a file, false of a pipe or a stream.
bool can_be_read_twice(const std::string& file);

/// Refuses a batch that cannot be read twice, once to count its rows.
/// @throws UsageError
void require_countable(const std::string& file);

}  // namespace bioprint
