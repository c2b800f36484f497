#include <algorithm>
#include <cmath>
#include <limits>

#include "bioprint/errors.hpp"
#include "bioprint/io/presets.hpp"
#include "io/parallel.hpp"
#include "io/prediction_pictures.hpp"
#include "io/table.hpp"

// Stress over flow rate for the needles of one kind.

namespace bioprint {
namespace {

constexpr std::size_t points_a_curve = 25;
constexpr std::size_t most_needles = 9;
constexpr double decades_each_side = 1.5;

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

std::vector<double> flow_rates(double around) {
    std::vector<double> rates;
    for (std::size_t i = 0; i < points_a_curve; ++i) {
        const double step = 2.0 * static_cast<double>(i) / (points_a_curve - 1) - 1.0;
        rates.push_back(around * std::pow(10.0, decades_each_side * step));
    }
    return rates;
}

Panel nomogram_panel(const char* title, const std::vector<double>& rates) {
    return {.title = title,
            .x = {.title = "flow rate",
                  .dimension = Dimension::volume_flow,
                  .logarithmic = true,
                  .min = rates.front() / 2.0,
                  .max = rates.back()},
            .y = {.title = "stress", .dimension = Dimension::pressure, .logarithmic = true}};
}

void add_curve(Panel& panel, const std::vector<double>& rates, std::vector<double> stress,
               const std::string& name, bool own) {
    // At the left end, where the curves lie farthest apart.
    for (std::size_t i = 0; i < rates.size(); ++i) {
        if (!std::isfinite(stress[i])) continue;
        panel.labels.push_back({.x = rates[i] / 1.08, .y = stress[i], .text = name, .anchor = Anchor::right});
        break;
    }
    panel.series.push_back({.title = own ? "this nozzle" : "",
                            .x = rates,
                            .y = std::move(stress),
                            .style = 0,
                            .mark = own ? Mark::line : Mark::faint});
}

}  // namespace

Picture nomogram_picture(const PictureData& data, unsigned jobs) {
    const Case& question = data.question;
    const double own_rate = data.prediction.nozzle.flow_rate;
    const std::vector<NozzlePreset> needles = needles_near(question);
    const std::vector<double> rates = flow_rates(own_rate);
    std::vector<NomogramPoint> points((needles.size() + 1) * rates.size());
    for_each_index(points.size(), jobs, [&](std::size_t i) {
        const std::size_t needle = i / rates.size();
        const double radius = needle < needles.size() ? needles[needle].radius : question.radius;
        points[i] = point_of(question, radius, rates[i % rates.size()]);
    });

    Panel wall = nomogram_panel("Ink: stress at the wall of the nozzle", rates);
    Panel cell = nomogram_panel("Centred cell: largest stress at the exit", rates);
    for (std::size_t n = 0; n <= needles.size(); ++n) {
        const bool own = n == needles.size();
        std::vector<double> at_wall;
        std::vector<double> of_cell;
        for (std::size_t i = 0; i < rates.size(); ++i) {
            at_wall.push_back(points[n * rates.size() + i].wall_stress);
            of_cell.push_back(points[n * rates.size() + i].cell_stress);
        }
        const std::string name = own ? "" : std::to_string(needles[n].gauge) + "G";
        add_curve(wall, rates, std::move(at_wall), name, own);
        add_curve(cell, rates, std::move(of_cell), name, own);
    }
    const NomogramPoint own = point_of(question, question.radius, own_rate);
    wall.series.push_back(
        {.title = "this print", .x = {own_rate}, .y = {own.wall_stress}, .style = 2, .mark = Mark::points});
    cell.series.push_back(
        {.title = "this print", .x = {own_rate}, .y = {own.cell_stress}, .style = 2, .mark = Mark::points});
    const std::string kind =
        needles.empty() ? "needles" : std::string(tip_name(needles.front().tip)) + " needles";
    return {.name = "nomogram",
            .title = picture_title(data),
            .caption =
                "The same ink and cell in " + kind +
                " (grey, by gauge) and in the nozzle asked for (black) over the flow rate; the triangle is "
                "this print.",
            .rows = {{.panels = {std::move(wall), std::move(cell)}, .height = 440}}};
}

}  // namespace bioprint
