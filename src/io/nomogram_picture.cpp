#include <algorithm>
#include <cmath>
#include <limits>

#include "bioprint/errors.hpp"
#include "bioprint/io/presets.hpp"
#include "io/prediction_pictures.hpp"
#include "io/table.hpp"
#include "numerics/parallel.hpp"

// Stress over flow rate for the needles of one kind.

namespace bioprint {
namespace {

constexpr std::size_t points_a_curve = 9;  // at low flow rates a point takes some 5 ms
constexpr std::size_t points_of_own = 17;
constexpr std::size_t most_needles = 9;
constexpr double decades_each_side = 1.5;
constexpr double room_for_names = 2.6;  ///< a factor of the flow rate

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct NomogramPoint {
    double wall_stress = nothing;
    double cell_stress = nothing;
};

NomogramPoint point_of(const Case& like, double radius, double flow_rate) {
    Case question = like;
    question.radius = radius;
    question.length.reset();
    question.drive = Drive::flow_rate;
    question.drive_value = flow_rate;
    question.positions = {{.value = 0.0}};
    question.needle.reset();
    question.population = false;
    question.thresholds.clear();
    question.profile_points = 0;
    try {
        const Prediction prediction = predict(question);
        return {.wall_stress = prediction.nozzle.stress_max,
                .cell_stress = exit_stress(prediction).value_or(nothing)};
    } catch (const Error&) {
        return {};  // no steady flow, or the cell does not fit: the curve ends
    }
}

/// The needles of the question's kind whose bore is nearest to its own, wide to narrow.
std::vector<NozzlePreset> needles_near(const Case& question) {
    std::string_view kind = "steel";
    for (const NozzlePreset& nozzle : nozzle_presets()) {
        if (question.needle && nozzle.name == question.needle->name) kind = tip_name(nozzle.tip);
    }
    std::vector<NozzlePreset> needles;
    for (const NozzlePreset& nozzle : nozzle_presets()) {
        if (tip_name(nozzle.tip) == kind) needles.push_back(nozzle);
    }
    const auto distance = [&](const NozzlePreset& n) {
        return std::abs(std::log(n.radius / question.radius));
    };
    std::sort(needles.begin(), needles.end(), [&](const auto& a, const auto& b) {
        return distance(a) != distance(b) ? distance(a) < distance(b) : a.gauge < b.gauge;
    });
    if (needles.size() > most_needles) needles.resize(most_needles);
    std::sort(needles.begin(), needles.end(),
              [](const auto& a, const auto& b) { return a.radius > b.radius; });
    return needles;
}

std::vector<double> flow_rates(double around, std::size_t count) {
    std::vector<double> rates;
    for (std::size_t i = 0; i < count; ++i) {
        const double step = 2.0 * static_cast<double>(i) / static_cast<double>(count - 1) - 1.0;
        rates.push_back(around * std::pow(10.0, decades_each_side * step));
    }
    return rates;
}

Panel nomogram_panel(const char* title, const std::vector<double>& rates) {
    return {.title = title,
            .x = {.title = "flow rate",
                  .dimension = Dimension::volume_flow,
                  .logarithmic = true,
                  .min = rates.front() / room_for_names,
                  .max = rates.back() * room_for_names},
            .y = {.title = "stress", .dimension = Dimension::pressure, .logarithmic = true}};
}

void add_curve(Panel& panel, const std::vector<double>& rates, std::vector<double> stress, bool own) {
    panel.series.push_back({.title = own ? "this nozzle" : "",
                            .x = rates,
                            .y = std::move(stress),
                            .style = 0,
                            .mark = own ? Mark::line : Mark::faint});
}

/// The first or the last value of a curve; not a number where it has none.
double end_of(const Series& curve, bool at_front) {
    return at_front ? curve.y.front() : curve.y.back();
}

/// Names the curves at the end where they lie farther apart, and leaves out a name that would cover another.
void name_curves(Panel& panel, const std::vector<NozzlePreset>& needles, const std::vector<double>& rates) {
    const auto apart = [&](bool at_front) {
        double low = std::numeric_limits<double>::infinity();
        double high = 0.0;
        for (const Series& curve : panel.series) {
            const double value = end_of(curve, at_front);
            if (!(value > 0.0)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
        return high > 0.0 ? high / low : 0.0;
    };
    const bool at_front = apart(true) >= apart(false);
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;
    for (const Series& curve : panel.series) {
        for (const double value : curve.y) {
            if (!(value > 0.0)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    constexpr double lines_in_panel = 20.0;
    const double line = high > low ? std::pow(high / low, 1.2 / lines_in_panel) : 1.0;
    std::vector<double> taken;
    for (std::size_t n = 0; n < needles.size(); ++n) {
        const double value = end_of(panel.series[n], at_front);
        const bool free = value > 0.0 && std::none_of(taken.begin(), taken.end(), [&](double other) {
                              return std::max(value / other, other / value) < line;
                          });
        if (!free) continue;
        taken.push_back(value);
        panel.labels.push_back({.x = at_front ? rates.front() / 1.12 : rates.back() * 1.12,
                                .y = value,
                                .text = std::to_string(needles[n].gauge) + "G",
                                .anchor = at_front ? Anchor::right : Anchor::left});
    }
}

}  // namespace

Picture nomogram_picture(const PictureData& data, unsigned jobs) {
    const Case& question = data.question;
    const double own_rate = data.prediction.nozzle.flow_rate;
    const std::vector<NozzlePreset> needles = needles_near(question);
    const std::vector<double> rates = flow_rates(own_rate, points_a_curve);
    const std::vector<double> own_rates = flow_rates(own_rate, points_of_own);
    const std::size_t of_needles = needles.size() * rates.size();
    std::vector<NomogramPoint> points(of_needles + own_rates.size());
    for_each_index(points.size(), jobs, [&](std::size_t i) {
        points[i] = i < of_needles
                        ? point_of(question, needles[i / rates.size()].radius, rates[i % rates.size()])
                        : point_of(question, question.radius, own_rates[i - of_needles]);
    });

    Panel wall = nomogram_panel("Ink: stress at the wall of the nozzle", rates);
    Panel cell = nomogram_panel("Centred cell: largest stress at the exit", rates);
    for (std::size_t n = 0; n <= needles.size(); ++n) {
        const bool own = n == needles.size();
        const std::vector<double>& x = own ? own_rates : rates;
        std::vector<double> at_wall;
        std::vector<double> of_cell;
        for (std::size_t i = 0; i < x.size(); ++i) {
            at_wall.push_back(points[n * rates.size() + i].wall_stress);
            of_cell.push_back(points[n * rates.size() + i].cell_stress);
        }
        add_curve(wall, x, std::move(at_wall), own);
        add_curve(cell, x, std::move(of_cell), own);
    }
    name_curves(wall, needles, rates);
    name_curves(cell, needles, rates);
    const NomogramPoint& own = points[of_needles + points_of_own / 2];  // the middle one is this print
    const auto add_print = [&](Panel& panel, const std::string& path, double stress) {
        Series print{.title = "this print", .style = 2, .mark = Mark::points};
        add_point(print, data, path, own_rate, stress);
        if (!print.low.empty()) print.title += ", 5 to 95 %";
        panel.series.push_back(std::move(print));
    };
    add_print(wall, "nozzle.stress_max", own.wall_stress);
    add_print(cell, "cells.exit.stress.von_mises", own.cell_stress);
    const std::string kind =
        needles.empty() ? "needles" : std::string(tip_name(needles.front().tip)) + " needles";
    return {.name = "nomogram",
            .title = picture_title(data),
            .subtitle = picture_subtitle(data),
            .caption =
                "The same ink and cell in " + kind +
                " (grey, by gauge) and in the nozzle asked for (black) over the flow rate; the triangle is "
                "this print.",
            .rows = {{.panels = {std::move(wall), std::move(cell)}, .height = 440}}};
}

}  // namespace bioprint
