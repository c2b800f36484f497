#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bioprint/simulate/snapshot.hpp"
#include "simulate/keeper.hpp"

/// What a scene in three dimensions shares with whoever runs it.
namespace bioprint {

inline constexpr const char* cancelled_run = "the simulation was cancelled";

/// A scene calls both at every sample, between two whole steps of its lattice, so that a state kept there is
/// all it needs to go on to the same numbers.
struct SceneWatch {
    std::function<bool(const char* stage, double fraction)> progress = {};  ///< false ends the run
    /// Keeps the state of a stage when it is time to, or when the stage is `finished`.
    std::function<void(const char* stage, bool finished, const std::function<Record()>& state)> keep = {};
    /// Hands out a picture when the stage has come far enough since the last one.
    std::function<void(const char* stage, double fraction, bool finished,
                       const std::function<SimulationSnapshot()>& take)>
        picture = {};
    /// What a run that is resumed had kept of a stage; null when nothing.
    std::function<const std::vector<double>*(const char* stage)> found = {};

    [[nodiscard]] bool goes_on(const char* stage, double fraction) const {
        return !progress || progress(stage, fraction);
    }
    void keep_state(const char* stage, bool finished, const std::function<Record()>& state) const {
        if (keep) {
            keep(stage, finished, state);
        }
    }
    void show(const char* stage, double fraction, bool finished,
              const std::function<SimulationSnapshot()>& take) const {
        if (picture) {
            picture(stage, fraction, finished, take);
        }
    }
    /// After each sample of a stage: a picture, the state, and whether the run goes on.
    [[nodiscard]] bool attend(const char* stage, double fraction, bool finished,
                              const std::function<SimulationSnapshot()>& take,
                              const std::function<Record()>& state) const {
        show(stage, fraction, finished, take);
        keep_state(stage, finished, state);
        return goes_on(stage, fraction);
    }
    [[nodiscard]] const std::vector<double>* kept(const char* stage) const {
        return found ? found(stage) : nullptr;
    }
};

}  // namespace bioprint
