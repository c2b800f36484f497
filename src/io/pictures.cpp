#include "io/pictures.hpp"

#include "bioprint/errors.hpp"
#include "io/gnuplot.hpp"
#include "io/prediction_pictures.hpp"
#include "io/report.hpp"
#include "io/row_answer.hpp"
#include "io/simulation_picture.hpp"
#include "io/sweep_picture.hpp"
#include "numerics/parallel.hpp"

namespace bioprint {
namespace {

void require_reportable(const Sweep& sweep) {
    if (sweep.size() <= most_report_rows) return;
    throw UsageError("--report: the sweep has " + std::to_string(sweep.size()) +
                         " rows and a page holds at most " + std::to_string(most_report_rows) +
                         "; take a coarser step",
                     "--report");
}

std::string page(const std::vector<std::string>& call, Json answer, const std::vector<Picture>& pictures,
                 bool can_draw, unsigned jobs) {
    Report report{.call = call,
                  .answer = std::move(answer),
                  .figures = std::vector<ReportFigure>(pictures.size()),
                  .no_figures = {}};
    if (!can_draw) report.no_figures = "There are no pictures here, because gnuplot was not installed.";
    for_each_index(pictures.size(), jobs, [&](std::size_t i) {
        report.figures[i] = {.caption = pictures[i].caption, .svg = bioprint::draw(pictures[i], Canvas::svg)};
    });
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

void Pictures::draw(RunOptions& options) {
    if (nothing_asked()) return;
    if (!sweep_.swept().empty()) return watch_sweep(options);
    options.seen = [this, options](const Json& answer) { draw_question(options, answer); };
}

void Pictures::watch_sweep(RunOptions& options) {
    extras_ = options.extras;
    jobs_ = options.jobs;
    if (can_draw_) {
        values_.emplace(sweep_, options);
        (void)sweep_picture(sweep_, *values_);  // refuses what it cannot draw
    }
    if (question_.report) rows_.resize(sweep_.size());
    options.row_seen = [this](std::size_t row, const Json& answer) {
        if (values_) values_->take(row, answer);
        if (!rows_.empty()) rows_[row] = answer;
    };
}

void Pictures::finish() {
    if (nothing_asked() || sweep_.swept().empty()) return;
    std::vector<Picture> pictures;
    if (values_) {
        values_->complete();
        pictures = {sweep_picture(sweep_, *values_)};
    }
    if (question_.plot) plot(picture_of(question_.plot->kind, pictures.front()));
    if (!question_.report) return;
    for_each_index(rows_.size(), jobs_, [&](std::size_t i) {
        if (rows_[i].is_null()) rows_[i] = answer_row([&] { return sweep_.row(i); }, extras_).object;
    });
    Json rows = Json::array();
    for (Json& row : rows_) rows.push_back(std::move(row));
    report_ = page(question_.call, std::move(rows), pictures, can_draw_, jobs_);
}

void Pictures::draw_question(const RunOptions& options, const Json& answer) {
    const Case question = sweep_.fixed().make_case();
    if (question_.plot) {
        const PictureData data = picture_data(question, answer);
        plot(picture_of(question_.plot->kind, data, options.jobs, checked_canvas(*question_.plot)));
    }
    if (!question_.report) return;
    std::vector<Picture> pictures;
    if (can_draw_ && answer.at("nozzle").at("velocity_average").get<double>() > 0.0) {
        const PictureData data = picture_data(question, answer);
        pictures = {cell_picture(data), exit_picture(data), profile_picture(data),
                    nomogram_picture(data, options.jobs)};
    }
    report_ = page(question_.call, answer, pictures, can_draw_, options.jobs);
}

void Pictures::draw(const Prediction& prediction, const Comparison& comparison, const Json& answer) {
    if (nothing_asked()) return;
    const PictureData data = picture_data(prediction.question, answer);
    const Picture course = simulation_picture(data, comparison);
    if (question_.plot) plot(course);
    if (!question_.report) return;
    std::vector<Picture> pictures;
    if (can_draw_) pictures = {course, cell_picture(data), exit_picture(data), profile_picture(data)};
    report_ = page(question_.call, answer, pictures, can_draw_, 2);
}

void Pictures::plot(const Picture& picture) {
    plot_ = bioprint::draw(picture, checked_canvas(*question_.plot), terminal_size());
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
