#pragma once

#include <algorithm>

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
            if (!(std::max(b, c) > top_.value)) continue;
            // The top of the parabola through the three.
            const double bend = a - 2.0 * b + c;
            const double lean = c - a;
            const double place = bend < 0.0 ? std::clamp(-0.5 * lean / bend, -1.0, 1.0) : (c > b ? 1.0 : 0.0);
            const double theta = low + half * (1.0 + place);
            const double top = place == 1.0 ? c : value(theta);
            if (top > top_.value) top_ = {.at = from + theta * (to - from), .value = top};
        }
    }

    [[nodiscard]] const Top& top() const { return top_; }
    [[nodiscard]] double integral() const { return integral_; }
    [[nodiscard]] double last() const { return last_; }

  private:
    Top top_;
    double last_;
    double integral_ = 0.0;
};

}  // namespace bioprint
