#pragma once

#include <string>
#include <string_view>

#include "io/gnuplot_script.hpp"
#include "io/prediction_pictures.hpp"

/// `--plot`: which picture a question gets, and its bytes.
namespace bioprint {

struct PlotQuestion {
    std::string file;           ///< its ending chooses the format; "-" draws in the terminal
    std::string kind = "auto";  ///< of plot_kinds()
};

/// "overview, profile, exit, cell or nomogram": what `--plot-kind` takes, beside auto, its default.
std::string_view plot_kinds();

/// @throws UsageError  the file's ending is not one of svg, png, pdf, or the kind is not known
Canvas checked_canvas(const PlotQuestion& plot);

/// What a picture in the terminal has room for.
CanvasSize terminal_size();

/// The picture of a sweep, which is of one kind.
/// @throws UsageError  another kind is asked for
Picture picture_of(const std::string& kind, Picture sweep);
/// That of a question.
Picture picture_of(const std::string& kind, const PictureData& data, unsigned jobs, Canvas canvas);

}  // namespace bioprint
