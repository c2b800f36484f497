#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "io/answer_object.hpp"
#include "io/csv_columns.hpp"
#include "io/run.hpp"

/// The text of one row among many: JSON, JSON Lines, CSV or the values of `--get`.
namespace bioprint {

struct RowText {
    std::string text;
    bool refused = false;
    ExtraResults extras;
    std::vector<bool> absent = {};  ///< as ValuesLine
};

/// The answer of a row, or the refusal in its place; never throws for what is the row's own fault.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON does not throw
struct RowAnswer {
    Json object;
    bool refused = false;
    ExtraResults extras;
};
/// @param answer  in place of `predict`
/// @throws UsageError  a check at a place that no answer has
RowAnswer answer_row(const std::function<Settings()>& question, const Extras& extras = {},
                     const std::function<Json(const Settings&)>& answer = {});

/// Adds to a refusal what it was asked, where an answer has it: a velocity or a pressure in `nozzle`, all else in `input`.
void add_question(Json& refusal, const Settings& asked);

/// The values at `paths`, one line, separated by tabs; `null` for what this answer lacks and others may have, as a
/// refusal lacks all but its `id`, its error and the swept values.
struct ValuesLine {
    std::string text;
    std::vector<bool> absent;  ///< of each path, whether this answer has no such place; empty for a refusal
};
/// @throws UsageError  a path that no answer has
ValuesLine values_line(const RowAnswer& answer, const std::vector<std::string>& paths);

/// Counts over many rows which paths none of them has.
class PathTally {
  public:
    explicit PathTally(const std::vector<std::string>& paths)
        : paths_(paths), present_(paths.size(), false) {}
    void add(const std::vector<bool>& absent);
    /// Says it of each path that no answered row had; nothing where none was answered.
    void say(const Sink& notice) const;

  private:
    const std::vector<std::string>& paths_;
    std::vector<bool> present_;
    std::size_t rows_ = 0;
};

/// Rows computed between two writes: enough for all threads, small enough that memory does not grow with the
/// rows.
inline constexpr std::size_t chunk_rows = 2048;

/// A value alone: numbers in their shortest form, texts bare, lists and objects as JSON.
std::string value_text(const Json& value);

/// A CSV of our own: RFC 4180.
CsvDialect fresh_dialect();

/// Entries of `cells` a question with these settings can have.
std::size_t cell_entries(const Settings& settings);
/// And of the other parts; `passages` one a position, none by the steady theory alone.
AnswerShape shape_of(const Settings& settings);

class RowWriter {
  public:
    RowWriter(const RunOptions& options, const AnswerShape& shape);

    [[nodiscard]] std::string head() const;
    [[nodiscard]] std::string csv_row(const Json& answer) const;
    /// @param id  what the asker calls the row, a text or a number, given back with its answer or refusal; null for none
    [[nodiscard]] RowText answer(const std::function<Settings()>& question, const Json& id = nullptr) const;
    [[nodiscard]] RowText written(const RowAnswer& answer) const;
    /// A row's text with what separates it from the row before.
    [[nodiscard]] std::string placed(const std::string& text, std::size_t index) const;
    [[nodiscard]] std::string tail() const;

  private:
    const RunOptions& options_;
    CsvColumns columns_;
};

}  // namespace bioprint
