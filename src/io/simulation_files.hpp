#pragma once

#include <string>

#include "bioprint/simulate/simulation.hpp"
#include "io/run_directory.hpp"

/// What a simulation leaves in its run's directory.
///
///   checkpoint.cbor  while it runs and after it
///   series.csv       the series of the answer
///   answer.json      once it has come to its end
namespace bioprint {

class SimulationFiles {
  public:
    /// @param interval  between checkpoints [s]
    /// @throws DataError  the checkpoint is damaged
    SimulationFiles(RunDirectory& directory, double interval);
    SimulationFiles(const SimulationFiles&) = delete;
    SimulationFiles& operator=(const SimulationFiles&) = delete;

    /// Lets a simulation keep its state here and go on from it.
    void attach(SimulationOptions& options);
    void write_series(const SimulationSeries& series) const;
    void write_answer(const std::string& json) const;

  private:
    void write(const char* name, const std::string& text) const;

    RunDirectory& directory_;
    double interval_;
    SimulationState state_;
    bool resumes_ = false;
};

}  // namespace bioprint
