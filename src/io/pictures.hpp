#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bioprint/predict/comparison.hpp"
#include "io/answer_object.hpp"
#include "io/picture.hpp"
#include "io/plot.hpp"
#include "io/run.hpp"
#include "io/sweep_values.hpp"
#include "io/whole_file.hpp"

/// `--plot` and `--report`: made when their data are known, put in their places after the answer.
namespace bioprint {

struct PicturesQuestion {
    std::optional<PlotQuestion> plot;
    std::optional<std::string> report;  ///< a file
    std::vector<std::string> call;      ///< the words of the command line, for the report
};

class Pictures {
  public:
    /// Finds out before anything is computed whether they can be made and written.
    /// @param sweep  the question, or several; must outlive this
    /// @throws DataError   no gnuplot for a plot, or a place that cannot be written
    /// @throws UsageError  more rows than a report holds
    Pictures(PicturesQuestion question, const Sweep& sweep, const Sink& notice);

    /// Makes what was asked for when `options.seen` gets the answer to a question, `options.row_seen` those to the
    /// rows of a sweep. What cannot be drawn is refused here.
    void draw(RunOptions& options);
    /// The same of a question with its simulation.
    /// @param answer  with the simulation in it
    void draw(const Prediction& prediction, const Comparison& comparison, const Json& answer);
    /// Draws what is still to be drawn, so that it can fail before any file is in its place. Rows of a sweep that were
    /// answered in an earlier run are answered again.
    void finish();
    /// Writes them.
    void commit();

  private:
    [[nodiscard]] bool nothing_asked() const { return !question_.plot && !question_.report; }
    void watch_sweep(RunOptions& options);
    void draw_sweep();
    bool finished_ = false;
    void draw_question(const RunOptions& options, const Json& answer);
    void plot(const Picture& picture);

    PicturesQuestion question_;
    const Sweep& sweep_;
    bool can_draw_ = true;
    std::optional<SweepValues> values_;  ///< of a sweep that is drawn
    std::vector<Json> rows_;             ///< of a sweep that is reported
    Extras extras_;
    unsigned jobs_ = 1;
    std::optional<WholeFile> plot_file_;
    std::optional<WholeFile> report_file_;
    std::string plot_;
    std::string report_;
};

}  // namespace bioprint
