#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/io/quantity.hpp"
#include "io/table.hpp"

/// Conditions on an answer, `nozzle.stress_max<2kPa`: of `--check`, and the limits of a design.
///
///   EXPR = path ( "<" | "<=" | ">" | ">=" ) quantity
///
/// The path is one of the JSON answer or a short form (answer_path.hpp); the quantity has the dimension of
/// what stands there, a number alone is SI. A value that does not exist holds no condition.
namespace bioprint {

enum class Relation { less, at_most, greater, at_least };

struct Check {
    std::string text;  ///< as written
    std::string path;
    Relation relation;
    double limit;  ///< SI
    Dimension dimension;
};

/// @throws UsageError  names `option` and the path: no relation, no path, a quantity of another kind
Check parse_check(std::string_view text, std::string_view option);

bool needs_population(const std::vector<Check>& checks);

struct CheckResult {
    std::optional<double> value;
    std::optional<double> margin;  ///< how far the value is inside the limit, in its unit; negative: outside
    bool holds = false;
    bool foreign = false;  ///< no value, because the cell there, which has an answer, has no such quantity
};

/// What a missing answer gives: nothing holds.
std::vector<CheckResult> unanswered(const std::vector<Check>& checks);

/// "nozzle.stress_max<2kPa does not hold: 2.31 kPa, 310 Pa (15.5 %) above"
std::string sentence(const Check& check, const CheckResult& result);

/// Lines of a table: limit, value, margin, verdict.
std::string checks_section(const std::vector<Check>& checks, const std::vector<CheckResult>& results,
                           TableStyle style);

/// "<"
std::string_view symbol(Relation relation);
/// Whether the limit is one from above.
bool is_upper(Relation relation);

/// One word for a row of a sweep: "hold" or "FAIL"; empty without checks.
std::string verdict(const std::vector<CheckResult>& results);

/// Sums up the checks of many rows.
class CheckTally {
  public:
    explicit CheckTally(const std::vector<Check>& checks) : checks_(&checks), worst_(checks.size()) {}
    /// The results of the next row.
    void add(const std::vector<CheckResult>& results);
    [[nodiscard]] bool all_hold() const;
    /// A line for each check that does not hold in every row.
    [[nodiscard]] std::vector<std::string> lines() const;

  private:
    struct Worst {
        std::size_t failures = 0;
        std::size_t valueless = 0;
        std::size_t row = 0;
        CheckResult result;
    };
    const std::vector<Check>* checks_;
    std::vector<Worst> worst_;
    std::size_t rows_ = 0;
};

}  // namespace bioprint
