#include "io/json_lines.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

std::vector<JsonLine> read(std::string_view text, std::size_t piece = 1 << 20) {
    MemoryBytes bytes(text, piece);
    JsonLinesReader reader(bytes);
    std::vector<JsonLine> lines;
    while (reader.next()) lines.push_back(reader.line());
    return lines;
}

}  // namespace

TEST_CASE("json lines: one object a line with its number") {
    const auto lines = read("\xEF\xBB\xBF{\"a\": 1}\n\n  \r\n{\"b\": [1, {\"a\": 2}]}\r\n{\"c\": null}");
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].value["a"] == 1);
    CHECK(lines[1].number == 4);
    CHECK(lines[1].value["b"][1]["a"] == 2);
    CHECK(lines[2].number == 5);
    for (const auto& line : lines) CHECK(line.error.empty());
    CHECK(read("").empty());
    CHECK(read("\n\n").empty());
}

TEST_CASE("json lines: an error belongs to its line and the next is read") {
    const auto lines = read(
        "{\"a\": 1,}\n[1]\n{\"a\": 1, \"a\": 2}\n{\"a\": 1e999}\n{\"a\": NaN}\n{\"x\": "
        "\"\xff\"}\nnull\n{}\n");
    REQUIRE(lines.size() == 8);
    CHECK(lines[0].error == "line 1: not JSON at byte 9");
    CHECK(lines[1].error.starts_with("line 2: not an object"));
    CHECK(lines[2].error == "line 3: the key 'a' comes twice");
    CHECK(lines[3].error == "line 4: a number that no double-precision number can hold");
    CHECK(lines[4].error.starts_with("line 5: not JSON"));
    CHECK(lines[5].error.starts_with("line 6: not JSON"));
    CHECK(lines[6].error.starts_with("line 7: not an object"));
    CHECK(lines[7].error.empty());
    for (std::size_t i = 0; i < 7; ++i) CHECK(lines[i].value.is_null());
}

TEST_CASE("json lines: the same key in different objects is no duplicate") {
    CHECK(read(R"({"a": {"a": 1}, "b": {"a": 1}, "c": [{"a": 1}, {"a": 2}]})").at(0).error.empty());
    CHECK(read(R"({"b": {"a": 1, "c": {}, "a": 1}})").at(0).error == "line 1: the key 'a' comes twice");
}

TEST_CASE("json lines: depth and length are limited") {
    const auto nested = [](int depth) {
        return "{\"a\":" + std::string(static_cast<std::size_t>(depth), '[') +
               std::string(static_cast<std::size_t>(depth), ']') + "}";
    };
    CHECK(read(nested(deepest_json - 1)).at(0).error.empty());
    CHECK(read(nested(deepest_json)).at(0).error == "line 1: more than 64 levels of JSON");
    CHECK(read(nested(100000)).at(0).error == "line 1: more than 64 levels of JSON");

    const std::string padded = "{\"a\": 1" + std::string(JsonLinesReader::largest_line, ' ') + "}";
    for (const std::size_t piece : {1000UL, 1UL << 18U, 1UL << 24U}) {
        const auto lines = read("{}\n" + padded + "\n{\"b\": 2}\n" + padded + padded, piece);
        REQUIRE(lines.size() == 4);
        CHECK(lines[1].error == "line 2: longer than 1 MiB");
        CHECK(lines[2].value["b"] == 2);
        CHECK(lines[2].number == 3);
        CHECK(lines[3].error == "line 4: longer than 1 MiB");
    }
}

TEST_CASE("json: errors name the text") {
    CHECK_THROWS_WITH_AS(parse_json("{", "ink.json"), "ink.json: not JSON at byte 2", UsageError);
    CHECK_THROWS_AS(parse_json("", "ink.json"), UsageError);
    CHECK_THROWS_AS(parse_json("1 2", "ink.json"), UsageError);
    CHECK(parse_json(" [1] ", "ink.json").size() == 1);
}
