#include "io/sweep_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/sweep_title.hpp"

namespace bioprint {
namespace {

constexpr std::size_t most_rows = 10000;
constexpr std::size_t most_marked_points = 16;
constexpr double decades_want_logarithm = 50.0;  // largest over smallest value

std::string value_label(const Settings& row, Key key) {
    const KeyInfo& info = info_of(key);
    if (!info.dimension) return row.at(key).text;
    const LabNumber n = format_lab(row.at(key).number, *info.dimension);
    const std::string name = key == Key::alpha ? "α" : std::string(info.option);
    return name + " " + n.number + (n.unit.empty() ? "" : " " + n.unit);
}

/// The x axis, which is the quantity with the most values, and which rows make one line.
class Lines {
  public:
    explicit Lines(const Sweep& sweep) : sweep_(sweep), key_(sweep.swept().back()) {
        std::size_t most = 0;
        for (const Key key : sweep.swept()) {
            if (!info_of(key).dimension || values_of(key) < most) continue;
            most = values_of(key);
            key_ = key;
        }
        for (std::size_t i = 0; i < sweep.size(); ++i) add(i);
    }

    struct Line {
        std::string title;
        std::vector<std::size_t> rows;
        std::vector<double> x;
    };
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

    [[nodiscard]] Axis axis() const {
        const KeyInfo& info = info_of(key_);
        Axis axis{.title = key_ == Key::alpha ? "α, how strongly the ink thins" : std::string(info.option),
                  .dimension = info.dimension};
        for (std::size_t i = 0; i < names_.size(); ++i) {
            axis.names.emplace_back(static_cast<double>(i), names_[i]);
        }
        if (!names_.empty()) {
            axis.min = -0.5;
            axis.max = static_cast<double>(names_.size()) - 0.5;
            return axis;
        }
        const std::vector<double>& x = lines_.front().x;
        const auto [low, high] = std::minmax_element(x.begin(), x.end());
        axis.logarithmic = *low > 0.0 && *high / *low >= decades_want_logarithm;
        axis.min = *low;
        axis.max = *high;
        return axis;
    }

    [[nodiscard]] bool has_names() const { return !names_.empty(); }

  private:
    [[nodiscard]] std::size_t values_of(Key key) const {
        std::set<double> values;
        for (std::size_t i = 0; i < sweep_.size(); ++i) values.insert(sweep_.row(i).at(key).number);
        return values.size();
    }

    void add(std::size_t index) {
        const Settings row = sweep_.row(index);
        std::string title;
        for (const Key key : sweep_.swept()) {
            if (key != key_) title += (title.empty() ? "" : ", ") + value_label(row, key);
        }
        auto line =
            std::find_if(lines_.begin(), lines_.end(), [&](const Line& l) { return l.title == title; });
        if (line == lines_.end())
            line = lines_.insert(lines_.end(), Line{.title = title, .rows = {}, .x = {}});
        line->rows.push_back(index);
        line->x.push_back(info_of(key_).dimension ? row.at(key_).number : place_of(row.at(key_).text));
    }

    double place_of(const std::string& name) {
        const auto found = std::find(names_.begin(), names_.end(), name);
        const auto place = static_cast<double>(found - names_.begin());
        if (found == names_.end()) names_.push_back(name);
        return place;
    }

    const Sweep& sweep_;
    Key key_;
    std::vector<Line> lines_;
    std::vector<std::string> names_;
};

Series series_of(const Lines& lines, const Lines::Line& line, const SweepQuantity& quantity,
                 std::string title, int style) {
    std::vector<std::size_t> order(line.rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return line.x[a] < line.x[b]; });
    Series series{.title = std::move(title), .style = style};
    for (const std::size_t i : order) {
        series.x.push_back(line.x[i]);
        series.y.push_back(quantity.values[line.rows[i]]);
        if (quantity.low.empty()) continue;
        series.low.push_back(quantity.low[line.rows[i]]);
        series.high.push_back(quantity.high[line.rows[i]]);
    }
    series.mark = lines.has_names()                    ? Mark::points
                  : order.size() <= most_marked_points ? Mark::line_points
                                                       : Mark::line;
    return series;
}

void choose_logarithm(Panel& panel) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Series& series : panel.series) {
        for (const double y : series.y) {
            if (!std::isfinite(y)) continue;
            low = std::min(low, y);
            high = std::max(high, y);
        }
    }
    panel.y.logarithmic = low > 0.0 && high / low >= decades_want_logarithm;
}

/// One line in all: quantities of one unit share a panel.
std::vector<Panel> panels_by_unit(const Lines& lines, const std::vector<SweepQuantity>& quantities,
                                  bool named) {
    std::vector<Panel> panels;
    std::vector<std::optional<Dimension>> dimensions;
    for (const SweepQuantity& quantity : quantities) {
        auto place = std::find(dimensions.begin(), dimensions.end(), quantity.dimension);
        if (place == dimensions.end() || !quantity.dimension) {
            place = dimensions.insert(dimensions.end(), quantity.dimension);
            panels.push_back(
                {.title = "",
                 .x = lines.axis(),
                 .y = {.title = named ? std::string() : "stress", .dimension = quantity.dimension}});
        }
        Panel& panel = panels[static_cast<std::size_t>(place - dimensions.begin())];
        panel.series.push_back(series_of(lines, lines.lines().front(), quantity, quantity.title,
                                         static_cast<int>(panel.series.size())));
    }
    for (Panel& panel : panels) {
        if (!named) continue;
        panel.y.title = panel.series.size() == 1 ? panel.series.front().title : "value";
        if (panel.series.size() == 1) panel.series.front().title.clear();
    }
    return panels;
}

std::vector<Panel> panels_by_quantity(const Lines& lines, const std::vector<SweepQuantity>& quantities) {
    std::vector<Panel> panels;
    for (const SweepQuantity& quantity : quantities) {
        Panel panel{
            .title = "", .x = lines.axis(), .y = {.title = quantity.title, .dimension = quantity.dimension}};
        int style = 0;
        for (const Lines::Line& line : lines.lines()) {
            panel.series.push_back(series_of(lines, line, quantity, line.title, style++));
        }
        panels.push_back(std::move(panel));
    }
    return panels;
}

void require_few_lines(const std::vector<Panel>& panels) {
    for (const Panel& panel : panels) {
        if (panel.series.size() <= house_styles().size()) continue;
        throw UsageError("--plot: " + std::to_string(panel.series.size()) +
                             " lines in one panel, and at most " + std::to_string(house_styles().size()) +
                             " can be told apart; shorten a list or ask for fewer values",
                         "--plot");
    }
}

}  // namespace

Picture sweep_picture(const Sweep& sweep, const SweepValues& values) {
    if (sweep.size() > most_rows) {
        throw UsageError("--plot: the sweep has " + std::to_string(sweep.size()) + " rows and at most " +
                             std::to_string(most_rows) + " are drawn; take a coarser step",
                         "--plot");
    }
    const Lines lines(sweep);
    std::vector<Panel> panels = lines.lines().size() == 1
                                    ? panels_by_unit(lines, values.quantities(), values.named())
                                    : panels_by_quantity(lines, values.quantities());
    require_few_lines(panels);
    for (Panel& panel : panels) choose_logarithm(panel);
    Picture picture{
        .name = "sweep",
        .title = sweep_title(sweep),
        .subtitle = sweep_subtitle(sweep) + (values.spread() ? "; bars: 5 to 95 %" : ""),
        .caption = std::string("Each point is a prediction; a gap is a row without an answer.") +
                   (values.spread() ? " Bars: 5 to 95 % of the answers to the uncertain inputs." : ""),
        .rows = {}};
    for (std::size_t i = 0; i < panels.size(); i += 2) {
        PictureRow row{.panels = {std::move(panels[i])}, .height = panels.size() == 1 ? 480 : 400};
        if (i + 1 < panels.size()) row.panels.push_back(std::move(panels[i + 1]));
        picture.rows.push_back(std::move(row));
    }
    return picture;
}

}  // namespace bioprint
