#include "simulate/decay.hpp"

#include <algorithm>
#include <cmath>

namespace bioprint {
namespace {

constexpr double fit_from = 0.5;
constexpr double fit_to = 0.05;

}  // namespace

std::optional<double> decay_time(const std::vector<double>& time, const std::vector<double>& stress,
                                 std::size_t free_from) {
    const auto top = std::max_element(stress.begin(), stress.end());
    double n = 0.0, t = 0.0, y = 0.0, tt = 0.0, ty = 0.0;
    for (auto s = top; s != stress.end(); ++s) {
        if (*s<fit_from* * top&& * s> fit_to * *top) {
            const auto index = static_cast<std::size_t>(s - stress.begin());
            if (index < free_from) return std::nullopt;
            const double log_stress = std::log(*s);
            const double at = time[index];
            n += 1.0;
            t += at;
            y += log_stress;
            tt += at * at;
            ty += at * log_stress;
        }
    }
    const double slope = (n * ty - t * y) / (n * tt - t * t);
    return n >= 3.0 && slope < 0.0 ? std::optional(-1.0 / slope) : std::nullopt;
}

}  // namespace bioprint
