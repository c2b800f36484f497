#include "io/csv.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/csv_dialect.hpp"

namespace bioprint {

/// One attempt at a record, from the start of the window. It is made again when the window turns out too
/// short.
struct CsvReader::Scan {
    std::string_view window;
    char terminator;         ///< '\n', or '\r' for a file that has only these
    std::size_t at = 0;      ///< next byte
    std::size_t end = 0;     ///< end of the record, before its line end
    std::size_t lines = 1;   ///< lines of the record
    bool literal = false;    ///< quotes are taken as ordinary bytes: the second attempt after an open quote
    bool in_quotes = false;  ///< the window ended inside quotes
    std::size_t close = 0;   ///< the last closing quote
    bool text_after_quote = false;
};

CsvReader::CsvReader(ByteSource& source, std::string name) : input_(source), name_(std::move(name)) {
    detect();
    do {
        if (!read_record()) fail("is empty; a batch starts with a line of column names");
        if (record_.blank) preamble_.append(record_.raw).append(record_.line_end);
    } while (record_.blank);
    if (!record_.fault.empty())
        fail("line " + std::to_string(record_.line) + ": the header " + record_.fault);
    header_.assign(record_.fields.begin(), record_.fields.end());
    raw_header_.assign(record_.raw_fields.begin(), record_.raw_fields.end());
    header_line_end_ = record_.line_end;
}

void CsvReader::fail(const std::string& what) const {
    throw UsageError(name_ + ": " + what, name_);
}

void CsvReader::detect() {
    // A header and a first row are enough; a pipe that waits for its answers must not be kept waiting.
    constexpr std::size_t enough = std::size_t{1} << 16U;
    while (input_.more()) {
        const auto head = input_.rest();
        if (head.size() >= enough || std::count(head.begin(), head.end(), '\n') >= 2) break;
    }
    const auto refusal = refusal_of_csv(input_.rest());
    if (!refusal.empty()) fail(std::string(refusal));
    const CsvHead head = detect_csv(input_.rest(), input_.at_end());
    dialect_ = head.dialect;
    preamble_ = input_.rest().substr(0, head.preamble);
    line_ += preamble_.size() > 3 ? 1 : 0;
    input_.drop(head.preamble);
}

bool CsvReader::next() {
    if (!read_record()) return false;
    if (record_.fault.empty() && !record_.blank && record_.fields.size() != header_.size()) {
        record_.fault = "has " + std::to_string(record_.fields.size()) +
                        (record_.fields.size() == 1 ? " field" : " fields") + ", the header has " +
                        std::to_string(header_.size());
    }
    return true;
}

bool CsvReader::read_record() {
    input_.drop(used_);
    used_ = 0;
    Scan attempt{};
    bool literal = false;
    for (;;) {
        if (input_.rest().empty() && !input_.more()) return false;
        const bool at_end = input_.at_end();
        attempt = Scan{.window = input_.rest(), .terminator = dialect_.line_end.back(), .literal = literal};
        record_.fields.clear();
        record_.raw_fields.clear();
        unescaped_.clear();
        const bool complete = scan(attempt);
        if (complete && attempt.end <= largest_record) break;
        if (!complete && !at_end && attempt.window.size() <= largest_record) {
            input_.more();
            continue;
        }
        // Too long, or at the end of the file inside a quote: then the quote is at fault, and the record is
        // its line.
        if (literal || !(attempt.in_quotes || attempt.lines > 1)) {
            fail("line " + std::to_string(line_) + ": a record of more than 1 MiB; is this a CSV file?");
        }
        literal = true;
    }
    finish(attempt);
    return true;
}

/// Splits the record at the window's start. False when the window ends before the record does.
bool CsvReader::scan(Scan& scan) {
    while (!scan_field(scan)) {
        if (scan.at == std::string_view::npos) return false;
    }
    return true;
}

/// One field; true when it was the record's last. Sets `at` to npos when the window is too short.
bool CsvReader::scan_field(Scan& scan) {
    const std::string_view window = scan.window;
    const std::size_t start = scan.at;
    bool is_quoted = false;
    if (start < window.size() && window[start] == '"' && !scan.literal) {
        is_quoted = true;
        if (!scan_quoted(scan)) return false;
    }
    std::size_t i = scan.at;
    const char separator = dialect_.separator;
    const char terminator = scan.terminator;
    const char* const bytes = window.data();
    const std::size_t size = window.size();
    while (i < size && bytes[i] != separator && bytes[i] != terminator) ++i;
    scan.at = i;
    if (i == size && !input_.at_end()) {
        scan.at = std::string_view::npos;
        return false;
    }
    return end_field(scan, start, is_quoted);
}

/// Moves `at` behind the closing quote and notes whether quotes inside are doubled. False: the window is too
/// short, or the quote is open up to the end.
bool CsvReader::scan_quoted(Scan& scan) {
    std::size_t i = scan.at + 1;
    const std::string_view window = scan.window;
    for (;;) {
        i = window.find('"', i);
        const bool at_edge = i == std::string_view::npos || i + 1 == window.size();
        if (i == std::string_view::npos || (at_edge && !input_.at_end())) {
            scan.in_quotes = true;
            scan.at = std::string_view::npos;
            return false;
        }
        if (at_edge || window[i + 1] != '"') break;
        i += 2;
    }
    scan.close = i;
    scan.at = i + 1;
    return true;
}

/// Stores the field that ends at `at`; true at the end of the record.
bool CsvReader::end_field(Scan& scan, std::size_t start, bool is_quoted) {
    const std::string_view window = scan.window;
    const bool last = scan.at == window.size() || window[scan.at] == scan.terminator;
    std::size_t end = scan.at;
    if (last) {
        if (end > start && scan.terminator == '\n' && window[end - 1] == '\r') --end;
        scan.end = end;
    }
    const std::string_view raw = window.substr(start, end - start);
    record_.raw_fields.push_back(raw);
    if (!is_quoted) {
        record_.fields.push_back(raw);
    } else {
        if (scan.close + 1 != end) scan.text_after_quote = true;
        const std::string_view inside = window.substr(start + 1, scan.close - start - 1);
        scan.lines += static_cast<std::size_t>(std::count(inside.begin(), inside.end(), scan.terminator));
        if (inside.find('"') == std::string_view::npos) {
            record_.fields.push_back(inside);
        } else {
            // Reserved once a record, so that earlier views into it stay where they are.
            if (unescaped_.empty()) unescaped_.reserve(window.size());
            const std::size_t from = unescaped_.size();
            for (std::size_t i = 0; i < inside.size(); ++i) {
                unescaped_ += inside[i];
                if (inside[i] == '"' && i + 1 < inside.size() && inside[i + 1] == '"') ++i;
            }
            record_.fields.push_back(std::string_view(unescaped_).substr(from));
        }
    }
    if (!last) ++scan.at;
    return last;
}

void CsvReader::finish(const Scan& scan) {
    record_.raw = scan.window.substr(0, scan.end);
    const std::size_t end = std::min(scan.window.size(), scan.at + 1);
    record_.line_end = scan.window.substr(scan.end, end - scan.end);
    record_.line = line_;
    line_ += scan.lines;
    used_ = end;
    record_.blank = record_.raw.empty();
    record_.open_quote = scan.literal;
    record_.fault.clear();
    if (record_.blank) {
        record_.fields.clear();
        record_.raw_fields.clear();
    }
    if (scan.literal) {
        record_.fault = "has a quote that is not closed";
    } else if (scan.text_after_quote) {
        record_.fault = "has text behind a closing quote";
    } else if (std::memchr(record_.raw.data(), '\0', record_.raw.size()) != nullptr) {
        record_.fault = "holds a NUL byte";
    }
}

void CsvWriter::begin_field() {
    if (!first_) text_ += dialect_.separator;
    first_ = false;
}

void CsvWriter::add_raw(std::string_view bytes) {
    begin_field();
    text_ += bytes;
}

void CsvWriter::add_number(double value) {
    begin_field();
    if (!std::isfinite(value)) return;
    const std::size_t start = text_.size();
    append_shortest(text_, value);
    if (!dialect_.decimal_comma) return;
    const auto point = text_.find('.', start);
    if (point != std::string::npos) text_[point] = ',';
}

void CsvWriter::add_text(std::string_view text) {
    begin_field();
    const bool formula =
        !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
    const char special[] = {dialect_.separator, '"', '\n', '\r'};
    const bool spaced = !text.empty() && (text.front() == ' ' || text.back() == ' ');
    const bool quotes =
        spaced || text.find_first_of(std::string_view(special, sizeof special)) != std::string_view::npos;
    if (quotes) text_ += '"';
    if (formula) text_ += '\'';
    for (const char c : text) {
        if (c == '"') text_ += '"';
        text_ += c;
    }
    if (quotes) text_ += '"';
}

void CsvWriter::end_row(std::string_view line_end) {
    text_ += line_end;
    first_ = true;
}

bool CsvReader::has_buffered_line() const {
    return input_.at_end() || input_.rest().substr(used_).find_first_of("\r\n") != std::string_view::npos;
}

}  // namespace bioprint
