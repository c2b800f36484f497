#include <algorithm>
#include <cmath>
#include <numeric>

#include "rheology/law_model.hpp"

// Where fits begin: grids over what a flow curve can tell, each node with its best viscosity, sorted by the sum of the
// absolute residuals, which outliers cannot rule.

namespace bioprint {
namespace {

using Start = std::vector<double>;

struct Curve {
    std::vector<double> log_rate;
    std::vector<double> log_viscosity;
    double low = 0.0;
    double high = 0.0;
};

/// At most this many points decide about starts.
constexpr std::size_t enough_points = 24;
constexpr std::size_t starts_kept = 3;

Curve thinned_out(std::span<const FlowPoint> points) {
    std::vector<FlowPoint> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(),
              [](const FlowPoint& a, const FlowPoint& b) { return a.rate < b.rate; });
    Curve curve;
    const std::size_t step = std::max<std::size_t>(1, sorted.size() / enough_points);
    for (std::size_t i = 0; i < sorted.size(); i += step) {
        curve.log_rate.push_back(std::log(sorted[i].rate));
        curve.log_viscosity.push_back(std::log(sorted[i].viscosity));
    }
    curve.low = std::log(sorted.front().rate);
    curve.high = std::log(sorted.back().rate);
    return curve;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct Judged {
    Start theta;
    double cost;
};

/// Moves θ0, a factor of the viscosity where nothing is held, to the median; then the sum of the absolute residuals.
Judged judge(const LawModel& law, Start theta, const Curve& curve, bool level) {
    std::vector<double> residuals(curve.log_rate.size());
    const auto evaluate = [&] {
        for (std::size_t i = 0; i < residuals.size(); ++i) {
            residuals[i] = curve.log_viscosity[i] - law.at(theta, curve.log_rate[i]).log_viscosity;
        }
    };
    evaluate();
    if (level) {
        theta[0] += median(residuals);
        evaluate();
    }
    const double cost = std::accumulate(residuals.begin(), residuals.end(), 0.0,
                                        [](double sum, double r) { return sum + std::abs(r); });
    return {std::move(theta), cost};
}

std::vector<Start> best(std::vector<Judged> judged) {
    std::erase_if(judged, [](const Judged& j) { return !std::isfinite(j.cost); });
    std::sort(judged.begin(), judged.end(), [](const Judged& a, const Judged& b) { return a.cost < b.cost; });
    std::vector<Start> starts;
    for (const Judged& j : judged) {
        // Neighbours on the grid fall into the same minimum: the next start is one away from those kept.
        const bool near = std::any_of(starts.begin(), starts.end(), [&](const Start& other) {
            double distance = 0.0;
            for (std::size_t i = 1; i < other.size(); ++i) {
                distance = std::max(distance, std::abs(other[i] - j.theta[i]));
            }
            return distance < 0.9;
        });
        if (!near || starts.empty()) starts.push_back(j.theta);
        if (starts.size() == starts_kept) break;
    }
    return starts;
}

constexpr double step_time = 1.0;  // of ln K: what a minimum is wide

std::vector<Judged> plateau_grid(const LawModel& law, const Curve& curve) {
    const bool carreau = law.choice().law == FittedLaw::carreau_yasuda;
    const double lowest = *std::min_element(curve.log_viscosity.begin(), curve.log_viscosity.end());
    const std::vector<double> floors =
        law.choice().fit_eta_inf ? std::vector<double>{lowest - 0.2, lowest - 2.0} : std::vector<double>{0.0};
    const std::vector<double> corners =
        carreau ? std::vector<double>{0.5, 1.0, 2.0} : std::vector<double>{1.0};
    std::vector<Judged> judged;
    const double first = -curve.high - 2.0;
    const int times = 1 + static_cast<int>((3.0 - curve.low - first) / step_time);
    for (int i = 0; i < times; ++i) {
        const double time = first + i * step_time;
        for (const double thinning : {0.15, 0.35, 0.55, 0.75, 0.95, 1.4}) {
            for (const double corner : corners) {
                for (const double floor : floors) {
                    // θ0 must be near already where a floor makes it more than a factor.
                    const double y = thinning * std::max(0.0, time + curve.low);
                    Start theta = {curve.log_viscosity.front() + y, time, std::log(thinning)};
                    if (carreau) {
                        theta[2] = std::log(corner);
                        theta.push_back(std::log(thinning));
                    }
                    if (law.choice().fit_eta_inf) theta.push_back(floor);
                    judged.push_back(judge(law, std::move(theta), curve, true));
                }
            }
        }
    }
    return judged;
}

/// Slope and offset of ln k + s L by the median over pairs (Theil and Sen).
struct Line {
    double offset;
    double slope;
};
Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> slopes;
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = i + 1; j < x.size(); ++j) {
            if (x[j] != x[i]) slopes.push_back((y[j] - y[i]) / (x[j] - x[i]));
        }
    }
    const double slope = slopes.empty() ? 0.0 : median(std::move(slopes));
    std::vector<double> offsets(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) offsets[i] = y[i] - slope * x[i];
    return {median(std::move(offsets)), slope};
}

double log_index(double slope) {
    return std::log(std::clamp(1.0 + slope, 0.02, 3.0));
}

std::vector<Judged> yield_starts(const LawModel& law, const Curve& curve) {
    double least = curve.log_viscosity.front() + curve.log_rate.front();
    for (std::size_t i = 0; i < curve.log_rate.size(); ++i) {
        least = std::min(least, curve.log_viscosity[i] + curve.log_rate[i]);
    }
    std::vector<Judged> judged;
    for (const double share : {0.98, 0.9, 0.7, 0.4, 0.1, 0.01}) {
        const double yield = least + std::log(share);
        std::vector<double> x;
        std::vector<double> rest;
        for (std::size_t i = 0; i < curve.log_rate.size(); ++i) {
            const double excess = -std::expm1(yield - curve.log_viscosity[i] - curve.log_rate[i]);
            if (excess <= 0.01) continue;
            x.push_back(curve.log_rate[i]);
            rest.push_back(curve.log_viscosity[i] + std::log(excess));
        }
        if (x.size() < 2) continue;
        const Line line = line_through(x, rest);
        judged.push_back(judge(law, {yield, line.offset, log_index(line.slope)}, curve, false));
    }
    return judged;
}

}  // namespace

std::vector<std::vector<double>> LawModel::starts(std::span<const FlowPoint> points) const {
    const Curve curve = thinned_out(points);
    switch (choice_.law) {
        case FittedLaw::newtonian:
            return {{median(curve.log_viscosity)}};
        case FittedLaw::power_law: {
            const Line line = line_through(curve.log_rate, curve.log_viscosity);
            return {{line.offset, log_index(line.slope)}};
        }
        case FittedLaw::herschel_bulkley:
            return best(yield_starts(*this, curve));
        case FittedLaw::cross:
        case FittedLaw::carreau_yasuda:
            return best(plateau_grid(*this, curve));
    }
    return {};
}

}  // namespace bioprint
