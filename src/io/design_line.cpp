#include "io/design_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bioprint/errors.hpp"
#include "bioprint/predict/prediction.hpp"
#include "io/answer_checks.hpp"

namespace bioprint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The smallest radius in which the cells asked for have room.
double narrowest(const Case& asked) {
    double room = asked.cell.radius;
    for (const CellPosition& position : asked.positions) {
        const double r = position.in_cell_radii ? position.value * asked.cell.radius : position.value;
        room = std::max(room, r + asked.cell.radius);
    }
    return room * (1.0 + 1e-9);
}

/// True when the limits ask of cells only for the one nearest to the axis at the exit.
bool one_cell_is_enough(const std::vector<Check>& limits) {
    return std::none_of(limits.begin(), limits.end(), [](const Check& limit) {
        return limit.path.starts_with("passages.") ||
               (limit.path.starts_with("cells.") && !limit.path.starts_with("cells.exit."));
    });
}

/// The others take most of the time of a prediction.
void keep_nearest_position(Case& asked) {
    if (asked.positions.empty()) {
        asked.positions = {{.value = 0.0}};  // the usual ones begin on the axis
        return;
    }
    const auto offset = [&](const CellPosition& p) {
        return p.in_cell_radii ? p.value * asked.cell.radius : p.value;
    };
    asked.positions = {
        *std::min_element(asked.positions.begin(), asked.positions.end(),
                          [&](const auto& a, const auto& b) { return offset(a) < offset(b); })};
}

}  // namespace

DesignLine::DesignLine(const DesignQuestion& question, const Settings& base, unsigned jobs)
    : question_(question), base_(base), jobs_(jobs) {
    const auto about = [&](std::string_view begin) {
        return std::any_of(question.limits.begin(), question.limits.end(),
                           [&](const Check& limit) { return limit.path.starts_with(begin); });
    };
    cells_ = about("cells.") || about("passages.");
    population_ = about("population.");
}

double DesignLine::place(double value) const {
    return question_.sought == Key::alpha ? value : std::log(value);
}

double DesignLine::value(double place) const {
    if (place == this->place(range_.first)) return range_.first;
    if (place == this->place(range_.second)) return range_.second;
    return question_.sought == Key::alpha ? place : std::exp(place);
}

const DesignLine::Point& DesignLine::at(double place) {
    const auto found = points_.find(place);
    if (found != points_.end()) return found->second;
    return points_.emplace(place, predicted(value(place))).first->second;
}

double DesignLine::excess(std::size_t limit, double place) {
    const Point& point = at(place);
    if (!point.answered) return -infinity;  // that is the business of the steady flow
    const CheckResult& result = point.results[limit];
    if (!result.value) return infinity;
    const Check& check = question_.limits[limit];
    const double sign = is_upper(check.relation) ? 1.0 : -1.0;
    const double raw =
        *result.value > 0.0 && check.limit > 0.0
            ? sign * std::log(*result.value / check.limit)
            : sign * (*result.value - check.limit) / (check.limit != 0.0 ? std::abs(check.limit) : 1.0);
    if (result.holds) return std::min(raw, 0.0);
    return std::max(raw, std::numeric_limits<double>::min());
}

DesignLine::Point DesignLine::predicted(double value) const {
    Case asked = with_value(base_, question_.sought, value).make_case();
    asked.transient = asked.transient && cells_;
    asked.population = population_;
    asked.profile_points = 0;
    if (one_cell_is_enough(question_.limits)) keep_nearest_position(asked);
    Point point;
    try {
        const Json answer = answer_object(predict(asked, jobs_));
        for (const Check& limit : question_.limits) {
            point.results.push_back(evaluate(limit, answer, "--limit", false));
        }
        point.answered = true;
    } catch (const NoSteadyFlow&) {
        point.results = unanswered(question_.limits);
    } catch (const NotConverged&) {
        point.results = unanswered(question_.limits);
    }
    return point;
}

double usual_value(const Case& asked, Key sought) {
    if (sought == Key::radius) return asked.radius;
    if (sought == Key::alpha) {
        if (const auto* cross = std::get_if<CrossInk>(&asked.ink.law)) return cross->alpha;
        throw UsageError(
            "--solve: alpha belongs to the Cross law and this ink is of another; seek a radius or a flow",
            "--solve");
    }
    Case flow = asked;
    flow.transient = false;
    flow.population = false;
    flow.profile_points = 0;
    const NozzleAnswer nozzle = predict(flow).nozzle;
    switch (sought) {
        case Key::flow_rate:
            return nozzle.flow_rate;
        case Key::velocity:
            return nozzle.velocity_average;
        case Key::pressure:
            return nozzle.pressure_drop.value_or(1e5);
        default:
            return nozzle.pressure_gradient;
    }
}

std::pair<double, double> default_range(const Case& asked, Key sought) {
    const double area = std::numbers::pi * asked.radius * asked.radius;
    switch (sought) {
        case Key::radius:
            return {narrowest(asked), std::max(5e-3, 2.0 * narrowest(asked))};
        case Key::flow_rate:
            return {1e-9 * area, 10.0 * area};
        case Key::velocity:
            return {1e-9, 10.0};
        case Key::pressure:
            return {1.0, 1e8};
        case Key::pressure_gradient:
            return {1.0, 1e12};
        default:
            return {0.0, 1.0};
    }
}

}  // namespace bioprint
