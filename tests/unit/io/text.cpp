#include "io/text.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace bioprint;

TEST_CASE("text: a quote in a message is printable UTF-8 and short") {
    CHECK(in_quotes("50 µm") == "'50 µm'");
    CHECK(in_quotes("a\nb\x1b[31m") == "'a\\x0ab\\x1b[31m'");
    CHECK(in_quotes("\xff\xc0\x80") == "'\\xff\\xc0\\x80'");
    CHECK(in_quotes(std::string(100, 'x')) == "'" + std::string(60, 'x') + "...'");
    // A cut never splits a character.
    CHECK(in_quotes(std::string(59, 'x') + "µ") == "'" + std::string(59, 'x') + "...'");
}

TEST_CASE("text: UTF-8 sequences are recognised and others are not") {
    CHECK(utf8_length("a") == 1);
    CHECK(utf8_length("µ") == 2);
    CHECK(utf8_length("−") == 3);
    CHECK(utf8_length("\U0001F9EA") == 4);
    for (const auto* bad : {"\xB5", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80",
                            "\xF0\x80\x80\x80", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xE2\x88", "\xC2"}) {
        CHECK(utf8_length(bad) == 0);
    }
    CHECK(utf8_length("") == 0);
}

TEST_CASE("text: trimming removes no-break and thin spaces") {
    CHECK(trimmed("\u00A0\t 5 um\u202F \r") == "5 um");
    CHECK(trimmed(" ").empty());
}

TEST_CASE("text: the nearest word is found by few edits") {
    constexpr std::array<std::string_view, 3> words = {"alginate-2.5", "alginate-3-25C", "hela"};
    CHECK(nearest("alginat-2.5", words) == "alginate-2.5");
    CHECK(nearest("HeLa", words) == "hela");
    CHECK(nearest("collagen", words).empty());
    CHECK(nearest("", words).empty());
}
