#include "io/csv_batch.hpp"

#include <algorithm>
#include <cctype>

#include "bioprint/errors.hpp"
#include "io/csv.hpp"
#include "io/processor_time.hpp"
#include "io/row_answer.hpp"
#include "io/spread_text.hpp"
#include "io/text.hpp"
#include "numerics/parallel.hpp"

namespace bioprint {
namespace {

/// A column that asks something: "radius", "radius [um]", "flowrate (uL/h)".
struct QuestionColumn {
    std::size_t index;
    Key key;
    std::string origin;
    std::string unit;  ///< for cells that are a number alone; empty: SI
};

struct HeaderName {
    std::string_view name;
    std::string_view unit;
};

HeaderName split_header(std::string_view header) {
    header = trimmed(header);
    const std::size_t open = header.find_first_of("[(");
    if (open == std::string_view::npos || open == 0) return {header, {}};
    const std::size_t close = header.find_first_of("])", open);
    if (close == std::string_view::npos) return {header, {}};
    return {trimmed(header.substr(0, open)), trimmed(header.substr(open + 1, close - open - 1))};
}

/// What a header means: which columns ask, which are the user's alone, and which are ours from an earlier
/// run.
class Layout {
  public:
    explicit Layout(const std::vector<std::string>& header) {
        const std::size_t block = answer_block(header);
        std::vector<std::size_t> ours;
        for (std::size_t i = 0; i < header.size(); ++i) {
            if (i >= block) {
                ours.push_back(i);
            } else {
                kept_.push_back(i);
                add_question(i, header[i], false);
            }
        }
        // Nothing but an answer: its input asks again.
        if (questions_.empty()) {
            for (const std::size_t i : ours) add_question(i, header[i], true);
        }
    }

    [[nodiscard]] const std::vector<std::size_t>& kept() const { return kept_; }
    [[nodiscard]] const std::vector<QuestionColumn>& questions() const { return questions_; }
    [[nodiscard]] bool asks(Key key) const {
        return std::any_of(questions_.begin(), questions_.end(), [&](const auto& q) { return q.key == key; });
    }
    [[nodiscard]] bool is_kept(std::size_t column) const {
        return std::find(kept_.begin(), kept_.end(), column) != kept_.end();
    }

  private:
    /// Where an earlier run's columns begin: the last ones, from input.radius on, all named like ours. A column of the
    /// user's that is named like one of ours stands before them.
    static std::size_t answer_block(const std::vector<std::string>& header) {
        std::size_t begin = header.size();
        for (std::size_t i = header.size(); i-- > 0 && is_answer_header(header[i]);) {
            if (header[i] == "input.radius [m]") begin = i;
        }
        return begin;
    }

    void add_question(std::size_t index, const std::string& header, bool as_input) {
        const HeaderName parts = split_header(header);
        if (as_input && !parts.name.starts_with("input.")) return;
        const std::optional<Key> key = find_key(parts.name);
        if (!key) return;
        if (asks(*key)) {
            throw UsageError(
                "column " + in_quotes(header) + ": a second column asks the same; remove or rename one",
                in_quotes(header));
        }
        questions_.push_back({.index = index,
                              .key = *key,
                              .origin = "column " + in_quotes(header),
                              .unit = info_of(*key).dimension ? std::string(parts.unit) : std::string{}});
    }

    std::vector<std::size_t> kept_;
    std::vector<QuestionColumn> questions_;
};

/// A row on its way: the bytes to hand back, and what it asks.
struct Row {
    std::size_t line = 0;
    bool blank = false;
    bool sealed = false;  ///< handed back as it is, with nothing behind
    std::string fault;
    std::string kept;
    std::string line_end;
    std::vector<std::string> cells;  ///< by question column
    std::string answer;
    bool refused = false;
    ExtraResults extras;
    std::vector<bool> absent;  ///< of the paths asked for
};

bool ends_as_number(std::string_view text) {
    return !text.empty() && (std::isdigit(static_cast<unsigned char>(text.back())) != 0 ||
                             text.back() == '.' || text.back() == ',');
}

void require_questions(const Layout& layout, const std::string& file) {
    if (!layout.questions().empty()) return;
    throw UsageError(file +
                     ": no column is understood; name at least one after an option, such as "
                     "radius, flowrate, alpha, or a path such as input.ink.eta0");
}

class CsvBatch {
  public:
    CsvBatch(ByteSource& source, const BatchInput& input, const RunOptions& options)
        : reader_(source, input.file == "-" ? "standard input" : input.file),
          layout_(reader_.header()),
          input_(input),
          options_(options) {
        require_questions(layout_, input.file);
    }

    RunResult run(const Sink& sink, const Sink& notice) {
        remark_on_columns(notice);
        if (options_.shard) share_ = rows_of(*options_.shard, count_csv_records(input_.file).records);
        bool more = read_chunk();
        AnswerShape shape = shape_of(input_.defaults);
        shape.cells = entries();
        shape.population = shape.population || layout_.asks(Key::population);
        shape.passages = shape.passages > 0 ? shape.cells / 3 : 0;
        shape.thresholds = thresholds();
        Extras extras = options_.extras;
        extras.uncertainty.wanted = extras.uncertainty.wanted || (in_kind() && has_spreads());
        with_spread_ = extras.uncertainty.wanted;
        columns_.emplace(shape, extras);
        RunResult result = options_.start;
        result.format = options_.format;
        CheckTally tally(options_.extras.checks);
        PathTally paths(options_.paths);
        if (writes_head(options_, result)) sink(head());
        std::size_t passed = 0;  // rows that an earlier part of this run has answered
        while ((more || !rows_.empty()) && !result.interrupted) {
            more = keep_share() && more;
            const std::size_t known = std::min(rows_.size(), options_.start.read - passed);
            passed += known;
            rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(known));
            result.read += rows_.size();
            const double rows_begin = processor_time();
            for_each_index(rows_.size(), options_.jobs, [&](std::size_t i) { answer(rows_[i]); });
            result.row_time += processor_time() - rows_begin;
            for (Row& row : rows_) {
                if (!row.blank) {
                    result.refused += row.refused ? 1 : 0;
                    tally.add(row.extras.checks);
                    paths.add(row.absent);
                    if (row.sealed) notice("line " + std::to_string(row.line) + ": " + row.fault);
                    sink(placed(row.answer, result.rows));
                    ++result.rows;
                } else if (in_kind()) {
                    sink(row.kept + row.line_end);
                }
            }
            result.interrupted = options_.interrupted && *options_.interrupted;
            if (options_.keep && !rows_.empty()) options_.keep(result);
            rows_.clear();
            if (more) more = read_chunk();
        }
        if (as_array() && !(options_.keep && result.interrupted)) sink("\n]\n");
        paths.say(notice);
        result.failed_checks = tally.lines();
        return result;
    }

  private:
    [[nodiscard]] bool in_kind() const { return options_.paths.empty() && options_.format == Format::csv; }
    [[nodiscard]] bool as_array() const { return options_.paths.empty() && options_.format == Format::json; }

    [[nodiscard]] std::string placed(const std::string& text, std::size_t index) const {
        return as_array() && index > 0 ? ",\n" + text : text;
    }

    void remark_on_columns(const Sink& notice) const {
        std::string unknown;
        for (const std::size_t i : layout_.kept()) {
            const auto& questions = layout_.questions();
            const bool asks =
                std::any_of(questions.begin(), questions.end(), [&](const auto& q) { return q.index == i; });
            if (!asks) unknown += (unknown.empty() ? "'" : ", '") + reader_.header()[i] + "'";
        }
        if (!unknown.empty()) notice("columns handed back without a meaning to this program: " + unknown);
    }

    /// Entries of `cells` to provide columns for. Where rows choose their positions, the first row sets how
    /// many.
    [[nodiscard]] std::size_t entries() const {
        if (!layout_.asks(Key::offset)) return cell_entries(input_.defaults);
        for (const Row& row : rows_) {
            try {
                const Settings settings = settings_of_row(row);
                if (settings.has(Key::offset)) return 3 * settings.at(Key::offset).positions.size();
            } catch (const UsageError&) {
                continue;
            }
        }
        return cell_entries(input_.defaults);
    }

    /// And thresholds of the population.
    [[nodiscard]] std::size_t thresholds() const {
        const AnswerShape usual = shape_of(input_.defaults);
        if (!layout_.asks(Key::threshold)) return usual.thresholds;
        for (const Row& row : rows_) {
            try {
                const AnswerShape shape = shape_of(settings_of_row(row));
                if (shape.thresholds > 0) return shape.thresholds;
            } catch (const UsageError&) {
                continue;
            }
        }
        return usual.thresholds;
    }

    /// Whether any cell has a ±, so that there are columns for what comes of it. A file is read through for that; of a
    /// stream one row is sure to be here, and the columns must not depend on how its bytes come.
    [[nodiscard]] bool has_spreads() const {
        if (!can_be_read_twice(input_.file)) return !rows_.empty() && has_spread_cell(rows_.front());
        const std::unique_ptr<ByteSource> source = open_bytes(input_.file);
        CsvReader reader(*source, input_.file);
        while (reader.next()) {
            if (has_spread_cell(take(reader.record()))) return true;
        }
        return false;
    }

    [[nodiscard]] bool has_spread_cell(const Row& row) const {
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            if (info_of(layout_.questions()[i].key).dimension && has_spread(row.cells[i])) return true;
        }
        return false;
    }

    [[nodiscard]] std::string head() const {
        if (as_array()) return "[\n";
        if (!in_kind()) return {};
        CsvWriter writer(reader_.dialect());
        for (const std::size_t i : layout_.kept()) writer.add_raw(reader_.raw_header()[i]);
        for (const std::string& name : columns_->headers()) writer.add_text(name);
        const std::string& end = reader_.header_line_end();
        writer.end_row(end.empty() ? reader_.dialect().line_end : end);
        return reader_.preamble() + writer.text();
    }

    /// Drops the rows of other pieces; false when this piece's are all read. The first chunk is read by every
    /// piece, because it decides the columns.
    bool keep_share() {
        if (!share_) return true;
        const std::size_t first = rows_read_;
        rows_read_ += rows_.size();
        const auto place = [&](std::size_t row) { return std::clamp(row, first, rows_read_) - first; };
        const auto end = rows_.begin() + static_cast<std::ptrdiff_t>(place(share_->end));
        rows_.erase(end, rows_.end());
        rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(
                                                       std::min(place(share_->begin), rows_.size())));
        return rows_read_ < share_->end;
    }

    /// Reads the next rows; false at the end of the file.
    bool read_chunk() {
        while (rows_.size() < chunk_rows) {
            // Who sends rows one by one and waits for each answer must not wait for a full chunk.
            if (!rows_.empty() && !reader_.has_buffered_line()) break;
            if (!reader_.next()) return false;
            rows_.push_back(take(reader_.record()));
        }
        return true;
    }

    [[nodiscard]] Row take(const CsvRecord& record) const {
        Row row{.line = record.line,
                .blank = record.blank,
                .fault = record.fault,
                .kept = {},
                .line_end = std::string(record.line_end),
                .cells = {},
                .answer = {},
                .extras = {},
                .absent = {}};
        // Missing cells at the end are empty cells; what is too long or never closed cannot take columns of ours.
        if (record.fields.size() < reader_.header().size() && !record.open_quote &&
            record.raw.find('\0') == std::string_view::npos) {
            row.fault.clear();
        }
        const std::size_t count = record.fields.size();
        const bool into_ours = count > layout_.kept().size() && count < reader_.header().size();
        row.sealed = record.open_quote || count > reader_.header().size() || into_ours;
        if (into_ours) row.fault = "has more cells than there are columns of the user's";
        if (record.blank || row.sealed) {
            row.kept = record.raw;
            return row;
        }
        const char separator = reader_.dialect().separator;
        bool first = true;
        for (std::size_t i = 0; i < record.raw_fields.size(); ++i) {
            const bool extra = i >= reader_.header().size();
            if (!extra && !layout_.is_kept(i)) continue;
            if (!first) row.kept += separator;
            row.kept += record.raw_fields[i];
            first = false;
        }
        // A row that is too short is filled up, so that our columns stand under their names.
        for (std::size_t i = record.raw_fields.size(); i < reader_.header().size(); ++i) {
            if (layout_.is_kept(i)) row.kept += separator;
        }
        for (const QuestionColumn& q : layout_.questions()) {
            row.cells.emplace_back(q.index < record.fields.size() ? record.fields[q.index]
                                                                  : std::string_view{});
        }
        return row;
    }

    [[nodiscard]] Settings settings_of_row(const Row& row) const {
        Settings settings;
        Problems problems;
        const NumberStyle style{.decimal_comma = reader_.dialect().decimal_comma};
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const std::string_view cell = trimmed(row.cells[i]);
            if (cell.empty()) continue;
            const QuestionColumn& q = layout_.questions()[i];
            problems.collect([&] {
                if (!q.unit.empty() && ends_as_number(cell)) {
                    settings.set(q.key, std::string(cell) + " " + q.unit, q.origin, style);
                } else {
                    settings.set(q.key, cell, q.origin, style);
                }
            });
        }
        problems.raise();
        return settings.over(input_.defaults);
    }

    void answer(Row& row) const {
        if (row.blank) return;
        const auto question = [&] {
            if (!row.fault.empty()) throw UsageError("line " + std::to_string(row.line) + ": " + row.fault);
            Settings settings = settings_of_row(row);
            if (in_kind() && shape_of(settings).thresholds > columns_->shape().thresholds) {
                throw UsageError("line " + std::to_string(row.line) +
                                 ": more thresholds than the first row has; put the longest list first");
            }
            if (layout_.asks(Key::offset) && cell_entries(settings) > columns_->shape().cells && in_kind()) {
                throw UsageError("line " + std::to_string(row.line) +
                                 ": more positions than the first row has; put the longest list first");
            }
            if (in_kind() && !with_spread_ && settings.has_deviation()) {
                throw UsageError(
                    "line " + std::to_string(row.line) +
                    ": has a ±, and there are no columns for it, because the first row of this stream "
                    "has none; move it to the top, or give a file, --uncertainty or --format jsonl");
            }
            return settings;
        };
        const RowAnswer result = answer_row(question, options_.extras);
        row.refused = result.refused;
        row.extras = result.extras;
        if (!options_.paths.empty()) {
            ValuesLine line = values_line(result, options_.paths);
            row.answer = std::move(line.text);
            row.absent = std::move(line.absent);
        } else if (options_.format == Format::csv) {
            row.answer = csv_line(row, result.object);
        } else {
            row.answer = json_text(result.object);
            if (options_.format == Format::jsonl) row.answer += '\n';
        }
    }

    [[nodiscard]] std::string csv_line(const Row& row, const Json& object) const {
        if (row.sealed) return row.kept + row.line_end;
        CsvWriter writer(reader_.dialect());
        if (!layout_.kept().empty()) writer.add_raw(row.kept);
        columns_->write(object, writer);
        writer.end_row(row.line_end);
        return writer.text();
    }

    CsvReader reader_;
    Layout layout_;
    const BatchInput& input_;
    const RunOptions& options_;
    std::optional<CsvColumns> columns_;
    bool with_spread_ = false;  ///< there are columns for the uncertainty
    std::vector<Row> rows_;
    std::optional<RowRange> share_;  ///< of `--shard`
    std::size_t rows_read_ = 0;      ///< counted with a share only
};

}  // namespace

RecordCount count_csv_records(const std::string& file) {
    const std::unique_ptr<ByteSource> source = open_bytes(file);
    CsvReader reader(*source, file);
    require_questions(Layout(reader.header()), file);
    RecordCount count;
    for (; reader.next(); ++count.records) {
        if (reader.record().blank) count.empty.push_back(count.records);
    }
    return count;
}

RunResult run_csv_batch(ByteSource& source, const BatchInput& input, const RunOptions& options,
                        const Sink& sink, const Sink& notice) {
    return CsvBatch(source, input, options).run(sink, notice);
}

}  // namespace bioprint
