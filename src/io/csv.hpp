#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "io/byte_source.hpp"

/// CSV as laboratories keep it: RFC 4180, and what spreadsheets make of it.
///
/// The reader recognises the UTF-8 byte order mark, a first line `sep=;`, the separator (comma, semicolon,
/// tab), the line ends (LF, CRLF, CR) and, where the separator is not the comma, decimal commas. It streams:
/// memory does not grow with the file. Every record keeps its own bytes, so that a batch can hand them back
/// unchanged.
///
/// Bytes: any byte but NUL is passed on as it is, valid UTF-8 or not; a NUL byte is the record's fault.
/// UTF-16 is refused with the remedy. A record over 1 MiB ends the reading. Throughput: measured in
/// tests/bench/csv.cpp.
namespace bioprint {

struct CsvDialect {
    char separator = ',';
    bool decimal_comma = false;
    bool byte_order_mark = false;
    std::string line_end = "\n";
};

/// One record. All views are void after the next call of `CsvReader::next`.
struct CsvRecord {
    std::size_t line = 0;                      ///< number of its first line, from 1
    std::string_view raw;                      ///< its bytes without the line end
    std::string_view line_end;                 ///< "\n", "\r\n", "\r", or empty at the end of the file
    std::vector<std::string_view> fields;      ///< without quotes, doubled quotes made single
    std::vector<std::string_view> raw_fields;  ///< the bytes of each field, with quotes
    bool blank = false;                        ///< an empty line; it has no fields and no fault
    /// Empty, or what is wrong: another number of fields than the header, a quote not closed, text behind a
    /// closing quote, a NUL byte. The record after it is read as usual.
    std::string fault;
    /// The fault is a quote that is not closed: nothing may be appended to these bytes in a CSV.
    bool open_quote = false;
};

class CsvReader {
  public:
    static constexpr std::size_t largest_record = std::size_t{1} << 20U;

    /// Reads up to and with the header.
    /// @param name  of the file, for messages
    /// @throws UsageError  no header, UTF-16, a record over 1 MiB or a faulty header
    CsvReader(ByteSource& source, std::string name);

    [[nodiscard]] const CsvDialect& dialect() const { return dialect_; }
    /// The bytes before the header: byte order mark, `sep=` line, empty lines.
    [[nodiscard]] const std::string& preamble() const { return preamble_; }
    [[nodiscard]] const std::vector<std::string>& header() const { return header_; }
    [[nodiscard]] const std::vector<std::string>& raw_header() const { return raw_header_; }
    /// Empty when the file is a header without a line end.
    [[nodiscard]] const std::string& header_line_end() const { return header_line_end_; }

    /// Reads a record; false at the end.
    /// @throws UsageError  a record over 1 MiB
    bool next();
    [[nodiscard]] const CsvRecord& record() const { return record_; }
    /// The next line is here already, so that `next` need not wait for the source.
    [[nodiscard]] bool has_buffered_line() const;

  private:
    struct Scan;
    void detect();
    void take_preamble(std::size_t count);
    bool read_record();
    bool scan(Scan& scan);
    bool scan_field(Scan& scan);
    bool scan_quoted(Scan& scan);
    bool end_field(Scan& scan, std::size_t start, bool quoted);
    void finish(const Scan& scan);
    [[noreturn]] void fail(const std::string& what) const;

    InputBuffer input_;
    std::string name_;
    CsvDialect dialect_;
    std::string preamble_;
    std::vector<std::string> header_;
    std::vector<std::string> raw_header_;
    std::string header_line_end_;
    CsvRecord record_;
    std::string unescaped_;
    std::size_t used_ = 0;  ///< bytes of the current record, dropped with the next one
    std::size_t line_ = 1;
};

/// Builds rows in memory; `text()` is what there is to write. Mirrors a dialect.
class CsvWriter {
  public:
    explicit CsvWriter(CsvDialect dialect) : dialect_(std::move(dialect)) {}
    /// A field as it stands, quotes and all: the user's own bytes, or several fields with their separators.
    void add_raw(std::string_view bytes);
    /// The shortest form that reads back, with the dialect's decimal mark. Not finite: an empty field.
    void add_number(double value);
    /// Quoted where CSV needs it. Text that a spreadsheet would take for a formula (it starts with = + - @, a
    /// tab or a carriage return) gets a ' in front.
    void add_text(std::string_view text);
    void add_empty() { begin_field(); }
    /// Ends the row with the dialect's line end, or with the one given (a last line may have none).
    void end_row() { end_row(dialect_.line_end); }
    void end_row(std::string_view line_end);
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const CsvDialect& dialect() const { return dialect_; }
    void clear() { text_.clear(); }

  private:
    void begin_field();
    CsvDialect dialect_;
    std::string text_;
    bool first_ = true;
};

}  // namespace bioprint
