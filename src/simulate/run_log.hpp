#pragma once

#include <atomic>
#include <vector>

#include "bioprint/simulate/simulation.hpp"

/// What the stages of one run share: progress, cancellation, the count of work, and what has been found so
/// far.
namespace bioprint {

class RunLog {
  public:
    RunLog(const SimulationOptions& options, bool reports) : options_(options), reports_(reports) {}

    void count(long steps, double nodes) {
        result.steps += steps;
        updates += static_cast<double>(steps) * nodes;
    }
    void progress(const char* stage, double done) const {
        if (reports_ && options_.progress) {
            options_.progress({.stage = stage, .done = done});
        }
    }
    [[nodiscard]] bool cancelled() const {
        return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
    }
    [[noreturn]] void stop(const std::string& reason) const { throw SimulationIncomplete(reason, result); }
    void stop_if_cancelled() const {
        if (cancelled()) {
            stop("the simulation was cancelled");
        }
    }
    void value(const char* name, double value) {
        result.values.push_back({.name = name, .value = value, .error = 0.0, .resolved = value});
    }
    void warn(const char* code, const std::string& message) {
        result.warnings.push_back({.code = code, .message = message});
    }
    [[nodiscard]] const SimulationOptions& options() const { return options_; }

    SimulationResult result;
    double updates = 0.0;

  private:
    const SimulationOptions& options_;
    bool reports_;
};

}  // namespace bioprint
