#include "io/batch.hpp"

#include <algorithm>
#include <array>

#include "bioprint/errors.hpp"
#include "io/byte_source.hpp"
#include "io/csv_batch.hpp"
#include "io/json_lines.hpp"
#include "io/json_question.hpp"
#include "io/processor_time.hpp"
#include "io/row_answer.hpp"
#include "numerics/parallel.hpp"

namespace bioprint {
namespace {

/// A source whose first bytes were looked at.
class Peeked : public ByteSource {
  public:
    explicit Peeked(ByteSource& source) : source_(source) {
        size_ = source_.read(head_.data(), head_.size());
    }
    [[nodiscard]] std::string_view head() const { return {head_.data(), size_}; }
    std::size_t read(char* into, std::size_t size) override {
        if (used_ == size_) return source_.read(into, size);
        const std::size_t count = std::min(size, size_ - used_);
        std::copy_n(head_.data() + used_, count, into);
        used_ += count;
        return count;
    }

  private:
    ByteSource& source_;
    std::array<char, 4096> head_{};
    std::size_t size_ = 0;
    std::size_t used_ = 0;
};

bool starts_as_json(std::string_view head) {
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && head[first] == '{';
}

std::size_t count_json_lines(const std::string& file) {
    const std::unique_ptr<ByteSource> source = open_bytes(file);
    JsonLinesReader reader(*source);
    std::size_t count = 0;
    while (reader.next()) ++count;
    return count;
}

/// What the asker calls a line, which is no part of the question.
Json take_id(JsonLine& line) {
    const auto id = line.value.find("id");
    if (id == line.value.end()) return nullptr;
    if (!id->is_string() && !id->is_number()) {
        if (line.error.empty()) line.error = "id: takes a text or a number";
        return nullptr;
    }
    Json taken = *id;
    line.value.erase(id);
    return taken;
}

RunResult run_json_lines(ByteSource& source, const BatchInput& input, const RunOptions& options,
                         const Sink& sink, const Sink& notice) {
    const Settings& defaults = input.defaults;
    const Shard whole{.piece = 1, .pieces = 1};
    const RowRange share = rows_of(options.shard.value_or(whole),
                                   options.shard ? count_json_lines(input.file) : ~std::size_t{0});
    JsonLinesReader reader(source);
    for (std::size_t i = 0; i < share.begin && reader.next(); ++i) {
    }
    AnswerShape shape = shape_of(defaults);
    shape.cells *= 3;
    shape.passages *= 3;
    const RowWriter writer(options, shape);
    RunResult result = options.start;
    result.format = options.format;
    for (std::size_t passed = 0; passed < result.read && reader.next(); ++passed) continue;
    CheckTally tally(options.extras.checks);
    PathTally paths(options.paths);
    if (writes_head(options, result)) sink(writer.head());
    std::vector<JsonLine> lines;
    std::vector<RowText> texts;
    bool more = share.begin < share.end;
    while (more && !result.interrupted) {
        lines.clear();
        const std::size_t room = std::min(chunk_rows, share.end - share.begin - result.rows);
        while (lines.size() < room && (lines.empty() || reader.has_buffered_line())) {
            more = reader.next();
            if (!more) break;
            lines.push_back(std::move(reader.line()));
        }
        texts.assign(lines.size(), {});
        const double rows_begin = processor_time();
        for_each_index(lines.size(), options.jobs, [&](std::size_t i) {
            const Json id = take_id(lines[i]);
            const auto question = [&] {
                if (!lines[i].error.empty()) throw UsageError(lines[i].error);
                Settings settings = settings_of(lines[i].value).over(defaults);
                const bool columns = options.format == Format::csv && options.paths.empty();
                if (columns && !options.extras.uncertainty.wanted && settings.has_deviation()) {
                    throw UsageError(
                        "line " + std::to_string(lines[i].number) +
                        ": has a ±, and there are no columns for it; give --uncertainty or --format jsonl");
                }
                return settings;
            };
            texts[i] = writer.answer(question, id);
        });
        result.row_time += processor_time() - rows_begin;
        for (RowText& text : texts) {
            sink(writer.placed(text.text, result.rows));
            ++result.rows;
            result.refused += text.refused ? 1 : 0;
            tally.add(text.extras.checks);
            paths.add(text.absent);
        }
        result.read += lines.size();
        more = more && result.rows < share.end - share.begin;
        result.interrupted = options.interrupted && *options.interrupted;
        if (options.keep) options.keep(result);
    }
    if (!(options.keep && result.interrupted)) sink(writer.tail());
    paths.say(notice);
    result.failed_checks = tally.lines();
    return result;
}

}  // namespace

RunResult run_batch(const BatchInput& input, std::optional<Format> format, const RunOptions& options,
                    const Sink& sink, const Sink& notice) {
    if (options.shard) require_countable(input.file);
    const std::unique_ptr<ByteSource> source = open_bytes(input.file);
    Peeked peeked(*source);
    RunOptions chosen = options;
    if (format == Format::table) {
        throw UsageError("--format: a batch is answered as csv, jsonl or json, not as a table", "--format");
    }
    if (starts_as_json(peeked.head())) {
        chosen.format = format.value_or(Format::jsonl);
        return run_json_lines(peeked, input, chosen, sink, notice);
    }
    chosen.format = format.value_or(Format::csv);
    return run_csv_batch(peeked, input, chosen, sink, notice);
}

std::size_t RecordCount::rows(const RowRange& range) const {
    const auto first = std::lower_bound(empty.begin(), empty.end(), range.begin);
    const auto last = std::lower_bound(empty.begin(), empty.end(), range.end);
    return range.end - range.begin - static_cast<std::size_t>(last - first);
}

bool holds_json_lines(const std::string& file) {
    const std::unique_ptr<ByteSource> source = open_bytes(file);
    return starts_as_json(Peeked(*source).head());
}

RecordCount count_records(const std::string& file) {
    return holds_json_lines(file) ? RecordCount{.records = count_json_lines(file)} : count_csv_records(file);
}

}  // namespace bioprint
