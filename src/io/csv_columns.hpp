#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/answer_object.hpp"

/// The columns of an answer in CSV: the answer's paths with the unit behind, `nozzle.stress_max [Pa]`.
///
/// Columns stay where they are whatever a row's answer: what it does not have is an empty cell. Left out are what is
/// the same in every row (schema, program) and lists whose length is the user's (offsets: see the cells).
namespace bioprint {

/// How to write numbers and separate cells.
struct CsvStyle {
    char separator = ',';
    bool decimal_comma = false;
};

class CsvColumns {
  public:
    /// @param cell_entries  entries of `cells` to provide columns for
    explicit CsvColumns(std::size_t cell_entries);

    /// Names with units, in order.
    [[nodiscard]] const std::vector<std::string>& headers() const { return headers_; }
    /// Appends the cells of an answer or refusal to `line`, each preceded by a separator unless it is the first of
    /// the line.
    void append(const Json& answer, CsvStyle style, std::string& line) const;

  private:
    void add(const std::string& path);
    std::vector<std::vector<std::string>> paths_;
    std::vector<std::string> headers_;
};

/// True for every header any answer could have: a second run over its own output replaces these.
bool is_answer_header(std::string_view header);

/// Appends text as one CSV cell: quoted where needed; text that a spreadsheet would run as a formula is disarmed.
void append_csv_text(std::string_view text, char separator, std::string& line);

}  // namespace bioprint
