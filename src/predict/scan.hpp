#pragma once

#include <algorithm>
#include <cmath>

namespace bioprint {

/// The largest of a quantity over the steps of an integration, and its integral.
class Scan {
  public:
    struct Top {
        double at;
        double value;
    };

    explicit Scan(double at, double value) : top_{.at = at, .value = value}, last_(value) {}

    /// @param value   the quantity at θ of the step
    /// @param weight  what the integral weights it with there
    template <typename Value, typename Weight>
    void take(double from, double to, const Value& value, const Weight& weight) {
        constexpr int parts = 4;
        double start = last_ * weight(0.0);
        for (int i = 0; i < parts; ++i) {
            const double low = static_cast<double>(i) / parts;
            const double half = 0.5 / parts;
            const double a = last_;
            const double b = value(low + half);
            const double c = value(low + 2.0 * half);
            const double end = c * weight(low + 2.0 * half);
            integral_ += (to - from) / parts * (start + 4.0 * b * weight(low + half) + end) / 6.0;
            start = end;
            last_ = c;
            // A top may lie just behind a, which then is the largest so far.
            const double bend = a - 2.0 * b + c;
            const double lean = c - a;
            const bool peaks = bend < 0.0 && std::abs(lean) < -2.0 * bend;
            const double guess = peaks ? b - 0.125 * lean * lean / bend : std::max(b, c);
            if (!(guess > top_.value)) continue;
            const double theta = peaks ? refined(value, low + half * (1.0 - 0.5 * lean / bend), 0.15 * half)
                                       : low + (c > b ? 2.0 * half : half);
            const double top = value(theta);
            if (top > top_.value) top_ = {.at = from + theta * (to - from), .value = top};
        }
    }

    [[nodiscard]] const Top& top() const { return top_; }
    [[nodiscard]] double integral() const { return integral_; }
    [[nodiscard]] double last() const { return last_; }

  private:
    /// The top of a parabola through places closer together: the first one is as coarse as the step.
    template <typename Value>
    static double refined(const Value& value, double theta, double half) {
        const double middle = std::clamp(theta, half, 1.0 - half);
        const double a = value(middle - half);
        const double c = value(middle + half);
        const double bend = a - 2.0 * value(middle) + c;
        if (!(bend < 0.0)) return middle;
        return std::clamp(middle - 0.5 * half * (c - a) / bend, 0.0, 1.0);
    }

    Top top_;
    double last_;
    double integral_ = 0.0;
};

}  // namespace bioprint
