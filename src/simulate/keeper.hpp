#pragma once

#include <array>
#include <chrono>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "bioprint/simulate/simulation.hpp"

/// Checkpoints: what each stage has reached, collected from the runs of one simulation and handed out now and
/// then.
namespace bioprint {

/// A list of numbers written and read in the same order.
class Record {
  public:
    Record() = default;
    explicit Record(std::vector<double> values) : values_(std::move(values)) {}
    void put(double value) { values_.push_back(value); }
    void put(std::span<const double> values) {
        put(static_cast<double>(values.size()));
        values_.insert(values_.end(), values.begin(), values.end());
    }
    /// @throws DataError  the record is shorter than what is read from it
    double next();
    std::span<const double> next_list();
    std::array<double, 3> next_three();
    [[nodiscard]] const std::vector<double>& values() const { return values_; }

  private:
    std::vector<double> values_;
    std::size_t at_ = 0;
};

class Keeper {
  public:
    Keeper(const Scene& scene, const SimulationOptions& options);

    /// Replaces what is known of a stage; hands everything out when it is `due`.
    void put(const std::string& stage, const Record& record, bool due);
    /// Hands everything out once more, when all stages are finished.
    void close();
    /// Time spent so far, with that of the runs this one goes on from [s].
    [[nodiscard]] double elapsed() const;
    /// What the simulation that is resumed knew of a stage; null when nothing.
    [[nodiscard]] const std::vector<double>* found(const std::string& stage) const;

  private:
    const SimulationOptions& options_;
    void hand_out();

    std::mutex mutex_;
    SimulationState state_;
    double before_ = 0.0;  ///< [s]
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace bioprint
