#include "io/plot.hpp"

#include <algorithm>
#include <array>

#include "bioprint/errors.hpp"
#include "io/prediction_pictures.hpp"
#include "io/sweep_picture.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr std::array<std::string_view, 6> kinds = {"auto", "overview", "profile", "exit", "cell", "nomogram"};

}  // namespace

std::string_view plot_kinds() {
    return "auto, overview, profile, exit, cell or nomogram";
}

Canvas checked_canvas(const PlotQuestion& plot) {
    if (std::find(kinds.begin(), kinds.end(), plot.kind) == kinds.end()) {
        throw UsageError(
            "--plot-kind: got " + in_quotes(plot.kind) + "; it takes " + std::string(plot_kinds()),
            "--plot-kind");
    }
    if (plot.file == "-") return Canvas::terminal;
    const std::string name = lower_case(plot.file);
    if (name.ends_with(".svg")) return Canvas::svg;
    if (name.ends_with(".png")) return Canvas::png;
    if (name.ends_with(".pdf")) return Canvas::pdf;
    throw UsageError("--plot: got " + in_quotes(plot.file) +
                         "; it takes a file that ends in .svg, .png or .pdf, or - for the terminal",
                     "--plot");
}

Picture picture_of(const std::string& kind, const Sweep& sweep, const RunOptions& options, Canvas canvas) {
    if (!sweep.swept().empty()) {
        if (kind != "auto") {
            throw UsageError(
                "--plot-kind: a sweep has a picture of its own; leave out " + kind + ", or ask for one value",
                "--plot-kind");
        }
        return sweep_picture(sweep, options.paths, options.jobs);
    }
    const Case question = sweep.fixed().make_case();
    const PictureData data = picture_data(question);
    std::string chosen = kind;
    if (kind == "auto") {
        // A page of small panels is for paper; a terminal shows what matters most.
        chosen = question.profile_points > 0 ? "profile" : canvas == Canvas::terminal ? "exit" : "overview";
    }
    if (chosen == "profile") return profile_picture(data);
    if (chosen == "exit") return exit_picture(data);
    if (chosen == "cell") return cell_picture(data);
    if (chosen == "nomogram") return nomogram_picture(data, options.jobs);
    return overview_picture(data, options.jobs);
}

}  // namespace bioprint
