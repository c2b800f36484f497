#include "numerics/sample_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace bioprint {
namespace {

constexpr std::array<double, 3> parts = {0.05, 0.5, 0.95};

/// Between the two values around it, each of which stands for the middle of its share of the sample.
double quantile(const std::vector<double>& sorted, double part) {
    const double place = part * static_cast<double>(sorted.size()) - 0.5;
    if (place <= 0.0) return sorted.front();
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= sorted.size()) return sorted.back();
    const double t = place - static_cast<double>(below);
    return sorted[below] + t * (sorted[below + 1] - sorted[below]);
}

/// The Hermite polynomials of orders 1 to 4, normalised over the normal distribution.
std::array<double, 4> hermite(double z) {
    const double z2 = z * z;
    return {z, (z2 - 1.0) / std::sqrt(2.0), z * (z2 - 3.0) / std::sqrt(6.0),
            ((z2 - 6.0) * z2 + 3.0) / std::sqrt(24.0)};
}

}  // namespace

SampleStatistics sample_statistics(std::span<const double> values, std::span<const double> normals,
                                   std::size_t inputs, const std::vector<bool>& mixed) {
    const auto count = static_cast<double>(values.size());
    SampleStatistics result{.mean = 0.0, .standard_deviation = 0.0, .quantiles = {}, .first_order = {}};
    result.first_order.assign(inputs, 0.0);
    double scale = 0.0;
    for (const double value : values) scale = std::max(scale, std::abs(value));
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < parts.size(); ++i) result.quantiles[i] = quantile(sorted, parts[i]);
    if (scale == 0.0) return result;

    // In units of the largest value, so that no square leaves the range of numbers.
    double mean = 0.0;
    for (const double value : values) mean += value / scale / count;
    result.mean = scale * mean;
    double variance = 0.0;
    for (const double value : values) {
        const double off = value / scale - mean;
        variance += off * off;
    }
    variance /= std::max(1.0, count - 1.0);
    result.standard_deviation = scale * std::sqrt(variance);
    constexpr double rounding = 1e-24;  // a spread of 1e-12 of the value is none
    if (variance <= rounding * mean * mean) {
        result.standard_deviation = 0.0;
        return result;
    }
    for (std::size_t input = 0; input < inputs; ++input) {
        std::array<double, 4> coefficient{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::array<double, 4> h = hermite(normals[i * inputs + input]);
            for (std::size_t k = 0; k < h.size(); ++k)
                coefficient[k] += (values[i] / scale - mean) * h[k] / count;
        }
        double explained = 0.0;
        const std::size_t orders = !mixed.empty() && mixed[input] ? 2 : coefficient.size();
        for (std::size_t k = 0; k < orders; ++k) explained += coefficient[k] * coefficient[k];
        result.first_order[input] = std::min(1.0, explained / variance);
    }
    return result;
}

}  // namespace bioprint
