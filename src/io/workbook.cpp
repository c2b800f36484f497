#include "io/workbook.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

#include "bioprint/errors.hpp"
#include "io/byte_source.hpp"
#include "io/csv.hpp"
#include "io/csv_columns.hpp"
#include "io/text.hpp"
#include "io/xlsx_library.hpp"

namespace bioprint {
namespace {

constexpr const char* sheet_name = "Answers";
constexpr std::size_t most_rows = 1048575;  // of a sheet, less the header
constexpr std::size_t most_columns = 16384;
constexpr std::size_t most_bytes_of_text = 32767;  // characters, at most as many as bytes
constexpr std::size_t most_digits = 15;            // that a spreadsheet keeps of a number

[[noreturn]] void fail(const std::string& what) {
    throw DataError("the workbook cannot be written: " + what +
                    "; make room in the folder for temporary files");
}

class FileBytes : public ByteSource {
  public:
    explicit FileBytes(std::FILE* file) : file_(file) {}
    std::size_t read(char* into, std::size_t size) override { return std::fread(into, 1, size, file_); }

  private:
    std::FILE* file_;
};

/// A file with a name, for a library that wants one; gone with this object.
class NamedScratch {
  public:
    NamedScratch() {
        const char* const folder = std::getenv("TMPDIR");
        name_ = std::string(folder != nullptr && *folder != '\0' ? folder : "/tmp") + "/bioprint-XXXXXX";
        const int file = ::mkstemp(name_.data());
        if (file < 0) fail(std::generic_category().message(errno));
        ::close(file);
    }
    NamedScratch(const NamedScratch&) = delete;
    NamedScratch& operator=(const NamedScratch&) = delete;
    ~NamedScratch() { ::unlink(name_.c_str()); }
    [[nodiscard]] const std::string& name() const { return name_; }

    [[nodiscard]] std::string content() const {
        const std::unique_ptr<ByteSource> source = open_bytes(name_);
        std::string bytes;
        std::array<char, 65536> buffer{};
        while (const std::size_t count = source->read(buffer.data(), buffer.size())) {
            bytes.append(buffer.data(), count);
        }
        return bytes;
    }

  private:
    std::string name_;
};

/// The number a cell holds; nothing for texts, and for numbers that are names (007, +49…, long identifiers).
std::optional<double> number_in(std::string_view cell, bool decimal_comma) {
    if (cell.empty() || cell.front() == '+') return std::nullopt;
    const std::string_view body = cell.front() == '-' ? cell.substr(1) : cell;
    if (body.empty() || body.front() < '0' || body.front() > '9') return std::nullopt;
    if (body.size() > 1 && body[0] == '0' && body[1] >= '0' && body[1] <= '9') return std::nullopt;
    if (body.size() > most_digits && body.find_first_not_of("0123456789") == std::string_view::npos)
        return std::nullopt;
    std::string text(cell);
    if (decimal_comma) {
        if (text.find('.') != std::string::npos) return std::nullopt;
        if (const std::size_t comma = text.find(','); comma != std::string::npos) text[comma] = '.';
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Text of a cell: in UTF-8, no longer than a cell may be, without the mark that kept it from being a formula.
std::string text_in(std::string_view cell) {
    if (cell.size() > 1 && cell[0] == '\'' &&
        std::string_view("=+-@\t\r").find(cell[1]) != std::string_view::npos) {
        cell.remove_prefix(1);
    }
    std::string out;
    while (!cell.empty() && out.size() < most_bytes_of_text - 4) {
        const std::size_t length = utf8_length(cell);
        out += length == 0 ? std::string_view("\xEF\xBF\xBD") : cell.substr(0, length);
        cell.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return out;
}

/// A column of numbers: its first value, and whether another one follows.
struct ColumnSeen {
    std::optional<double> first;
    bool varies = false;
    std::string text;  ///< of its first row, when it is no number
};

class Sheet {
  public:
    Sheet(const XlsxLibrary& library, lxw_workbook* book) : xlsx_(library) {
        sheet_ = xlsx_.add_worksheet(book, sheet_name);
        heading_ = xlsx_.add_format(book);
        xlsx_.set_bold(heading_);
        xlsx_.set_text_wrap(heading_);
        xlsx_.set_align(heading_, LXW_ALIGN_VERTICAL_TOP);
    }

    void head(const std::vector<std::string>& names) {
        if (names.size() > most_columns) {
            throw UsageError("--output: a workbook holds at most 16384 columns; write a .csv", "--output");
        }
        names_ = names;
        seen_.resize(names.size());
        constexpr double width = 15.0;
        constexpr double height = 48.0;
        xlsx_.set_column(sheet_, 0, static_cast<lxw_col_t>(names.size() - 1), width, nullptr);
        xlsx_.set_row(sheet_, 0, height, heading_);
        for (std::size_t i = 0; i < names.size(); ++i) {
            xlsx_.write_string(sheet_, 0, static_cast<lxw_col_t>(i), text_in(names[i]).c_str(), heading_);
        }
        xlsx_.freeze_panes(sheet_, 1, 0);
    }

    void row(const std::vector<std::string_view>& cells, bool decimal_comma) {
        if (++rows_ > most_rows) {
            throw UsageError("--output: a workbook holds at most 1048575 rows; write a .csv", "--output");
        }
        for (std::size_t i = 0; i < cells.size() && i < most_columns; ++i) {
            if (cells[i].empty()) continue;
            const auto column = static_cast<lxw_col_t>(i);
            const std::optional<double> number = number_in(cells[i], decimal_comma);
            if (number) {
                xlsx_.write_number(sheet_, static_cast<lxw_row_t>(rows_), column, *number, nullptr);
            } else {
                xlsx_.write_string(sheet_, static_cast<lxw_row_t>(rows_), column, text_in(cells[i]).c_str(),
                                   nullptr);
            }
            if (i < seen_.size()) note(seen_[i], number, cells[i]);
        }
    }

    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    [[nodiscard]] const std::vector<ColumnSeen>& seen() const { return seen_; }

  private:
    void note(ColumnSeen& seen, std::optional<double> number, std::string_view cell) const {
        if (!number && rows_ == 1) seen.text = cell;
        if (number && seen.first && *number != *seen.first) seen.varies = true;
        if (number && !seen.first) seen.first = number;
    }

    const XlsxLibrary& xlsx_;
    lxw_worksheet* sheet_ = nullptr;
    lxw_format* heading_ = nullptr;
    std::size_t rows_ = 0;
    std::vector<std::string> names_;
    std::vector<ColumnSeen> seen_;
};

/// The first quantity asked that differs from row to row.
std::optional<std::size_t> varying_input(const Sheet& sheet) {
    for (std::size_t i = 0; i < sheet.names().size(); ++i) {
        if (sheet.names()[i].starts_with("input.") && sheet.seen()[i].varies) return i;
    }
    return std::nullopt;
}

struct ChartColumn {
    std::size_t index;
    std::string name;
};

/// The stress at the wall, and of the centred cell at the exit by the model that carries it in time.
std::vector<ChartColumn> charted(const Sheet& sheet) {
    std::vector<ChartColumn> columns;
    std::string carried;
    for (std::size_t i = 0; i < sheet.names().size(); ++i) {
        const std::string& name = sheet.names()[i];
        if (name == "nozzle.stress_max [Pa]") columns.push_back({i, "ink at the wall of the nozzle"});
        if (name.starts_with("cells.") && name.ends_with(".model") && sheet.seen()[i].text == "ellipsoid" &&
            carried.empty()) {
            carried =
                name.substr(0, name.size() - std::string_view("model").size()) + "stress.von_mises [Pa]";
        }
        if (!carried.empty() && name == carried) columns.push_back({i, "centred cell at the exit"});
    }
    return columns;
}

void add_chart(const XlsxLibrary& xlsx, lxw_workbook* book, const Sheet& sheet) {
    const std::optional<std::size_t> x = varying_input(sheet);
    const std::vector<ChartColumn> columns = charted(sheet);
    if (!x || columns.empty() || sheet.rows() < 2) return;
    lxw_chart* const chart = xlsx.add_chart(book, LXW_CHART_SCATTER_STRAIGHT_WITH_MARKERS);
    const auto range = [&](std::size_t column) {
        std::string letters;
        for (std::size_t n = column + 1; n > 0; n = (n - 1) / 26) {
            letters.insert(letters.begin(), static_cast<char>('A' + (n - 1) % 26));
        }
        return "=" + std::string(sheet_name) + "!$" + letters + "$2:$" + letters + "$" +
               std::to_string(sheet.rows() + 1);
    };
    for (const ChartColumn& column : columns) {
        lxw_chart_series* const series =
            xlsx.add_series(chart, range(*x).c_str(), range(column.index).c_str());
        xlsx.set_series_name(series, column.name.c_str());
    }
    xlsx.set_title(chart, "Stress");
    xlsx.set_axis_name(chart->x_axis, text_in(sheet.names()[*x]).c_str());
    xlsx.set_axis_name(chart->y_axis, "stress [Pa]");
    xlsx.set_chart(xlsx.add_chartsheet(book, "Chart"), chart);
}

}  // namespace

Workbook::Workbook() : spool_(nullptr, &std::fclose) {
    xlsx_library();
    spool_.reset(std::tmpfile());
    if (!spool_) fail(std::generic_category().message(errno));
}

void Workbook::add(std::string_view csv) {
    if (std::fwrite(csv.data(), 1, csv.size(), spool_.get()) != csv.size()) {
        fail(std::generic_category().message(errno));
    }
}

std::string Workbook::bytes() {
    std::rewind(spool_.get());
    FileBytes source(spool_.get());
    CsvReader reader(source, "the answers");
    const NamedScratch scratch;
    const XlsxLibrary& xlsx = xlsx_library();
    // Rows go to the disk as they come, so that memory does not grow with them.
    lxw_workbook_options options{};
    options.constant_memory = LXW_TRUE;
    lxw_workbook* const book = xlsx.new_workbook(scratch.name().c_str(), &options);
    if (book == nullptr) fail("libxlsxwriter has no memory");
    Sheet sheet(xlsx, book);
    try {
        sheet.head(reader.header());
        while (reader.next()) {
            if (!reader.record().blank) sheet.row(reader.record().fields, reader.dialect().decimal_comma);
        }
    } catch (...) {
        xlsx.close(book);
        throw;
    }
    add_chart(xlsx, book, sheet);
    const lxw_error error = xlsx.close(book);
    if (error != LXW_NO_ERROR) fail(xlsx.error_text(error));
    return scratch.content();
}

}  // namespace bioprint
