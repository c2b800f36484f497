#include "io/csv.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

#include "bioprint/errors.hpp"

using namespace bioprint;

namespace {

using Fields = std::vector<std::string>;

struct Row {
    std::size_t line;
    Fields fields;
    std::string fault;
    bool blank;
};

struct Table {
    CsvDialect dialect;
    Fields header;
    std::vector<Row> rows;
    std::string bytes;  ///< everything handed back
};

Table read(std::string_view text, std::size_t piece = 1 << 20) {
    MemoryBytes bytes(text, piece);
    CsvReader reader(bytes, "test.csv");
    Table table{
        .dialect = reader.dialect(), .header = reader.header(), .rows = {}, .bytes = reader.preamble()};
    CsvWriter header(reader.dialect());
    for (const auto& field : reader.raw_header()) header.add_raw(field);
    header.end_row(reader.header_line_end());
    table.bytes += header.text();
    while (reader.next()) {
        const auto& record = reader.record();
        table.rows.push_back({.line = record.line,
                              .fields = {record.fields.begin(), record.fields.end()},
                              .fault = record.fault,
                              .blank = record.blank});
        CsvWriter row(reader.dialect());
        for (const auto& field : record.raw_fields) row.add_raw(field);
        row.end_row(record.line_end);
        if (!record.blank) CHECK(row.text() == std::string(record.raw) + std::string(record.line_end));
        table.bytes += record.raw;
        table.bytes += record.line_end;
    }
    return table;
}

std::string refusal(std::string_view text) {
    try {
        read(text);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("csv: separators and line ends and the byte order mark are recognised") {
    const auto comma = read("a,b\n1,2\n");
    CHECK(comma.dialect.separator == ',');
    CHECK(comma.dialect.line_end == "\n");
    CHECK_FALSE(comma.dialect.byte_order_mark);
    CHECK(comma.rows.at(0).fields == Fields{"1", "2"});

    const auto semicolon = read(
        "\xEF\xBB\xBF"
        "a;b\r\n0,5;2\r\n");
    CHECK(semicolon.dialect.separator == ';');
    CHECK(semicolon.dialect.decimal_comma);
    CHECK(semicolon.dialect.line_end == "\r\n");
    CHECK(semicolon.dialect.byte_order_mark);
    CHECK(semicolon.header == Fields{"a", "b"});
    CHECK(semicolon.rows.at(0).fields == Fields{"0,5", "2"});

    CHECK(read("a\tb\n1.5\t2\n").dialect.separator == '\t');
    CHECK_FALSE(read("a;b\n1.5;2\n").dialect.decimal_comma);
    CHECK_FALSE(read("a;b\n0,0.3,0.75;2\n").dialect.decimal_comma);
    CHECK(read("a,b\r1,2\r3,4").rows.size() == 2);
    CHECK(read("a;b, c\n1;2\n").dialect.separator == ';');
    CHECK(read("sep=|\na|b\n1|2\n").rows.at(0).fields == Fields{"1", "2"});
    CHECK(read("sep=|\na|b\n1|2\n").rows.at(0).line == 3);
}

TEST_CASE("csv: quoted fields hold separators and newlines and quotes") {
    const auto table = read("a,b,c\r\n\"x,y\",\"two\r\nlines\",\"say \"\"no\"\"\"\r\n1,,\"\"\r\n");
    REQUIRE(table.rows.size() == 2);
    CHECK(table.rows[0].fields == Fields{"x,y", "two\r\nlines", "say \"no\""});
    CHECK(table.rows[0].line == 2);
    CHECK(table.rows[1].line == 4);
    CHECK(table.rows[1].fields == Fields{"1", "", ""});
    // A quote inside an unquoted field is a byte like any other: 5" is five inches.
    CHECK(read("a,b\n5\",2\n").rows.at(0).fields == Fields{"5\"", "2"});
}

TEST_CASE("csv: the last line may lack its end") {
    CHECK(read("a,b\n1,2").rows.at(0).fields == Fields{"1", "2"});
    CHECK(read("a,b\r\n1,2\r").rows.at(0).fields == Fields{"1", "2"});
    CHECK(read("a,b\n1,").rows.at(0).fields == Fields{"1", ""});
    CHECK(read("a,b").rows.empty());
    CHECK(read("a,b\n1,\"2\"").rows.at(0).fields == Fields{"1", "2"});
}

TEST_CASE("csv: a bad record is reported with its line and the next is read") {
    const auto ragged = read("a,b\n1\n1,2,3\n1,2\n");
    CHECK(ragged.rows.at(0).fault == "has 1 field, the header has 2");
    CHECK(ragged.rows.at(1).fault == "has 3 fields, the header has 2");
    CHECK(ragged.rows.at(1).line == 3);
    CHECK(ragged.rows.at(2).fault.empty());

    const auto open = read("a,b\n\"1,2\n3,4\n");
    CHECK(open.rows.at(0).fault == "has a quote that is not closed");
    CHECK(open.rows.at(1).fields == Fields{"3", "4"});
    CHECK(open.rows.at(1).line == 3);

    CHECK(read("a,b\n\"1\"x,2\n3,4\n").rows.at(0).fault == "has text behind a closing quote");
    CHECK(read("a,b\n\"1\"x\",2\n3,4\n").rows.at(0).fault == "has text behind a closing quote");
    CHECK(read("a,b\n1,\"2\" \n3,4\n").rows.at(0).fault == "has text behind a closing quote");
    CHECK(read("a,b\n" + std::string(100, ' ') + std::string("\0,2\n3,4\n", 8)).rows.at(0).fault ==
          "holds a NUL byte");
    const auto blank = read("\n\na,b\n\n1,2\n\n");
    REQUIRE(blank.rows.size() == 3);
    CHECK(blank.rows[0].blank);
    CHECK(blank.rows[1].line == 5);
    CHECK(blank.rows[1].fault.empty());
}

TEST_CASE("csv: what is no CSV text is refused with a remedy") {
    CHECK(refusal("") == "test.csv: is empty; a batch starts with a line of column names");
    CHECK(refusal("\n\n") == "test.csv: is empty; a batch starts with a line of column names");
    CHECK(refusal(std::string_view("\xFF\xFE"
                                   "a\0",
                                   4)) == "test.csv: is UTF-16 text; save it as CSV UTF-8");
    CHECK(refusal(std::string_view("a\0,\0b\0", 6)).find("UTF-16") != std::string::npos);
    CHECK(refusal("PK\x03\x04zip").find("workbook") != std::string::npos);
    CHECK(refusal("a,\"b\n1,2\n") == "test.csv: line 1: the header has a quote that is not closed");
}

TEST_CASE("csv: a record over 1 MiB ends the reading with its line") {
    const std::string long_line(CsvReader::largest_record + 1, 'x');
    CHECK(refusal("a,b\n1,2\n" + long_line + "\n1,2\n") ==
          "test.csv: line 3: a record of more than 1 MiB; is this a CSV file?");
    // One byte less is read.
    CHECK(read("a\n" + long_line.substr(1) + "\n").rows.at(0).fields[0].size() == CsvReader::largest_record);
    // A quote that would close further away than that is an open quote of its own line.
    const auto table = read("a,b\n\"1,2\n" + [] {
        std::string rows;
        while (rows.size() < 2 * CsvReader::largest_record) rows += "3,4\n";
        return rows;
    }() + "5,\"6\"\n");
    CHECK(table.rows.at(0).fault == "has a quote that is not closed");
    CHECK(table.rows.at(1).fields == Fields{"3", "4"});
    CHECK(table.rows.back().fields == Fields{"5", "6"});
}

TEST_CASE("csv: records hand their own bytes back whatever the bytes and however they arrive") {
    constexpr std::string_view alphabet = "ab1.,;\t\"\"\n\r\xC2\xB5\xFF =-";
    std::mt19937 random(3);
    for (int i = 0; i < 20000; ++i) {
        std::string text = "h";
        const auto size = random() % 60;
        for (std::size_t k = 0; k < size; ++k) text += alphabet[random() % alphabet.size()];
        CAPTURE(text);
        std::string whole;
        try {
            const auto table = read(text);
            CHECK(table.bytes == text);
            const auto pieces = read(text, 1 + random() % 5);
            if (pieces.dialect.separator != table.dialect.separator ||
                pieces.dialect.line_end != table.dialect.line_end) {
                continue;  // fewer first bytes, another guess
            }
            REQUIRE(pieces.rows.size() == table.rows.size());
            for (std::size_t r = 0; r < table.rows.size(); ++r) {
                CHECK(pieces.rows[r].fields == table.rows[r].fields);
                CHECK(pieces.rows[r].fault == table.rows[r].fault);
                CHECK(pieces.rows[r].line == table.rows[r].line);
            }
        } catch (const UsageError&) {
            continue;  // a faulty header
        }
    }
}

TEST_CASE("csv writer: numbers mirror the decimal mark") {
    CsvWriter writer({.separator = ';', .decimal_comma = true, .line_end = "\r\n"});
    writer.add_raw("\"kept \"\"so\"\"\"");
    writer.add_number(0.75);
    writer.add_number(-1.5e-7);
    writer.add_number(3);
    writer.add_empty();
    writer.end_row();
    CHECK(writer.text() == "\"kept \"\"so\"\"\";0,75;-1,5e-07;3;\r\n");
}

TEST_CASE("csv writer: text is quoted where needed and never a formula") {
    CsvWriter writer{CsvDialect{}};
    for (const auto* text :
         {"plain", "a,b", "say \"no\"", "two\nlines", "=1+1", "+1", "-1", "@x", " edge", ""}) {
        writer.add_text(text);
    }
    writer.add_number(-1);
    writer.end_row("");
    CHECK(writer.text() == "plain,\"a,b\",\"say \"\"no\"\"\",\"two\nlines\",'=1+1,'+1,'-1,'@x,\" edge\",,-1");
}

TEST_CASE("csv writer: what is written is read back") {
    CsvWriter writer({.separator = ';'});
    writer.add_text("a;1");
    writer.add_text("b\"\r\n");
    writer.end_row();
    writer.add_text("x");
    writer.add_number(1e300);
    writer.end_row();
    const auto table = read("sep=;\n" + writer.text());
    CHECK(table.header == Fields{"a;1", "b\"\r\n"});
    CHECK(table.rows.at(0).fields == Fields{"x", "1e+300"});
}
