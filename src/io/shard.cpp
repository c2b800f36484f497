#include "io/shard.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "bioprint/errors.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

/// A whole number that fills all of `text`; 0 when it does not.
std::size_t whole_number(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

Shard parse_shard(std::string_view text, std::string_view option) {
    const std::size_t slash = std::min(text.find('/'), text.size());
    const std::size_t piece = whole_number(text.substr(0, slash));
    const std::size_t pieces = slash < text.size() ? whole_number(text.substr(slash + 1)) : 0;
    if (piece == 0 || pieces == 0 || piece > pieces) {
        throw UsageError(std::string(option) + ": got " + in_quotes(text) +
                             "; it takes a piece and their number, from 1/N to N/N, such as 2/8",
                         std::string(option));
    }
    return {.piece = piece, .pieces = pieces};
}

RowRange rows_of(const Shard& shard, std::size_t rows) {
    const std::size_t each = rows / shard.pieces;
    const std::size_t longer = rows % shard.pieces;
    const auto start = [&](std::size_t piece) { return each * piece + std::min(piece, longer); };
    return {.begin = start(shard.piece - 1), .end = start(shard.piece)};
}

bool can_be_read_twice(const std::string& file) {
    std::error_code error;
    return file != "-" && std::filesystem::is_regular_file(file, error);
}

void require_countable(const std::string& file) {
    std::error_code error;
    if (file != "-" && !std::filesystem::exists(file, error)) return;  // opening it says why
    if (!can_be_read_twice(file)) {
        throw UsageError(
            "--shard: the batch is read twice, once to count its rows; give a file, not a pipe or a stream",
            "--shard");
    }
}

}  // namespace bioprint
