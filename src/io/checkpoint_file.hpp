#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// What a long run has reached, as a file from which it goes on.
///
/// CBOR: {"format": "bioprint-checkpoint/1", "program": version, "checksum": FNV-1a of content, "content": bytes}; the
/// content is itself CBOR, a map from names to byte strings of little-endian doubles, so that no digit is lost.
namespace bioprint {

using CheckpointParts = std::map<std::string, std::vector<double>>;

/// Written whole or not at all: the one before stays until the new one is complete.
/// @throws DataError  it cannot be written
void write_checkpoint(const std::string& path, const CheckpointParts& parts);

/// @throws DataError  it cannot be read, is cut short, damaged, or of another version of the program
CheckpointParts read_checkpoint(const std::string& path);

/// FNV-1a of 64 bits, for finding damage. `seed` is the checksum of what stands before.
inline constexpr unsigned long long checksum_start = 0xcbf29ce484222325ULL;
unsigned long long checksum(std::string_view bytes, unsigned long long seed = checksum_start);

}  // namespace bioprint
