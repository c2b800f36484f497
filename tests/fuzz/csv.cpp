// Any bytes as a CSV: every byte is handed back, in the same records however the bytes arrive.

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "bioprint/errors.hpp"
#include "io/csv.hpp"

using namespace bioprint;

namespace {

void require(bool holds) {
    if (!holds) std::abort();
}

/// The bytes handed back; empty for a file that is refused.
std::string hand_back(std::string_view text, std::size_t piece) {
    MemoryBytes bytes(text, piece);
    try {
        CsvReader reader(bytes, "x");
        CsvWriter writer(reader.dialect());
        for (const auto& field : reader.raw_header()) writer.add_raw(field);
        writer.end_row(reader.header_line_end());
        while (reader.next()) {
            const auto& record = reader.record();
            require(record.fields.size() == record.raw_fields.size());
            for (std::size_t i = 0; i < record.fields.size(); ++i) {
                require(record.fields[i].size() <= record.raw_fields[i].size());
            }
            if (!record.blank) {
                for (const auto& field : record.raw_fields) writer.add_raw(field);
            }
            writer.end_row(record.line_end);
        }
        return reader.preamble() + writer.text();
    } catch (const UsageError&) {
        return {};
    }
}

/// A field that is written and read again is the same text.
void write_and_read(std::string_view text) {
    if (text.find('\0') != std::string_view::npos) return;
    CsvWriter writer{CsvDialect{}};
    writer.add_text("a");
    writer.add_text("b");
    writer.end_row();
    writer.add_text(text);
    writer.add_number(0.5);
    writer.end_row();
    MemoryBytes bytes(writer.text());
    CsvReader reader(bytes, "x");
    require(reader.next() && reader.record().fault.empty());
    auto field = reader.record().fields.at(0);
    require(reader.record().fields.at(1) == "0.5");
    if (field.size() > text.size()) field.remove_prefix(1);  // the ' that protects
    require(field == text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    const auto whole = hand_back(text, text.size() + 1);
    require(whole.empty() || whole == text);
    const auto pieces = hand_back(text, 1U + data[0] % 16U);
    require(pieces.empty() || pieces == text);
    write_and_read(text);
    return 0;
}
