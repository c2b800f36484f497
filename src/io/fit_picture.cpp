#include "io/fit_picture.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

constexpr int points_a_curve = 121;
constexpr double beyond = 1.5;  ///< how far, as a factor, a curve goes on where nothing was measured
constexpr std::size_t most_laws = 5;
constexpr double residual_room = 1.3;

double value_of(const LawFit& fit, std::string_view name) {
    const FittedParameter* const parameter = fit.find(name);
    return parameter == nullptr ? 0.0 : parameter->value;
}

/// The law fitted, at a rate; formulas in rheology/flow_curve_fit.hpp.
double viscosity(const LawFit& fit, double rate) {
    const double eta0 = value_of(fit, "eta0");
    const double index = value_of(fit, "flow_index");
    const double reduced = value_of(fit, "time_constant") * rate;
    switch (fit.choice.law) {
        case FittedLaw::newtonian:
            return eta0;
        case FittedLaw::power_law:
            return value_of(fit, "consistency") * std::pow(rate, index - 1.0);
        case FittedLaw::cross:
            return fit.eta_inf + (eta0 - fit.eta_inf) / (1.0 + std::pow(reduced, value_of(fit, "alpha")));
        case FittedLaw::carreau_yasuda: {
            const double a = value_of(fit, "transition");
            return fit.eta_inf +
                   (eta0 - fit.eta_inf) * std::pow(1.0 + std::pow(reduced, a), (index - 1.0) / a);
        }
        case FittedLaw::herschel_bulkley:
            return value_of(fit, "yield_stress") / rate +
                   value_of(fit, "consistency") * std::pow(rate, index - 1.0);
    }
    return 0.0;
}

/// The law chosen first, then the best of all, then the best fit by each other law.
std::vector<const LawFit*> shown_laws(const FitAnswer& answer) {
    std::vector<const LawFit*> laws = {&answer.chosen};
    for (const LawFit& fit : answer.fit.laws) {
        const bool there = std::any_of(laws.begin(), laws.end(), [&](const LawFit* other) {
            return other->choice.law == fit.choice.law;
        });
        const bool best = &fit == &answer.fit.laws.front() && !(fit.choice == answer.chosen.choice);
        if ((best || !there) && laws.size() < most_laws) laws.push_back(&fit);
    }
    return laws;
}

/// As the table of the laws compared calls it.
std::string name_of(const LawFit& fit) {
    return std::string(law_name(fit.choice.law)) + (fit.choice.fit_eta_inf ? ", eta_inf fitted" : "");
}

std::string law_title(const LawFit& fit, const LawFit& chosen) {
    std::string title = name_of(fit);
    if (&fit == &chosen || !fit.aicc || !chosen.aicc) return title;
    const double more = *fit.aicc - *chosen.aicc;
    return title + " (AICc " + (more < 0.0 ? "-" : "+") + bare_text(std::abs(more), 2) + ")";
}

Axis rate_axis(const FitAnswer& answer) {
    double low = answer.rate_low;
    double high = answer.rate_high;
    for (const FitPoint& point : answer.points) {
        low = std::min(low, point.rate);
        high = std::max(high, point.rate);
    }
    return {.title = "shear rate",
            .dimension = Dimension::rate,
            .logarithmic = true,
            .min = low / beyond,
            .max = high * beyond};
}

template <class Value>
void add_points(Panel& panel, const FitAnswer& answer, const Value& value) {
    Series used{.title = "measured", .style = 0, .mark = Mark::points};
    Series outliers{.title = "left out as outliers", .mark = Mark::crosses};
    for (const FitPoint& point : answer.points) {
        Series& series = point.used ? used : outliers;
        series.x.push_back(point.rate);
        series.y.push_back(value(point));
    }
    panel.series.push_back(std::move(used));
    if (!outliers.x.empty()) panel.series.push_back(std::move(outliers));
}

Panel curve_panel(const FitAnswer& answer) {
    const std::size_t outliers = answer.points.size() - answer.fit.points_used;
    std::string data = std::to_string(answer.fit.points_used) + " points";
    if (outliers > 0) data += ", " + std::to_string(outliers) + " left out";
    if (answer.temperature) data += ", at " + bare_text(*answer.temperature, 3) + " °C";
    data += "; scatter " + bare_text(100.0 * answer.chosen.scatter, 2) + " %";
    Panel panel{.title = "Viscosity: " + data,
                .x = rate_axis(answer),
                .y = {.title = "viscosity", .dimension = Dimension::viscosity, .logarithmic = true}};
    const double low = *panel.x.min;
    const double step = std::log(*panel.x.max / low) / (points_a_curve - 1);
    int style = 0;
    for (const LawFit* const fit : shown_laws(answer)) {
        Series curve{.title = law_title(*fit, answer.chosen), .style = style++};
        for (int i = 0; i < points_a_curve; ++i) {
            const double rate = low * std::exp(step * i);
            curve.x.push_back(rate);
            curve.y.push_back(viscosity(*fit, rate));
        }
        panel.series.push_back(std::move(curve));
    }
    add_points(panel, answer, [](const FitPoint& point) { return point.measured; });
    return panel;
}

/// The residuals of the points in use decide the scale; an outlier beyond it is not drawn.
Panel residual_panel(const FitAnswer& answer) {
    Panel panel{.title = "Residuals: measured over fitted less 1 (" + name_of(answer.chosen) + ")",
                .x = rate_axis(answer),
                .y = {.title = "residual [%]"}};
    const auto percent = [](const FitPoint& point) { return 100.0 * std::expm1(point.residual()); };
    double largest = 0.0;
    for (const FitPoint& point : answer.points) {
        if (point.used) largest = std::max(largest, std::abs(percent(point)));
    }
    const double reach = std::max(residual_room * largest, 1e-6);
    panel.y.min = -reach;
    panel.y.max = reach;
    add_points(panel, answer, percent);
    for (Series& series : panel.series) series.title.clear();
    panel.series.push_back({.x = {*panel.x.min, *panel.x.max}, .y = {0.0, 0.0}, .mark = Mark::faint});
    const double scatter = 100.0 * std::expm1(answer.chosen.scatter);
    Series band{.title = "scatter of a point",
                .x = {*panel.x.min, *panel.x.max},
                .y = {0.0, 0.0},
                .low = {-scatter, -scatter},
                .high = {scatter, scatter},
                .style = 1,
                .mark = Mark::band};
    panel.series.insert(panel.series.begin(), std::move(band));
    return panel;
}

}  // namespace

Picture fit_picture(const FitAnswer& answer) {
    return {.name = "fit",
            .title = answer.name + ": " + name_of(answer.chosen),
            .subtitle = not_predicted(answer.chosen).empty() ? fit_options_line(answer)
                                                             : "no prediction takes this ink",
            .caption = "The flow curve with the laws fitted to it; below, what the law chosen leaves over.",
            .rows = {{.panels = {curve_panel(answer)}, .height = 460},
                     {.panels = {residual_panel(answer)}, .height = 260}},
            .one_x = true};
}

}  // namespace bioprint
