#pragma once

#include <string>
#include <string_view>

#include "io/gnuplot_script.hpp"
#include "io/run.hpp"
#include "io/sweep.hpp"

/// `--plot`: which picture a question gets, and its bytes.
namespace bioprint {

struct PlotQuestion {
    std::string file;           ///< its ending chooses the format; "-" draws in the terminal
    std::string kind = "auto";  ///< of plot_kinds()
};

/// "auto, overview, profile, exit, cell, nomogram": what `--plot-kind` takes.
std::string_view plot_kinds();

/// @throws UsageError  the file's ending is not one of svg, png, pdf, or the kind is not known
Canvas checked_canvas(const PlotQuestion& plot);

/// The picture of a question or sweep.
/// @throws UsageError  the kind does not fit the question
Picture picture_of(const std::string& kind, const Sweep& sweep, const RunOptions& options, Canvas canvas);

}  // namespace bioprint
