#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "io/answer_object.hpp"
#include "io/run.hpp"
#include "io/sweep.hpp"

/// The numbers of a sweep that are drawn: those of `--get`, or else the stress at the wall and of the cells in
/// nozzle and at exit, and the spread of each where an uncertainty is asked for.
namespace bioprint {

/// One over all rows; not a number where a row has none.
struct SweepQuantity {
    std::string title;
    std::optional<Dimension> dimension;
    std::string path;  ///< in the answer
    std::vector<double> values = {};
    std::vector<double> low = {};  ///< 5 % of the spread; empty without an uncertainty
    std::vector<double> high = {};
};

class SweepValues {
  public:
    /// Answers rows until one has an answer, so that what cannot be drawn is refused before the rest.
    /// @param sweep  must outlive this
    /// @throws UsageError  a path that is no number; and what predict() throws when no row has an answer
    SweepValues(const Sweep& sweep, const RunOptions& options);

    /// What was answered to a row, a refusal too. From any thread, each row once.
    void take(std::size_t row, const Json& answer);

    /// Answers the rows that were not taken.
    void complete();

    [[nodiscard]] const std::vector<SweepQuantity>& quantities() const { return quantities_; }
    [[nodiscard]] bool named() const { return named_; }  ///< by `--get`
    [[nodiscard]] bool spread() const { return extras_.uncertainty.wanted; }

  private:
    void require_numbers() const;

    const Sweep& sweep_;
    Extras extras_;
    unsigned jobs_;
    const std::atomic<bool>* interrupted_;
    bool named_;
    std::vector<SweepQuantity> quantities_;
    std::vector<char> taken_;
};

}  // namespace bioprint
