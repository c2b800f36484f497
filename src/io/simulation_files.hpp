#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "bioprint/simulate/simulation.hpp"
#include "io/run_directory.hpp"
#include "io/whole_file.hpp"

/// What a simulation leaves in its run's directory.
///
///   checkpoint.cbor  while it runs and after it
///   series.csv       the series of the answer
///   answer.json      once it has come to its end
///   cell.pvd, flow.pvd, frames/  pictures for ParaView (io/vtk.hpp)
namespace bioprint {

class SimulationFiles {
  public:
    /// @param interval  between checkpoints [s]
    /// @throws DataError  the checkpoint is damaged
    SimulationFiles(RunDirectory& directory, double interval);
    SimulationFiles(const SimulationFiles&) = delete;
    SimulationFiles& operator=(const SimulationFiles&) = delete;

    /// Lets a simulation keep its state here and go on from it.
    /// @param snapshots  pictures of each stage; 0: none
    void attach(SimulationOptions& options, int snapshots);
    void write_series(const SimulationSeries& series) const;
    /// The answer comes last: where it is, all is there.
    void write_answer(const std::string& json);

  private:
    void write(const std::string& name, const std::string& text,
               WholeFile::Sync sync = WholeFile::Sync::disk) const;
    void write_picture(const SimulationSnapshot& snapshot);
    void write_timelines(WholeFile::Sync sync) const;
    void write_frame(const std::string& name, const std::string& text);
    void sync_pictures();

    RunDirectory& directory_;
    double interval_;
    SimulationState state_;
    bool resumes_ = false;
    std::mutex lock_;                    // two runs of one simulation hand out their states
    std::vector<std::string> unsynced_;  ///< pictures that a power cut could still take
    std::vector<double> times_;          ///< of the pictures [s]
};

}  // namespace bioprint
