#include "bioprint/rheology/flow_curve_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "bioprint/errors.hpp"
#include "numerics/least_squares.hpp"
#include "rheology/law_model.hpp"

namespace bioprint {
namespace {

/// No rheometer repeats itself better than this; smaller residuals are not told apart by the search for outliers.
constexpr double smallest_scatter = 2e-3;
/// Rounding of the data and of the search: differences below say nothing about a law.
constexpr double rounding = 1e-7;
/// In standard deviations. Of normal points 1 in 16 000 lies farther out.
constexpr double outlier_reach = 4.0;
constexpr std::size_t fewest_rates = 3;
/// Above so many points the grid of starts goes over medians of neighbours; the fit itself takes every point.
constexpr std::size_t most_searched = 1000;
constexpr std::size_t condensed_points = 300;

const std::vector<LawChoice>& candidates() {
    static const std::vector<LawChoice> all = {
        {FittedLaw::newtonian, false},       {FittedLaw::power_law, false},
        {FittedLaw::cross, false},           {FittedLaw::cross, true},
        {FittedLaw::carreau_yasuda, false},  {FittedLaw::carreau_yasuda, true},
        {FittedLaw::herschel_bulkley, false}};
    return all;
}

void check(std::span<const FlowPoint> points) {
    for (const FlowPoint& p : points) {
        if (!(p.rate > 0.0 && p.viscosity > 0.0 && p.weight > 0.0 && std::isfinite(p.rate) &&
              std::isfinite(p.viscosity) && std::isfinite(p.weight))) {
            throw UsageError("a point of a flow curve must be positive and finite");
        }
    }
}

/// Of an even number the mean of the two in the middle: the upper one alone lies above a law by its scatter.
double median_of(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// The points in use, as the residuals of a law.
class Residuals {
  public:
    Residuals(std::span<const FlowPoint> points, const std::vector<bool>& used) {
        low_ = std::numeric_limits<double>::infinity();
        high_ = -low_;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double log_rate = std::log(points[i].rate);
            // Outliers count for the range a law is allowed in: what a fit of all points found stays allowed.
            low_ = std::min(low_, log_rate);
            high_ = std::max(high_, log_rate);
            if (used[i]) add(points[i]);
        }
    }
    /// Neighbours in rate as one point, the median of their logarithms, with the weight of all; none over a gap.
    [[nodiscard]] Residuals condensed() const {
        std::vector<std::size_t> order(size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return log_rate_[a] < log_rate_[b]; });
        const std::size_t group = (size() + condensed_points - 1) / condensed_points;
        const double gap = (high_ - low_) / static_cast<double>(condensed_points);
        Residuals result;
        result.low_ = low_;
        result.high_ = high_;
        std::vector<double> rates;
        std::vector<double> viscosities;
        double weight = 0.0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const std::size_t at = order[i];
            rates.push_back(log_rate_[at]);
            viscosities.push_back(log_viscosity_[at]);
            weight += weights_[at];
            const bool ends = i + 1 == order.size() || rates.size() == group ||
                              log_rate_[order[i + 1]] - log_rate_[at] > gap;
            if (!ends) continue;
            result.add({.rate = std::exp(median_of(rates)),
                        .viscosity = std::exp(median_of(viscosities)),
                        .weight = weight});
            rates.clear();
            viscosities.clear();
            weight = 0.0;
        }
        return result;
    }
    [[nodiscard]] std::size_t size() const { return points_.size(); }
    [[nodiscard]] std::span<const FlowPoint> points() const { return points_; }
    [[nodiscard]] const std::vector<double>& weights() const { return weights_; }
    [[nodiscard]] std::size_t different_rates() const {
        std::vector<double> rates = log_rate_;
        std::sort(rates.begin(), rates.end());
        // Two settings of a rheometer that differ by less than 1 % are one.
        std::size_t count = rates.empty() ? 0 : 1;
        double last = rates.empty() ? 0.0 : rates.front();
        for (const double rate : rates) {
            if (rate - last <= 0.01) continue;
            ++count;
            last = rate;
        }
        return count;
    }

    template <typename Run>
    auto with(const LawModel& law, const Run& run) const {
        const auto evaluate = [&](std::span<const double> theta, std::span<double> residuals,
                                  std::span<double> jacobian) {
            if (!law.allows(theta, low_, high_)) {
                std::fill(residuals.begin(), residuals.end(), std::numeric_limits<double>::infinity());
                return;
            }
            const std::size_t p = law.parameters();
            for (std::size_t i = 0; i < points_.size(); ++i) {
                const LawValue v = law.at(theta, log_rate_[i]);
                if (!residuals.empty()) residuals[i] = v.log_viscosity - log_viscosity_[i];
                if (jacobian.empty()) continue;
                std::copy_n(v.gradient.begin(), p, jacobian.begin() + static_cast<std::ptrdiff_t>(i * p));
            }
        };
        return run(LeastSquaresModel{
            .points = points_.size(), .parameters = law.parameters(), .evaluate = evaluate});
    }

    [[nodiscard]] std::vector<double> residuals(const LawModel& law, std::span<const double> theta) const {
        std::vector<double> r(size());
        with(law, [&](const LeastSquaresModel& model) { model.evaluate(theta, r, {}); });
        return r;
    }

  private:
    Residuals() = default;
    void add(const FlowPoint& point) {
        points_.push_back(point);
        log_rate_.push_back(std::log(point.rate));
        log_viscosity_.push_back(std::log(point.viscosity));
        weights_.push_back(point.weight);
    }

    std::vector<FlowPoint> points_;
    std::vector<double> log_rate_;
    std::vector<double> log_viscosity_;
    std::vector<double> weights_;
    double low_ = 0.0;
    double high_ = 0.0;
};

double absolute_sum(const LeastSquaresFit& fit, const std::vector<double>& weights) {
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        sum += std::sqrt(weights[i]) * std::abs(fit.residuals[i]);
    return sum;
}

/// The robust fit of a law from whichever start leads lowest; none where no start can be evaluated.
std::optional<LeastSquaresFit> robust_fit(const LawModel& law, const Residuals& data) {
    std::optional<LeastSquaresFit> best;
    double least = 0.0;
    for (const std::vector<double>& start : law.starts(data.points())) {
        try {
            LeastSquaresFit fit = data.with(law, [&](const LeastSquaresModel& model) {
                return fit_robustly(model, start, data.weights(), smallest_scatter);
            });
            const double sum = absolute_sum(fit, data.weights());
            if (best && sum >= least) continue;
            least = sum;
            best = std::move(fit);
        } catch (const NotConverged&) {
            continue;  // a start outside what the law allows
        }
    }
    return best;
}

bool enough_points(const LawModel& law, const Residuals& data) {
    return data.size() > law.parameters() && data.different_rates() >= law.parameters();
}

std::vector<double> standardised(const LeastSquaresFit& fit, const std::vector<double>& weights) {
    std::vector<double> r(fit.residuals);
    for (std::size_t i = 0; i < r.size(); ++i) r[i] *= std::sqrt(weights[i]);
    return r;
}

struct Robust {
    LawModel law;
    LeastSquaresFit fit;
};

/// Points too far from the law that follows most points best, judged by the scatter of the others.
std::vector<bool> find_outliers(const Robust& robust, const Residuals& data) {
    const std::vector<double> r = standardised(robust.fit, data.weights());
    const std::size_t p = robust.law.parameters();
    double scale = robust_scale(r, p);
    std::vector<bool> used(r.size(), true);
    for (int round = 0; round < 20; ++round) {
        const double reach = outlier_reach * std::max(scale, smallest_scatter);
        std::vector<bool> next(r.size());
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < r.size(); ++i) {
            next[i] = std::abs(r[i]) <= reach;
            if (!next[i]) continue;
            sum += r[i] * r[i];
            ++count;
        }
        if (count <= p || (round > 0 && next == used)) break;
        used = next;
        scale = std::max(scale, std::sqrt(sum / static_cast<double>(count - p)));
    }
    return used;
}

double relative_variance(double variance) {
    return std::isfinite(variance) ? variance : 1e30;
}

/// Covariance of the reported logarithms.
std::vector<double> reported_covariance(const LeastSquaresFit& fit, std::span<const double> jacobian,
                                        std::size_t p) {
    std::vector<double> covariance(p * p, 0.0);
    for (std::size_t i = 0; i < p; ++i) {
        for (std::size_t j = 0; j < p; ++j) {
            for (std::size_t a = 0; a < p; ++a) {
                for (std::size_t b = 0; b < p; ++b) {
                    const double c = fit.covariance[a * p + b];
                    covariance[i * p + j] +=
                        jacobian[i * p + a] * jacobian[j * p + b] * (a == b ? relative_variance(c) : c);
                }
            }
        }
    }
    return covariance;
}

FittedParameter parameter(const ParameterShape& shape, double log_value, double error, double t) {
    // An interval past this is no knowledge, and its ends would leave double precision.
    constexpr double largest = 50.0;
    const bool known = std::isfinite(error) && t * error < largest;
    const double value = std::exp(log_value);
    const double infinity = std::numeric_limits<double>::infinity();
    const double low = known ? std::exp(log_value - t * error) : 0.0;
    const double high = known ? std::exp(log_value + t * error) : infinity;
    FittedParameter p{.name = shape.name,
                      .value = value,
                      .standard_error = std::isfinite(error) ? value * error : infinity,
                      .low = low,
                      .high = high,
                      .determined = known && 2.0 * t * error <= std::log(7.0)};
    if (shape.complement) {
        // What rounding leaves of 1 - 1 would be a flow index just below 0, which no prediction takes.
        constexpr double rounding_of_one = 1e-12;
        p.value = std::abs(1.0 - value) < rounding_of_one ? 0.0 : 1.0 - value;
        p.low = 1.0 - high;
        p.high = 1.0 - low;
    }
    return p;
}

double neighbour_correlation(const LeastSquaresFit& fit, const Residuals& data) {
    std::vector<std::size_t> order(data.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return data.points()[a].rate < data.points()[b].rate;
    });
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double r = fit.residuals[order[i]];
        square += r * r;
        if (i > 0) product += r * fit.residuals[order[i - 1]];
    }
    return square > 0.0 ? product / square : 0.0;
}

LawFit make_law_fit(const LawModel& law, const LeastSquaresFit& fit, const Residuals& data,
                    std::span<const FlowPoint> all, double held_eta_inf) {
    const std::size_t p = law.parameters();
    const auto n = static_cast<double>(data.size());
    const auto freedom = n - static_cast<double>(p);
    double total_weight = 0.0;
    for (const double w : data.weights()) total_weight += w;
    const double cost = std::max(fit.cost, n * rounding * rounding);
    const double k = static_cast<double>(p) + 1.0;  // the scatter is fitted too
    LawFit result{.choice = law.choice(),
                  .eta_inf = held_eta_inf,
                  .parameters = {},
                  .correlation = std::vector<double>(p * p, 0.0),
                  .fitted = {},
                  .scatter = std::sqrt(fit.cost / freedom),
                  .rms = std::sqrt(fit.cost / total_weight),
                  .aic = n * std::log(cost / n) + 2.0 * k,
                  .aicc = {},
                  .neighbour_correlation = neighbour_correlation(fit, data),
                  .converged = fit.converged};
    if (n - k - 1.0 > 0.0) result.aicc = result.aic + 2.0 * k * (k + 1.0) / (n - k - 1.0);

    std::vector<double> logs(p);
    std::vector<double> jacobian(p * p);
    law.report(fit.x, logs, jacobian);
    const std::vector<double> covariance = reported_covariance(fit, jacobian, p);
    const double t = student_t(0.975, freedom);
    for (std::size_t i = 0; i < p; ++i) {
        const double variance = covariance[i * p + i];
        const double error =
            variance < 1e20 ? result.scatter * std::sqrt(variance) : std::numeric_limits<double>::infinity();
        result.parameters.push_back(parameter(law.shapes()[i], logs[i], error, t));
        for (std::size_t j = 0; j < p; ++j) {
            const double c = covariance[i * p + j] / std::sqrt(variance * covariance[j * p + j]);
            // Fitted is ln(1 − n), which falls where n rises.
            const double sign = law.shapes()[i].complement == law.shapes()[j].complement ? 1.0 : -1.0;
            result.correlation[i * p + j] = std::isfinite(c) ? sign * c : 0.0;
        }
    }
    if (const FittedParameter* const floor = result.find("eta_inf")) result.eta_inf = floor->value;
    for (const FlowPoint& point : all) {
        result.fitted.push_back(std::exp(law.at(fit.x, std::log(point.rate)).log_viscosity));
    }
    return result;
}

double held_eta_inf(LawChoice choice, const FlowCurveFitOptions& options) {
    const bool plateau = choice.law == FittedLaw::cross || choice.law == FittedLaw::carreau_yasuda;
    return plateau && !choice.fit_eta_inf ? options.eta_inf : 0.0;
}

std::vector<Robust> robust_fits(const Residuals& data, const FlowCurveFitOptions& options) {
    const bool many = data.size() > most_searched;
    const Residuals searched = many ? data.condensed() : data;
    std::vector<Robust> fits;
    for (const LawChoice choice : candidates()) {
        const LawModel law(choice, held_eta_inf(choice, options));
        if (!enough_points(law, data)) continue;
        if (std::optional<LeastSquaresFit> fit = robust_fit(law, searched)) {
            if (many) fit->residuals = data.residuals(law, fit->x);
            fits.push_back({law, std::move(*fit)});
        }
    }
    return fits;
}

/// The law most points lie closest to, with the price of its parameters.
const Robust& closest(const std::vector<Robust>& fits, const Residuals& data) {
    const auto score = [&](const Robust& robust) {
        const double scale = robust_scale(standardised(robust.fit, data.weights()), robust.law.parameters());
        return static_cast<double>(data.size()) * std::log(std::max(scale, smallest_scatter)) +
               static_cast<double>(robust.law.parameters());
    };
    return *std::min_element(fits.begin(), fits.end(),
                             [&](const Robust& a, const Robust& b) { return score(a) < score(b); });
}

}  // namespace

const FittedParameter* LawFit::find(std::string_view name) const {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const FittedParameter& p) { return p.name == name; });
    return found == parameters.end() ? nullptr : &*found;
}

const LawFit* FlowCurveFit::find(LawChoice choice) const {
    const auto found =
        std::find_if(laws.begin(), laws.end(), [&](const LawFit& fit) { return fit.choice == choice; });
    return found == laws.end() ? nullptr : &*found;
}

FlowCurveFit fit_flow_curve(std::span<const FlowPoint> points, const FlowCurveFitOptions& options) {
    check(points);
    FlowCurveFit result{.laws = {}, .used = std::vector<bool>(points.size(), true)};
    if (points.empty()) throw UsageError("there is no point to fit");
    const Residuals everything(points, result.used);
    const std::size_t rates = everything.different_rates();
    if (rates < fewest_rates) {
        throw UsageError("there are points at " + std::to_string(rates) +
                         (rates == 1 ? " shear rate" : " shear rates") + " only; a fit needs " +
                         std::to_string(fewest_rates) + " different ones, better 10 over two decades");
    }
    const std::vector<Robust> fits = robust_fits(everything, options);
    if (fits.empty()) throw NotConverged("no law could be fitted to these points");
    result.used = find_outliers(closest(fits, everything), everything);
    const auto dropped = static_cast<double>(std::count(result.used.begin(), result.used.end(), false));
    const Residuals kept(points, result.used);
    if (dropped > options.outlier_share * static_cast<double>(points.size()) ||
        kept.different_rates() < fewest_rates) {
        result.outliers_kept = true;
        result.used.assign(points.size(), true);
    }
    const Residuals data(points, result.used);
    result.points_used = data.size();
    for (const Robust& robust : fits) {
        if (!enough_points(robust.law, data)) continue;
        const LeastSquaresFit fit = data.with(robust.law, [&](const LeastSquaresModel& model) {
            return fit_least_squares(model, robust.fit.x, data.weights());
        });
        result.laws.push_back(
            make_law_fit(robust.law, fit, data, points, held_eta_inf(robust.law.choice(), options)));
    }
    std::stable_sort(result.laws.begin(), result.laws.end(), [](const LawFit& a, const LawFit& b) {
        if (a.aicc && b.aicc) return *a.aicc < *b.aicc;
        return a.aicc.has_value() && !b.aicc;
    });
    return result;
}

CrossConsistency cross_consistency(const LawFit& cross) {
    const auto log_of = [&](std::string_view name) { return std::log(cross.find(name)->value); };
    const double alpha = cross.find("alpha")->value;
    const double log_k = log_of("time_constant");
    // ln m = ln η0 − α ln K; by ln η0, ln K, ln α:
    const std::array<double, 3> gradient = {1.0, -alpha, -alpha * log_k};
    const std::size_t p = cross.parameters.size();
    double variance = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const auto error = [&](std::size_t k) {
                return cross.parameters[k].standard_error / cross.parameters[k].value;
            };
            variance += gradient.at(i) * gradient.at(j) * cross.correlation[i * p + j] * error(i) * error(j);
        }
    }
    const double value = std::exp(log_of("eta0") - alpha * log_k);
    // What is left of variances that cancel is rounding where they are this large.
    constexpr double largest_relative_error = 1e5;
    bool known = std::isfinite(variance);
    for (std::size_t i = 0; i < 3; ++i) {
        const FittedParameter& parameter = cross.parameters[i];
        known = known && parameter.standard_error < largest_relative_error * parameter.value;
    }
    const double error =
        known ? value * std::sqrt(std::max(0.0, variance)) : std::numeric_limits<double>::infinity();
    return {.value = value, .standard_error = error};
}

}  // namespace bioprint
