#include "io/html.hpp"

#include <algorithm>

#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

std::string_view entity(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return {};
    }
}

bool is_control(std::string_view character) {
    const auto byte = static_cast<unsigned char>(character.front());
    if (character.size() == 1) return (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7F;
    // U+0080 to U+009F
    return byte == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
}

}  // namespace

std::string html_text(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
        const std::string_view character = text.substr(0, length);
        if (utf8_length(text) == 0 || is_control(character)) {
            out += replacement;
        } else if (const std::string_view name = entity(text.front()); !name.empty()) {
            out += name;
        } else {
            out += character;
        }
        text.remove_prefix(length);
    }
    return out;
}

std::string html_table(const std::vector<std::string>& head,
                       const std::vector<std::vector<std::string>>& rows, std::string_view kind) {
    std::string out = kind.empty() ? "<table>\n" : "<table class=\"" + html_text(kind) + "\">\n";
    if (!head.empty()) {
        out += "<thead><tr>";
        for (const std::string& cell : head) out += "<th scope=\"col\">" + html_text(cell) + "</th>";
        out += "</tr></thead>\n";
    }
    out += "<tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        out += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            out += i == 0 ? "<th scope=\"row\">" + html_text(row[i]) + "</th>"
                          : "<td>" + html_text(row[i]) + "</td>";
        }
        out += "</tr>\n";
    }
    return out + "</tbody>\n</table>\n";
}

}  // namespace bioprint
