#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/answer_object.hpp"
#include "io/csv.hpp"
#include "io/extras.hpp"

/// The columns of an answer in CSV: the answer's paths with the unit behind, `nozzle.stress_max [Pa]`.
///
/// Columns stay where they are whatever a row's answer: what it does not have is an empty cell. Left out are
/// what is the same in every row (schema, program) and lists whose length is the user's (offsets: see the
/// cells).
namespace bioprint {

/// What an answer has of the parts whose number of values is the question's.
struct AnswerShape {
    std::size_t cells;           ///< entries of `cells`
    bool population = false;     ///< whether there are columns for it
    std::size_t passages = 0;    ///< entries of `passages`
    std::size_t thresholds = 0;  ///< of the population
};

class CsvColumns {
  public:
    /// One name of a dotted path; a number is an index where the answer has a list.
    struct Step {
        std::string name;
        std::optional<std::size_t> index;
    };

    explicit CsvColumns(const AnswerShape& shape, const Extras& extras = {});

    [[nodiscard]] const AnswerShape& shape() const { return shape_; }
    /// Names with units, in order.
    [[nodiscard]] const std::vector<std::string>& headers() const { return headers_; }
    /// Writes the cells of an answer or refusal; what it does not have is an empty cell.
    void write(const Json& answer, CsvWriter& writer) const;

  private:
    void add(const std::string& path);
    AnswerShape shape_;
    std::vector<std::vector<Step>> paths_;
    std::vector<std::string> headers_;
};

/// True for every header any answer could have: a second run over its own output replaces these.
bool is_answer_header(std::string_view header);

}  // namespace bioprint
