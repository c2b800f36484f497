#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/answer_object.hpp"
#include "io/csv.hpp"

/// The columns of an answer in CSV: the answer's paths with the unit behind, `nozzle.stress_max [Pa]`.
///
/// Columns stay where they are whatever a row's answer: what it does not have is an empty cell. Left out are
/// what is the same in every row (schema, program) and lists whose length is the user's (offsets: see the
/// cells).
namespace bioprint {

class CsvColumns {
  public:
    /// One name of a dotted path; a number is an index where the answer has a list.
    struct Step {
        std::string name;
        std::optional<std::size_t> index;
    };

    /// @param cell_entries  entries of `cells` to provide columns for
    /// @param population    whether to provide columns for it
    /// @param passages      entries of `passages`
    CsvColumns(std::size_t cell_entries, bool population, std::size_t passages);

    [[nodiscard]] std::size_t cell_entries() const { return cell_entries_; }
    /// Names with units, in order.
    [[nodiscard]] const std::vector<std::string>& headers() const { return headers_; }
    /// Writes the cells of an answer or refusal; what it does not have is an empty cell.
    void write(const Json& answer, CsvWriter& writer) const;

  private:
    void add(const std::string& path);
    std::size_t cell_entries_;
    std::vector<std::vector<Step>> paths_;
    std::vector<std::string> headers_;
};

/// True for every header any answer could have: a second run over its own output replaces these.
bool is_answer_header(std::string_view header);

}  // namespace bioprint
