#include "io/decoded_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "bioprint/errors.hpp"
#include "io/byte_source.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr std::string_view remedy =
    "; export the flow curve as text or CSV (RheoCompass and TRIOS: Export; a spreadsheet: Save as CSV)";

struct Signature {
    std::string_view bytes;
    std::string_view what;
};
constexpr std::array<Signature, 6> foreign = {{
    {"PK\x03\x04", "a workbook or an archive"},
    {"\xD0\xCF\x11\xE0", "an old workbook or an instrument's own project file"},
    {"%PDF", "a PDF"},
    {"\x89PNG", "a picture"},
    {"\xFF\xD8\xFF", "a picture"},
    {"\x1F\x8B", "a compressed file"},
}};

void append_utf8(std::string& out, std::uint32_t c) {
    const auto tail = [&](unsigned shift) { out += static_cast<char>(0x80U | ((c >> shift) & 0x3FU)); };
    if (c < 0x80) {
        out += static_cast<char>(c);
    } else if (c < 0x800) {
        out += static_cast<char>(0xC0U | (c >> 6U));
        tail(0);
    } else if (c < 0x10000) {
        out += static_cast<char>(0xE0U | (c >> 12U));
        tail(6);
        tail(0);
    } else {
        out += static_cast<char>(0xF0U | (c >> 18U));
        tail(12);
        tail(6);
        tail(0);
    }
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
    std::string out;
    out.reserve(bytes.size() / 2);
    const auto unit = [&](std::size_t i) -> std::uint32_t {
        const auto first = static_cast<unsigned char>(bytes[i]);
        const auto second = static_cast<unsigned char>(bytes[i + 1]);
        return big_endian ? (std::uint32_t{first} << 8U) | second : (std::uint32_t{second} << 8U) | first;
    };
    constexpr std::uint32_t replacement = 0xFFFD;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
        std::uint32_t c = unit(i);
        if (c >= 0xD800 && c < 0xDC00 && i + 3 < bytes.size()) {
            const std::uint32_t low = unit(i + 2);
            if (low >= 0xDC00 && low < 0xE000) {
                c = 0x10000 + ((c - 0xD800) << 10U) + (low - 0xDC00);
                i += 2;
            }
        }
        append_utf8(out, c >= 0xD800 && c < 0xE000 ? replacement : c);
    }
    return out;
}

std::string from_windows_1252(std::string_view bytes) {
    // 0x80 to 0x9F; 0: not assigned.
    static constexpr std::array<std::uint16_t, 32> upper = {
        0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
        0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
        0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};
    std::string out;
    out.reserve(bytes.size());
    for (const char byte : bytes) {
        const auto c = static_cast<unsigned char>(byte);
        const std::uint32_t mapped = c >= 0x80 && c < 0xA0 ? upper.at(c - 0x80U) : c;
        append_utf8(out, mapped == 0 && c != 0 ? 0xFFFD : mapped);
    }
    return out;
}

/// UTF-16 without a mark: of ASCII text every second byte is NUL.
std::optional<bool> unmarked_utf16(std::string_view bytes) {
    const std::string_view head = bytes.substr(0, 400);
    if (head.size() < 4) return {};
    std::array<std::size_t, 2> zeros = {0, 0};
    for (std::size_t i = 0; i < head.size(); ++i) zeros.at(i % 2) += head[i] == '\0' ? 1 : 0;
    if (zeros[1] > head.size() / 4 && zeros[0] <= head.size() / 20) return false;
    if (zeros[0] > head.size() / 4 && zeros[1] <= head.size() / 20) return true;
    return {};
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        if (static_cast<unsigned char>(text[i]) < 0x80) {
            ++i;
            continue;
        }
        const std::size_t length = utf8_length(text.substr(i, 4));
        if (length == 0) return false;
        i += length;
    }
    return true;
}

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 && c != '\n' && c != '\r' && c != '\t' && c != '\f' && c != '\v';
}

}  // namespace

DecodedText decode_text(std::string bytes, const std::string& name) {
    const auto fail = [&](const std::string& what) {
        throw UsageError(name + ": is " + what + std::string(remedy), name);
    };
    for (const Signature& signature : foreign) {
        if (std::string_view(bytes).starts_with(signature.bytes)) fail(std::string(signature.what));
    }
    DecodedText result;
    const std::string_view view(bytes);
    if (view.starts_with("\xFF\xFE") || view.starts_with("\xFE\xFF")) {
        const bool big = view.starts_with("\xFE\xFF");
        result = {from_utf16(view.substr(2), big), big ? "UTF-16BE" : "UTF-16LE"};
    } else if (const std::optional<bool> big = unmarked_utf16(view)) {
        result = {from_utf16(view, *big), *big ? "UTF-16BE" : "UTF-16LE"};
    } else if (view.starts_with("\xEF\xBB\xBF")) {
        result = {bytes.substr(3), "UTF-8"};
    } else if (is_utf8(view)) {
        result = {std::move(bytes), "UTF-8"};
    } else {
        result = {from_windows_1252(view), "Windows-1252"};
    }
    const std::string_view head = std::string_view(result.text).substr(0, 65536);
    const auto controls = std::count_if(head.begin(), head.end(), is_control);
    if (head.find('\0') != std::string_view::npos || controls > static_cast<long>(head.size() / 50)) {
        fail("no text");
    }
    return result;
}

DecodedText read_text_file(const std::string& path) {
    constexpr std::size_t largest = std::size_t{1} << 30U;
    const auto source = open_bytes(path);
    InputBuffer buffer(*source);
    while (buffer.more()) {
        if (buffer.rest().size() > largest) {
            throw UsageError(path + ": is larger than 1 GiB; is this a flow curve?", path);
        }
    }
    const std::string name = path == "-" ? "standard input" : path;
    return decode_text(std::string(buffer.rest()), name);
}

}  // namespace bioprint
