#include "bioprint/predict/population.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/errors.hpp"
#include "bioprint/predict/exit_passage.hpp"
#include "numerics/parallel.hpp"
#include "predict/exit_field.hpp"
#include "predict/streamline.hpp"

namespace bioprint {
namespace {

constexpr std::size_t rings = 4000;
constexpr double near_enough = 5e-4;  // of the two peaks where they change places

/// Cubic interpolation that keeps the data's monotony (Fritsch and Carlson 1980).
class Monotone {
  public:
    Monotone(std::vector<double> x, std::vector<double> y)
        : x_(std::move(x)), y_(std::move(y)), slope_(x_.size()) {
        const std::size_t n = x_.size();
        const auto chord = [&](std::size_t i) { return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]); };
        for (std::size_t i = 1; i + 1 < n; ++i) {
            const double a = chord(i - 1);
            const double b = chord(i);
            const double h0 = x_[i] - x_[i - 1];
            const double h1 = x_[i + 1] - x_[i];
            slope_[i] = a * b > 0.0 ? 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / a + (h1 + 2.0 * h0) / b) : 0.0;
        }
        slope_[0] = end_slope(x_[1] - x_[0], x_[2] - x_[1], chord(0), chord(1));
        slope_[n - 1] = end_slope(x_[n - 1] - x_[n - 2], x_[n - 2] - x_[n - 3], chord(n - 2), chord(n - 3));
    }

    [[nodiscard]] double operator()(double x) const {
        const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
        const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
        const double h = x_[i + 1] - x_[i];
        const double t = (x - x_[i]) / h;
        const double d = y_[i + 1] - y_[i];
        const double m = h * slope_[i];
        const double n = h * slope_[i + 1];
        return y_[i] + t * (m + t * (3.0 * d - 2.0 * m - n + t * (m + n - 2.0 * d)));
    }

  private:
    /// Slope of the parabola through three points at its end, kept from turning the data round.
    static double end_slope(double h0, double h1, double a, double b) {
        const double s = ((2.0 * h0 + h1) * a - h0 * b) / (h0 + h1);
        if (s * a <= 0.0) return 0.0;
        return std::abs(s) > 3.0 * std::abs(a) ? 3.0 * a : s;
    }

    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> slope_;
};

/// Values of the rings with their parts of the flux, which sum to 1.
class Weighted {
  public:
    explicit Weighted(std::vector<std::array<double, 2>> values) : values_(std::move(values)) {
        std::sort(values_.begin(), values_.end());
        double below = 0.0;
        for (const auto& [value, weight] : values_) {
            middle_.push_back(below + 0.5 * weight);
            below += weight;
            mean_ += value * weight;
        }
    }

    [[nodiscard]] double quantile(double part) const {
        const auto above = std::lower_bound(middle_.begin(), middle_.end(), part);
        if (above == middle_.begin()) return values_.front()[0];
        if (above == middle_.end()) return values_.back()[0];
        const auto i = static_cast<std::size_t>(above - middle_.begin());
        const double t = (part - middle_[i - 1]) / (middle_[i] - middle_[i - 1]);
        return values_[i - 1][0] + t * (values_[i][0] - values_[i - 1][0]);
    }

    [[nodiscard]] double share_above(double value) const {
        if (value < values_.front()[0]) return 1.0;
        if (value >= values_.back()[0]) return 0.0;
        const auto above =
            std::upper_bound(values_.begin(), values_.end(), value,
                             [](double v, const std::array<double, 2>& entry) { return v < entry[0]; });
        const auto i = static_cast<std::size_t>(above - values_.begin());
        const double t = (value - values_[i - 1][0]) / (values_[i][0] - values_[i - 1][0]);
        return 1.0 - (middle_[i - 1] + t * (middle_[i] - middle_[i - 1]));
    }

    [[nodiscard]] Distribution distribution() const {
        return {.mean = mean_,
                .median = quantile(0.5),
                .percentile_90 = quantile(0.9),
                .percentile_95 = quantile(0.95),
                .percentile_99 = quantile(0.99),
                .largest = values_.back()[0]};
    }

  private:
    std::vector<std::array<double, 2>> values_;
    std::vector<double> middle_;
    double mean_ = 0.0;
};

void check(const NozzleFlow& flow, const PopulationRequest& request) {
    if (!(request.cell_radius > 0.0 && request.cell_radius < flow.radius())) {
        throw UsageError("population: the cell radius must lie between zero and the nozzle's");
    }
    if (request.nodes < 4) throw UsageError("population: at least 4 streamlines are needed");
    for (const double t : request.thresholds) {
        if (!std::isfinite(t)) throw UsageError("population: a threshold must be a finite stress");
    }
}

struct Streamline {
    double radius;
    StreamlinePassage passage;
};

/// Adds the streamlines around the first at which the largest stress changes from the exit into the nozzle:
/// there the peak has a kink, and the share of the cells on either side hangs on it.
template <typename Follow>
void refine_change(std::vector<Streamline>& lines, const Follow& follow) {
    const auto inside = std::find_if(lines.begin(), lines.end(), [](const Streamline& line) {
        return line.passage.place == StreamlinePlace::nozzle;
    });
    if (inside == lines.begin() || inside == lines.end()) return;
    auto index = static_cast<std::size_t>(inside - lines.begin());
    const auto excess = [&](std::size_t i) {
        return lines[i].passage.exit_peak - lines[i].passage.nozzle_peak;
    };
    for (int i = 0; i < 5; ++i) {
        const double a = lines[index - 1].radius;
        const double b = lines[index].radius;
        const double part = excess(index - 1) / (excess(index - 1) - excess(index));
        const double r = a + (b - a) * std::clamp(part, 0.1, 0.9);
        const auto at = lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(index),
                                     {.radius = r, .passage = follow(r)});
        if (std::abs(excess(index)) < near_enough * at->passage.nozzle_peak) return;
        if (at->passage.place == StreamlinePlace::exit) ++index;
    }
}

}  // namespace

Population population(const NozzleFlow& flow, const PopulationRequest& request) {
    check(flow, request);
    const ExitField field(flow);
    const double outermost = flow.radius() - request.cell_radius;
    const SizeEffect size(flow, {.radius = request.cell_radius,
                                 .shear_modulus = request.shear_modulus,
                                 .viscosity_ratio = request.viscosity_ratio});
    const auto follow = [&](double r) {
        return streamline_passage(flow, field, size,
                                  {.start_radius = r,
                                   .shear_modulus = request.shear_modulus,
                                   .viscosity_ratio = request.viscosity_ratio,
                                   .length = request.length},
                                  [](const StreamlineState&) {});
    };
    std::vector<Streamline> lines(static_cast<std::size_t>(request.nodes));
    for_each_index(lines.size(), request.jobs, [&](std::size_t i) {
        // Chebyshev's points: dense at both ends, where the interpolation has one side only.
        const double angle = std::numbers::pi * static_cast<double>(i) / (request.nodes - 1);
        const double r = outermost * 0.5 * (1.0 - std::cos(angle));
        lines[i] = {.radius = r, .passage = follow(r)};
    });
    refine_change(lines, follow);
    Population result{};
    std::vector<double> exposure;
    for (const auto& [r, p] : lines) {
        result.radius.push_back(r);
        result.nozzle_peak.push_back(p.nozzle_peak);
        result.exit_peak.push_back(p.exit_peak);
        if (p.exposure) exposure.push_back(*p.exposure + p.exit_exposure);
    }

    const Monotone nozzle(result.radius, result.nozzle_peak);
    const Monotone exit(result.radius, result.exit_peak);
    const double whole = field.nozzle_flux(outermost);
    std::vector<std::array<double, 2>> peaks;
    std::vector<double> weights;
    double within = 0.0;
    for (std::size_t i = 0; i < rings; ++i) {
        const double middle = outermost * (static_cast<double>(i) + 0.5) / rings;
        const double next = field.nozzle_flux(outermost * static_cast<double>(i + 1) / rings);
        const double weight = (next - within) / whole;
        within = next;
        const double in_nozzle = nozzle(std::max(middle, result.radius.front()));
        const double at_exit = exit(std::max(middle, result.radius.front()));
        peaks.push_back({std::max(in_nozzle, at_exit), weight});
        weights.push_back(weight);
        if (at_exit > in_nozzle) result.share_peaking_at_exit += weight;
    }
    const Weighted stresses(std::move(peaks));
    result.peak_stress = stresses.distribution();
    for (const double t : request.thresholds) result.share_above.push_back(stresses.share_above(t));
    if (!exposure.empty()) {
        const Monotone along(result.radius, exposure);
        std::vector<std::array<double, 2>> values;
        for (std::size_t i = 0; i < rings; ++i) {
            const double middle = outermost * (static_cast<double>(i) + 0.5) / rings;
            values.push_back({along(std::max(middle, result.radius.front())), weights[i]});
        }
        result.exposure = Weighted(std::move(values)).distribution();
    }
    return result;
}

}  // namespace bioprint
