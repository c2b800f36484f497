#include "io/pictures.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "bioprint/errors.hpp"
#include "io/gnuplot.hpp"
#include "io/parallel.hpp"
#include "io/prediction_pictures.hpp"
#include "io/report.hpp"
#include "io/row_answer.hpp"
#include "io/simulated_answer.hpp"
#include "io/simulation_picture.hpp"
#include "io/sweep_picture.hpp"

namespace bioprint {
namespace {

/// What a picture in the terminal has room for.
CanvasSize canvas_size() {
    CanvasSize size;
    winsize window{};
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0 && window.ws_col >= 40 && window.ws_row >= 16) {
        size = {.columns = std::min<int>(window.ws_col - 1, 132), .lines = std::min(window.ws_row - 2, 32)};
    }
    return size;
}

void require_reportable(const Sweep& sweep) {
    if (sweep.size() <= most_report_rows) return;
    throw UsageError("--report: the sweep has " + std::to_string(sweep.size()) +
                         " rows and a page holds at most " + std::to_string(most_report_rows) +
                         "; take a coarser step",
                     "--report");
}

Json rows_of(const Sweep& sweep, unsigned jobs) {
    std::vector<Json> rows(sweep.size());
    for_each_index(rows.size(), jobs,
                   [&](std::size_t i) { rows[i] = answer_row([&] { return sweep.row(i); }).object; });
    Json array = Json::array();
    for (Json& row : rows) array.push_back(std::move(row));
    return array;
}

std::string page(const std::vector<std::string>& call, Json answer, const std::vector<Picture>& pictures,
                 bool can_draw) {
    Report report{.call = call, .answer = std::move(answer), .figures = {}, .no_figures = {}};
    if (!can_draw) report.no_figures = "There are no pictures here, because gnuplot was not installed.";
    for (const Picture& picture : pictures) {
        report.figures.push_back({.caption = picture.caption, .svg = bioprint::draw(picture, Canvas::svg)});
    }
    return report_html(report);
}

}  // namespace

Pictures::Pictures(PicturesQuestion question, const Sweep& sweep, const Sink& notice)
    : question_(std::move(question)), sweep_(sweep) {
    if (question_.plot) {
        require_gnuplot("--plot");
        plot_file_.emplace(question_.plot->file);
    }
    if (!question_.report) return;
    require_reportable(sweep_);
    report_file_.emplace(*question_.report);
    can_draw_ = gnuplot_installed();
    if (!can_draw_) {
        notice("the report has no pictures, because gnuplot is not installed; apt-get install gnuplot-nox");
    }
}

void Pictures::draw(const RunOptions& options) {
    if (question_.plot) {
        plot(picture_of(question_.plot->kind, sweep_, options, checked_canvas(*question_.plot)));
    }
    if (!question_.report) return;
    std::vector<Picture> pictures;
    if (!sweep_.swept().empty()) {
        if (can_draw_) pictures = {sweep_picture(sweep_, options.paths, options.jobs)};
        report_ = page(question_.call, rows_of(sweep_, options.jobs), pictures, can_draw_);
        return;
    }
    const Case question = sweep_.fixed().make_case();
    const Prediction prediction = predict(question);
    if (can_draw_ && prediction.nozzle.velocity_average > 0.0) {
        const PictureData data = picture_data(question);
        pictures = {cell_picture(data), exit_picture(data), profile_picture(data),
                    nomogram_picture(data, options.jobs)};
    }
    report_ = page(question_.call, answer_object(prediction), pictures, can_draw_);
}

void Pictures::draw(const Prediction& prediction, const Comparison& comparison,
                    const SimulationQuestion& simulation) {
    if (nothing_asked()) return;
    const PictureData data = picture_data(prediction.question);
    const Picture course = simulation_picture(data, comparison);
    if (question_.plot) plot(course);
    if (!question_.report) return;
    std::vector<Picture> pictures;
    if (can_draw_) pictures = {course, cell_picture(data), exit_picture(data), profile_picture(data)};
    report_ = page(question_.call, simulated_answer_object(prediction, comparison, simulation), pictures,
                   can_draw_);
}

void Pictures::plot(const Picture& picture) {
    plot_ = bioprint::draw(picture, checked_canvas(*question_.plot), canvas_size());
}

void Pictures::commit() {
    if (plot_file_ && !plot_.empty()) {
        plot_file_->write(plot_);
        plot_file_->commit();
    }
    if (report_file_ && !report_.empty()) {
        report_file_->write(report_);
        report_file_->commit();
    }
}

}  // namespace bioprint
