// Any bytes as JSON Lines: every line is an object or an error, and what was read can be written and read
// again.

#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "io/json_lines.hpp"

using namespace bioprint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    MemoryBytes bytes(text, 1U + data[0]);
    JsonLinesReader reader(bytes);
    std::size_t last = 0;
    while (reader.next()) {
        const auto& line = reader.line();
        if (line.number <= last || line.value.is_object() != line.error.empty()) std::abort();
        last = line.number;
        if (line.error.empty() && parse_json(line.value.dump(), "again") != line.value) std::abort();
        // An error goes into an answer, so it must be valid UTF-8: dump throws when it is not.
        if (nlohmann::json(line.error).dump().empty()) std::abort();
    }
    return 0;
}
