#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "io/run.hpp"
#include "io/run_directory.hpp"

/// The answers of a batch or sweep in its run's directory: `answers.unfinished` grows row by row; with the last row it
/// becomes answers.csv, .jsonl, .json or (values of `--get`) .txt. The checkpoint knows how many bytes of it are sure,
/// so that a run that goes on neither loses nor doubles a row.
namespace bioprint {

class KeptRows {
  public:
    /// @param interval  between checkpoints [s]
    /// @throws DataError  the checkpoint is damaged, or the file holds less than it says
    KeptRows(RunDirectory& directory, double interval);
    ~KeptRows();
    KeptRows(const KeptRows&) = delete;
    KeptRows& operator=(const KeptRows&) = delete;

    /// Where the run stands.
    [[nodiscard]] const RunResult& start() const { return start_; }
    [[nodiscard]] bool finished() const { return finished_; }

    /// @throws DataError  e.g. a full disk
    void write(std::string_view bytes);
    /// After whole rows: keeps what is there when it is time to, or when the run was interrupted.
    void keep(const RunResult& so_far);
    void finish(const RunResult& result);
    /// The file of a finished run.
    [[nodiscard]] std::string answers() const;

    /// Values of `--get` in place of answers.
    bool values = false;

  private:
    void open();
    void flush();
    void record(const RunResult& so_far);
    void put_in_place() const;
    [[noreturn]] void fail(const std::string& path) const;

    RunDirectory& directory_;
    std::chrono::duration<double> interval_;
    std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
    RunResult start_;
    bool finished_ = false;
    std::string pending_;
    double bytes_ = 0.0;  ///< written so far
    int file_ = -1;
};

}  // namespace bioprint
