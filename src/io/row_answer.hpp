#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "io/answer_object.hpp"
#include "io/csv_columns.hpp"
#include "io/run.hpp"

/// The text of one row among many: JSON, JSON Lines, CSV or the values of `--get`.
namespace bioprint {

struct RowText {
    std::string text;
    bool refused = false;
};

/// The answer of a row, or the refusal in its place; never throws for what is the row's own fault.
struct RowAnswer {
    Json object;
    bool refused = false;
};
RowAnswer answer_row(const std::function<Settings()>& question);

/// A value alone: numbers in their shortest form, texts bare, lists and objects as JSON.
std::string value_text(const Json& value);

/// Entries of `cells` a question with these settings can have.
std::size_t cell_entries(const Settings& settings);

class RowWriter {
  public:
    RowWriter(const RunOptions& options, std::size_t cell_entries);

    [[nodiscard]] std::string head() const;
    [[nodiscard]] RowText answer(const std::function<Settings()>& question) const;
    /// A row's text with what separates it from the row before.
    [[nodiscard]] std::string placed(std::string text, std::size_t index) const;
    [[nodiscard]] std::string tail() const;

  private:
    const RunOptions& options_;
    CsvColumns columns_;
};

}  // namespace bioprint
