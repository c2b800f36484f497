#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace bioprint {

namespace {

constexpr std::size_t longest_quote = 60;

constexpr std::array<std::string_view, 6> spaces = {" ", "\t", "\u00A0", "\u202F", "\u2009", "\r"};

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool continuation(std::string_view text, std::size_t i) {
    return i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
}

void append_escaped(std::string& out, char c) {
    constexpr std::string_view hex = "0123456789abcdef";
    const auto byte = static_cast<unsigned char>(c);
    out += "\\x";
    out += hex[byte >> 4U];
    out += hex[byte & 15U];
}

/// Edits count 4, a letter in the other case 1.
int distance(std::string_view a, std::string_view b) {
    std::vector<int> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = 4 * static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        int diagonal = row[0];
        row[0] = 4 * static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = a[i - 1];
            const char y = b[j - 1];
            const int change = x == y ? 0 : lower(x) == lower(y) ? 1 : 4;
            const int best = std::min({row[j] + 4, row[j - 1] + 4, diagonal + change});
            diagonal = row[j];
            row[j] = best;
        }
    }
    return row[b.size()];
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto first = static_cast<unsigned char>(text[0]);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                               : first >= 0xE0 && first <= 0xEF ? 3
                               : first >= 0xF0 && first <= 0xF4 ? 4
                                                                : 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!continuation(text, i)) return 0;
    }
    if (length < 3) return length;
    // Overlong forms, surrogates and code points past U+10FFFF.
    const auto second = static_cast<unsigned char>(text[1]);
    if (first == 0xE0 && second < 0xA0) return 0;
    if (first == 0xED && second > 0x9F) return 0;
    if (first == 0xF0 && second < 0x90) return 0;
    if (first == 0xF4 && second > 0x8F) return 0;
    return length;
}

std::string in_quotes(std::string_view text) {
    std::string out = "'";
    std::size_t i = 0;
    while (i < text.size()) {
        const std::size_t length = utf8_length(text.substr(i));
        if (i + std::max<std::size_t>(length, 1) > longest_quote) break;
        if (length == 0 || (length == 1 && (text[i] < ' ' || text[i] == '\x7F'))) {
            append_escaped(out, text[i]);
            ++i;
        } else {
            out += text.substr(i, length);
            i += length;
        }
    }
    return out + (i < text.size() ? "...'" : "'");
}

std::size_t leading_space(std::string_view text) {
    std::size_t i = 0;
    for (bool found = true; found;) {
        found = false;
        for (const auto space : spaces) {
            if (text.substr(i).starts_with(space)) {
                i += space.size();
                found = true;
            }
        }
    }
    return i;
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(leading_space(text));
    for (bool found = true; found;) {
        found = false;
        for (const auto space : spaces) {
            if (text.ends_with(space)) {
                text.remove_suffix(space.size());
                found = true;
            }
        }
    }
    return text;
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
    if (word.empty() || word.size() > longest_quote) return {};
    const int allowed = std::max(4, 4 * static_cast<int>(word.size()) / 3);
    std::string_view best;
    int best_distance = allowed + 1;
    for (const auto candidate : candidates) {
        const int d = distance(word, candidate);
        if (d < best_distance) {
            best_distance = d;
            best = candidate;
        }
    }
    return best;
}

std::string lower_case(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

}  // namespace bioprint
