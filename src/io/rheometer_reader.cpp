#include "io/rheometer_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "bioprint/errors.hpp"
#include "io/decoded_text.hpp"
#include "io/flow_columns.hpp"
#include "io/number_columns.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

/// A curve spans at least this factor of the rate; less is a measurement at one rate.
constexpr double least_span = 2.0;
/// Between viscosity and stress over rate, half of the rows must agree this well.
constexpr double agreement = 0.1;

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + (text.substr(end).starts_with("\r\n") ? 2 : 1);
    }
    return lines;
}

struct TextRow {
    std::size_t line;
    std::vector<std::string> fields;
    [[nodiscard]] std::size_t filled() const {
        return static_cast<std::size_t>(
            std::count_if(fields.begin(), fields.end(), [](const auto& f) { return !f.empty(); }));
    }
};

/// Names and units of a table from the words above it.
struct Heading {
    std::vector<ColumnHead> heads;
    std::string name;  ///< of the interval
};

bool is_unit_row(const TextRow& row) {
    std::size_t units = 0;
    for (const std::string& field : row.fields) {
        if (field.empty()) continue;
        if (!unit_text(field)) return false;
        ++units;
    }
    return units > 0;
}

/// The interval's own name: below `[step]`, or behind "Result:" and its like.
std::string interval_name(const std::vector<TextRow>& rows, std::size_t head_row) {
    std::string name;
    for (std::size_t i = 0; i < head_row; ++i) {
        const std::vector<std::string>& fields = rows[i].fields;
        if (rows[i].filled() == 1 && i > 0 && rows[i - 1].filled() == 1 &&
            lower_case(rows[i - 1].fields.front()) == "[step]") {
            name = fields.front();
        }
        if (fields.size() > 1 && !fields[1].empty()) {
            const std::string key = lower_case(fields.front());
            if (key.starts_with("result") || key.starts_with("ergebnis") ||
                key.starts_with("r\u00e9sultat") || key.starts_with("resultado") ||
                key.starts_with("risultato") || key == "step name") {
                name = fields[1];
            }
        }
    }
    return name;
}

Heading heading_of(const std::vector<TextRow>& rows) {
    Heading heading;
    std::optional<std::size_t> units;
    std::optional<std::size_t> names;
    for (std::size_t i = rows.size(); i-- > 0;) {
        if (!units && !names && is_unit_row(rows[i])) {
            units = i;
        } else if (rows[i].filled() >= 2) {
            names = i;
            break;
        } else if (units && rows[i].filled() == 1) {
            break;
        }
    }
    if (!names && !units) return heading;
    const std::size_t size =
        std::max(names ? rows[*names].fields.size() : 0, units ? rows[*units].fields.size() : 0);
    for (std::size_t i = 0; i < size; ++i) {
        const auto field = [&](const std::optional<std::size_t>& row) {
            return row && i < rows[*row].fields.size() ? rows[*row].fields[i] : std::string{};
        };
        ColumnHead head = split_head(field(names));
        // A row of units holds them all: a name in front of an empty one has none.
        if (const std::optional<std::string> unit = unit_text(field(units))) head.unit = *unit;
        heading.heads.push_back(std::move(head));
    }
    heading.name = interval_name(rows, names ? *names : *units);
    return heading;
}

/// A word of what rheometers export beside a flow curve, where no unit tells.
bool names_another_quantity(const std::string& name) {
    static constexpr std::array<std::string_view, 10> words = {"time",  "torque",    "temperature", "strain",
                                                               "modul", "force",     "frequen",     "speed",
                                                               "zeit",  "drehmoment"};
    const std::string text = lower_case(name);
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

/// The same words in every column, "overload,overload": no columns are called so.
bool all_alike(const std::vector<ColumnHead>& heads) {
    std::set<std::string> names;
    std::size_t count = 0;
    for (const ColumnHead& head : heads) {
        if (head.name.empty()) continue;
        names.insert(head.name);
        ++count;
    }
    return count >= 2 && names.size() == 1;
}

/// Whether words below a table may be the heading of another one.
bool names_columns(const std::vector<ColumnHead>& heads) {
    const FlowColumns columns = find_flow_columns(heads);
    return columns.complete() || columns.oscillation ||
           std::any_of(heads.begin(), heads.end(), [](const ColumnHead& head) {
               return !head.unit.empty() || names_another_quantity(head.name);
           });
}

/// Reads line by line; a table begins with the first row of numbers below words.
class Reader {
  public:
    Reader(std::string_view text, const std::string& name, const RheometerReadOptions& options)
        : lines_(lines_of(text)), options_(options) {
        data_.file = name;
        const ColumnStyle style = detect_column_style(lines_);
        data_.separator = style.separator;
        data_.decimal_comma = style.decimal_comma;
    }

    RheometerData read() {
        for (std::size_t i = 0; i < lines_.size(); ++i) take_line(i + 1, lines_[i]);
        end_interval();
        finish();
        return std::move(data_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const {
        throw UsageError(data_.file + ": " + what, data_.file);
    }

    void take_line(std::size_t line, std::string_view text) {
        split_fields(text, data_.separator, fields_);
        std::size_t numbers = 0;
        std::size_t missing = 0;
        std::size_t words = 0;
        bool word_first = false;
        for (const std::string_view field : fields_) {
            if (field.empty()) continue;
            if (parse_field(field, data_.decimal_comma)) {
                ++numbers;
            } else if (is_missing(field)) {
                ++missing;
            } else {
                word_first = word_first || numbers + missing + words == 0;
                ++words;
            }
        }
        if (numbers + missing + words == 0) {
            blank_line_ = true;
            return;
        }
        const bool labelled = word_first && trimmed(fields_.front()).ends_with(':');
        const bool in_table = open_ && pending_.empty();
        const bool row =
            !labelled &&
            (numbers + missing >= 2 || (in_table && numbers + missing == 1 && fields_.size() >= 2)) &&
            (numbers > 0 || in_table) && numbers + missing + 1 >= words;
        if (!row) {
            TextRow words_row{.line = line, .fields = {}};
            for (const std::string_view field : fields_) words_row.fields.emplace_back(field);
            if (data_.separator == ' ') regroup(text, words_row);
            pending_.push_back(std::move(words_row));
            if (pending_.size() > most_pending)
                pending_.erase(pending_.begin(), pending_.begin() + most_pending / 2);
            return;
        }
        if (!pending_.empty() || !open_) begin_interval(line);
        blank_line_ = false;
        take_row(line);
    }

    /// Where blanks separate columns, names hold blanks too: two or more of them, or a bracket, end a name.
    void regroup(std::string_view text, TextRow& row) const {
        std::vector<std::string> names;
        std::string name;
        std::size_t blanks = 0;
        for (const char c : std::string(trimmed(text)) + "  ") {
            if (c == ' ' || c == '\t') {
                blanks += c == '\t' ? 2 : 1;
                const bool ended = !name.empty() && (blanks >= 2 || name.back() == ']' || name.back() == ')');
                if (ended) {
                    // "Shear rate [1/s]": the unit belongs to the name before it.
                    if (!names.empty() && (name.front() == '[' || name.front() == '(') && !is_unit_row(row)) {
                        names.back() += " " + name;
                    } else {
                        names.push_back(name);
                    }
                    name.clear();
                }
                continue;
            }
            if (!name.empty() && blanks == 1) name += ' ';
            blanks = 0;
            name += c;
        }
        if (names.size() >= 2) row.fields = names;
    }

    /// A line of as many words as there are columns names them, whatever separates the numbers.
    void split_names_at_blanks() {
        if (pending_.empty() || pending_.back().filled() != 1 || fields_.size() < 2) return;
        std::vector<std::string_view> words;
        for (const std::string& field : pending_.back().fields) {
            if (!field.empty()) split_fields(field, ' ', words);
        }
        if (words.size() != fields_.size() || words.front().starts_with('#')) return;
        std::vector<ColumnHead> heads;
        heads.reserve(words.size());
        for (const std::string_view word : words) heads.push_back(split_head(word));
        if (open_ && !names_columns(heads)) return;  // "manual stop" between the rows of two columns
        pending_.back().fields = {words.begin(), words.end()};
    }

    /// Words between the rows of a table that name no column: a row without a value, and the table goes on.
    [[nodiscard]] bool is_remark(const Heading& heading) const {
        if (!columns_.complete()) return false;
        return all_alike(heading.heads) || (!blank_line_ && !names_columns(heading.heads));
    }

    void begin_interval(std::size_t line) {
        split_names_at_blanks();
        Heading heading = heading_of(pending_);
        const bool continues = open_ && (heading.heads.empty() || is_remark(heading));
        if (continues) {
            for (const TextRow& row : pending_) drop("a line of words", row.line);
            pending_.clear();
            return;
        }
        end_interval();
        pending_.clear();
        open_ = true;
        heads_ = std::move(heading.heads);
        headless_ = heads_.empty();
        if (headless_) {
            if (fields_.size() == 2) heads_ = {{"first column", "1/s"}, {"second column", "Pa.s"}};
        }
        columns_ = find_flow_columns(heads_);
        if (headless_ && fields_.size() == 2) {
            columns_.rate = FlowColumn{.index = 0, .factor = 1.0, .label = "first column, in 1/s"};
            columns_.viscosity = FlowColumn{.index = 1, .factor = 1.0, .label = "second column, in Pa s"};
            columns_.stress.reset();
        }
        interval_ = {};
        interval_.name = heading.name;
        interval_.line = line;
        if (columns_.rate) interval_.rate = columns_.rate->label;
        if (columns_.viscosity) interval_.viscosity = columns_.viscosity->label;
        if (!columns_.viscosity && columns_.stress && columns_.rate) {
            interval_.viscosity = columns_.stress->label + " over " + columns_.rate->label;
        }
        if (!columns_.rate && columns_.stress && columns_.viscosity) {
            interval_.rate = columns_.stress->label + " over " + columns_.viscosity->label;
        }
        points_.clear();
        dropped_.clear();
        disagreements_ = comparisons_ = reversed_ = 0;
    }

    void drop(const std::string& reason, std::size_t line) {
        for (DroppedRows& rows : dropped_) {
            if (rows.reason != reason) continue;
            ++rows.count;
            return;
        }
        dropped_.push_back({.reason = reason, .count = 1, .first_line = line});
    }

    /// The value of a column in SI; none where the row has no number there.
    [[nodiscard]] std::optional<double> value(const std::optional<FlowColumn>& column) const {
        if (!column || column->index >= fields_.size()) return {};
        const std::optional<double> number = parse_field(fields_[column->index], data_.decimal_comma);
        return number ? std::optional(*number * column->factor) : std::nullopt;
    }

    void take_row(std::size_t line) {
        ++interval_.rows;
        if (!columns_.complete()) return;
        std::optional<double> rate = value(columns_.rate);
        std::optional<double> viscosity = value(columns_.viscosity);
        const std::optional<double> stress = value(columns_.stress);
        if (!columns_.viscosity && stress && rate && *rate != 0.0) viscosity = *stress / *rate;
        if (!columns_.rate && stress && viscosity && *viscosity != 0.0) rate = *stress / *viscosity;
        if (!rate) return drop("no number for the shear rate", line);
        if (!viscosity) return drop("no number for the viscosity", line);
        if (*rate < 0.0 && *viscosity > 0.0) {
            ++reversed_;
            rate = -*rate;
        }
        if (!(*rate > 0.0)) return drop("shear rate not above 0", line);
        if (!(*viscosity > 0.0)) return drop("viscosity not above 0", line);
        // Out of anything a rheometer measures; keeps every logarithm and power finite too.
        if (*rate < 1e-12 || *rate > 1e12 || *viscosity < 1e-12 || *viscosity > 1e15) {
            return drop("out of any rheometer's range", line);
        }
        if (stress && columns_.viscosity && columns_.rate) {
            ++comparisons_;
            disagreements_ += std::abs(*stress) > 0.0 &&
                                      std::abs(std::log(std::abs(*stress) / (*viscosity * *rate))) < agreement
                                  ? 0
                                  : 1;
        }
        std::optional<double> temperature;
        if (columns_.temperature && *columns_.temperature < fields_.size()) {
            temperature = parse_field(fields_[*columns_.temperature], data_.decimal_comma);
        }
        points_.push_back({.rate = *rate,
                           .viscosity = *viscosity,
                           .line = line,
                           .interval = data_.intervals.size() + 1,
                           .temperature = temperature});
    }

    [[nodiscard]] std::string judge_interval() const {
        if (!columns_.complete()) {
            if (columns_.oscillation) return oscillatory;
            if (headless_) return std::to_string(fields_.size()) + " columns without names";
            std::string lacking =
                !columns_.rate ? "no column of shear rate" : "no column of viscosity or shear stress";
            return lacking + " among " + list_of_heads(heads_) + unknown_units(heads_) + logarithms(heads_);
        }
        if (points_.empty()) return "no usable row";
        const auto [low, high] = std::minmax_element(
            points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.rate < b.rate; });
        if (options_.intervals.empty() && high->rate < least_span * low->rate) {
            return points_.size() == 1 ? "a single point" : "the shear rate is constant";
        }
        return {};
    }

    void end_interval() {
        if (!open_) return;
        interval_.points = points_.size();
        interval_.skipped = judge_interval();
        const std::size_t number = data_.intervals.size() + 1;
        const bool wanted = options_.intervals.empty() ||
                            std::find(options_.intervals.begin(), options_.intervals.end(), number) !=
                                options_.intervals.end();
        if (interval_.skipped.empty() && !wanted) interval_.skipped = not_asked_for;
        const bool lacks_columns = !columns_.complete() && !columns_.oscillation;
        if (lacks_columns && options_.intervals.empty() && !data_.points.empty()) {
            add_remark("interval " + std::to_string(number) + " from line " + std::to_string(interval_.line) +
                       " is left out: " + interval_.skipped +
                       "; if its rows belong to the curve above, delete the words before them");
        }
        if (interval_.skipped.empty()) {
            data_.points.insert(data_.points.end(), points_.begin(), points_.end());
            merge_dropped();
            for (const std::string& remark : columns_.remarks) add_remark(remark);
            if (headless_) {
                add_remark("two columns without names: taken as shear rate in 1/s and viscosity in Pa s");
            }
            if (reversed_ > 0) {
                add_remark(std::to_string(reversed_) + (reversed_ == 1 ? " row turns" : " rows turn") +
                           " backwards (negative shear rate): taken as positive");
            }
            if (2 * disagreements_ > comparisons_) {
                add_remark("the viscosity is not shear stress over shear rate (columns " +
                           in_quotes(columns_.viscosity->label) + ", " + in_quotes(columns_.stress->label) +
                           ", " + in_quotes(columns_.rate->label) + "): check the units");
            }
        }
        data_.intervals.push_back(std::move(interval_));
        open_ = false;
    }

    void add_remark(const std::string& remark) {
        auto& all = data_.remarks;
        if (std::find(all.begin(), all.end(), remark) == all.end()) all.push_back(remark);
    }

    void merge_dropped() {
        for (const DroppedRows& rows : dropped_) {
            const auto same = std::find_if(data_.dropped.begin(), data_.dropped.end(),
                                           [&](const DroppedRows& d) { return d.reason == rows.reason; });
            if (same == data_.dropped.end()) {
                data_.dropped.push_back(rows);
            } else {
                same->count += rows.count;
            }
        }
    }

    [[nodiscard]] std::string list_of_intervals() const {
        std::string list;
        for (std::size_t i = 0; i < data_.intervals.size() && i < 12; ++i) {
            const RheometerInterval& interval = data_.intervals[i];
            list += (list.empty() ? "" : "; ") + std::to_string(i + 1) + " from line " +
                    std::to_string(interval.line);
            if (!interval.name.empty()) list += " (" + interval.name + ")";
            if (!interval.skipped.empty() && interval.skipped != not_asked_for)
                list += ": " + interval.skipped;
        }
        return list;
    }

    void finish() const {
        for (const std::size_t wanted : options_.intervals) {
            if (wanted <= data_.intervals.size() && data_.intervals[wanted - 1].skipped.empty()) continue;
            if (wanted > data_.intervals.size()) {
                const std::size_t count = data_.intervals.size();
                throw UsageError(
                    "--interval: got " + std::to_string(wanted) + ", but " + data_.file + " has " +
                        std::to_string(count) +
                        (count == 1 ? " interval alone; leave it out" : " intervals: " + list_of_intervals()),
                    "--interval");
            }
            throw UsageError("--interval: interval " + std::to_string(wanted) + " of " + data_.file +
                                 " is no flow curve: " + data_.intervals[wanted - 1].skipped,
                             "--interval");
        }
        if (!data_.points.empty()) return;
        if (std::all_of(lines_.begin(), lines_.end(), [](auto line) { return trimmed(line).empty(); })) {
            fail("is empty; a flow curve is at least two columns of numbers, shear rate and viscosity");
        }
        if (data_.intervals.empty()) {
            fail("no line holds two numbers; a flow curve is at least two columns, shear rate and viscosity");
        }
        if (data_.intervals.size() == 1) {
            const RheometerInterval& only = data_.intervals.front();
            const bool columns = only.rate.empty() || only.viscosity.empty();
            const bool oscillates = only.skipped == oscillatory;
            const bool unit = only.skipped.find(unit_not_known) != std::string::npos;
            const bool log = only.skipped.find(log_not_read) != std::string::npos;
            fail("line " + std::to_string(only.line) + ": " + only.skipped + dropped_reasons() +
                 (oscillates ? "; export a rotational test of viscosity over shear rate"
                  : log      ? "; export the quantity itself, or convert it, 10^x (e^x for ln)"
                  : unit     ? "; convert the column, to Pa.s, Pa or 1/s"
                  : columns  ? "; name the columns and their units in a line above, such as Shear rate [1/s] "
                               "and Viscosity [Pa.s]"
                             : "; a fit needs a curve over different shear rates"));
        }
        fail("no interval is a flow curve: " + list_of_intervals());
    }

    [[nodiscard]] std::string dropped_reasons() const {
        std::string text;
        for (const DroppedRows& rows : dropped_) {
            text += ", " + std::to_string(rows.count) + (rows.count == 1 ? " row with " : " rows with ") +
                    rows.reason + " (line " + std::to_string(rows.first_line) + ")";
        }
        return text;
    }

    static constexpr std::size_t most_pending = 400;
    static constexpr const char* oscillatory = "an oscillatory test, no flow curve";
    static constexpr const char* not_asked_for = "not asked for";
    std::vector<std::string_view> lines_;
    const RheometerReadOptions& options_;
    RheometerData data_;
    std::vector<std::string_view> fields_;
    std::vector<TextRow> pending_;
    bool open_ = false;
    bool headless_ = false;
    bool blank_line_ = false;  ///< since the last row
    std::vector<ColumnHead> heads_;
    FlowColumns columns_;
    RheometerInterval interval_;
    std::vector<MeasuredPoint> points_;
    std::vector<DroppedRows> dropped_;
    std::size_t comparisons_ = 0;
    std::size_t disagreements_ = 0;
    std::size_t reversed_ = 0;
};

}  // namespace

RheometerData read_rheometer_text(std::string_view text, const std::string& name,
                                  const RheometerReadOptions& options) {
    return Reader(text, name, options).read();
}

RheometerData read_rheometer_file(const std::string& path, const RheometerReadOptions& options) {
    const DecodedText decoded = read_text_file(path);
    RheometerData data = read_rheometer_text(decoded.text, path == "-" ? "standard input" : path, options);
    data.encoding = decoded.encoding;
    return data;
}

}  // namespace bioprint
