#include "io/plot.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "bioprint/errors.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

constexpr std::array<std::string_view, 6> kinds = {"auto", "overview", "profile", "exit", "cell", "nomogram"};

}  // namespace

std::string_view plot_kinds() {
    return "overview, profile, exit, cell or nomogram";  // and auto, which is what one gets without
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

CanvasSize terminal_size() {
    CanvasSize size;
    winsize window{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col >= 40 && window.ws_row >= 16) {
        size = {.columns = std::min<int>(window.ws_col - 1, 132), .lines = std::min(window.ws_row - 2, 32)};
    }
    return size;
}

Picture picture_of(const std::string& kind, Picture sweep) {
    if (kind == "auto") return sweep;
    throw UsageError(
        "--plot-kind: a sweep has a picture of its own; leave out " + kind + ", or ask for one value",
        "--plot-kind");
}

Picture picture_of(const std::string& kind, const PictureData& data, unsigned jobs, Canvas canvas) {
    std::string chosen = kind;
    if (kind == "auto") {
        // A page of small panels is for paper; a terminal shows what matters most.
        const bool profile = data.answer.is_object() && data.answer.contains("profile");
        chosen = profile ? "profile" : canvas == Canvas::terminal ? "exit" : "overview";
    }
    if (chosen == "profile") return profile_picture(data);
    if (chosen == "exit") return exit_picture(data);
    if (chosen == "cell") return cell_picture(data);
    if (chosen == "nomogram") return nomogram_picture(data, jobs);
    return overview_picture(data, jobs);
}

}  // namespace bioprint
