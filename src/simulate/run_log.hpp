#pragma once

#include <atomic>
#include <chrono>
#include <vector>

#include "bioprint/simulate/simulation.hpp"
#include "simulate/keeper.hpp"

/// What the stages of one run share: progress, cancellation, the count of work, and what has been found so
/// far.
namespace bioprint {

class RunLog {
  public:
    RunLog(const SimulationOptions& options, Keeper& keeper, const char* name, bool reports)
        : options_(options), keeper_(keeper), name_(name), reports_(reports) {}

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
    [[noreturn]] void stop(const std::string& reason) const {
        SimulationResult partial = result;
        partial.wall_time = keeper_.elapsed();
        partial.updates_per_second = updates / partial.wall_time;
        throw SimulationIncomplete(reason, partial);
    }
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
    /// Keeps a stage's state when it is time to, when the run is cancelled, or when the stage is `finished`.
    /// Each of two runs at once has its own time: one that samples more often must not leave the other without.
    template <class State>
    void keep(const char* stage, bool finished, const State& state) {
        if (!options_.checkpoint) {
            return;
        }
        const std::chrono::duration<double> since = std::chrono::steady_clock::now() - kept_;
        const bool due = since.count() >= options_.checkpoint_interval || cancelled();
        if (due || finished) {
            keeper_.put(name_ + stage, state(), due);
        }
        if (due) {
            kept_ = std::chrono::steady_clock::now();
        }
    }
    [[nodiscard]] const std::vector<double>* found(const char* stage) const {
        return keeper_.found(name_ + stage);
    }
    [[nodiscard]] const SimulationOptions& options() const { return options_; }

    SimulationResult result;
    double updates = 0.0;

  private:
    const SimulationOptions& options_;
    Keeper& keeper_;
    std::string name_;
    bool reports_;
    std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
};

}  // namespace bioprint
