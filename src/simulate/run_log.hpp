#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <string>
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
            Record record = state();
            record.put(static_cast<double>(film_.index));
            record.put(film_.next);
            keeper_.put(name_ + stage, record, due);
        }
        if (due) {
            kept_ = std::chrono::steady_clock::now();
        }
    }
    [[nodiscard]] const std::vector<double>* found(const char* stage) {
        const std::vector<double>* values = keeper_.found(name_ + stage);
        if (values != nullptr && values->size() >= 2) {
            film_ = {.stage = stage,
                     .index = static_cast<int>(*(values->end() - 2)),
                     .next = *(values->end() - 1)};
        }
        return values;
    }
    /// Hands out a snapshot when the stage has come another share of its way, or is at its end. `take` makes it, but
    /// for its number and stage.
    template <class Take>
    void picture(const char* stage, double done, bool ended, const Take& take) {
        if (!reports_ || !options_.snapshot || options_.snapshots < 1) {
            return;
        }
        if (film_.stage != stage) {
            film_.stage = stage;
            film_.next = 0.0;
        }
        if (done < film_.next && !ended) {
            return;
        }
        film_.next = (std::floor(done * options_.snapshots) + 1.0) / options_.snapshots;
        SimulationSnapshot snapshot = take();
        snapshot.index = film_.index++;
        snapshot.stage = stage;
        options_.snapshot(snapshot);
    }
    [[nodiscard]] const SimulationOptions& options() const { return options_; }

    SimulationResult result;
    double updates = 0.0;

  private:
    struct Film {
        std::string stage;
        int index = 0;      ///< of the next picture
        double next = 0.0;  ///< share of the stage at which it is due
    };

    const SimulationOptions& options_;
    Keeper& keeper_;
    std::string name_;
    bool reports_;
    Film film_;
    std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
};

}  // namespace bioprint
