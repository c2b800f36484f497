#include "cell/shear_curve.hpp"

#include <cmath>

#include "cell/shear_curve_table.hpp"

namespace bioprint {

ShearCurve shear_curve(const AxisRatio& ratio) {
    const double v = ratio.delta / (1.0 + shear_curve_bend * ratio.s);
    const double x = 2.0 * v - 1.0;
    const double twice = 2.0 * x;
    // Clenshaw's recurrence, the three series side by side so that their latencies overlap.
    double a1 = 0.0, a2 = 0.0, b1 = 0.0, b2 = 0.0, c1 = 0.0, c2 = 0.0;
    for (std::size_t n = shear_curve_terms - 1; n > 0; --n) {
        const double a = twice * a1 - a2 + shear_curve_lean[n];
        const double b = twice * b1 - b2 + shear_curve_slip[n];
        const double c = twice * c1 - c2 + shear_curve_bearing[n];
        a2 = a1;
        a1 = a;
        b2 = b1;
        b1 = b;
        c2 = c1;
        c1 = c;
    }
    return {.lean = x * a1 - a2 + shear_curve_lean[0],
            .slip = x * b1 - b2 + shear_curve_slip[0],
            .bearing = x * c1 - c2 + shear_curve_bearing[0]};
}

double log_ratio(const AxisRatio& ratio) {
    return ratio.s < 0.5 ? -std::log(ratio.s) : -std::log1p(-ratio.delta);
}

double log_ratio_excess(const AxisRatio& ratio) {
    const double d = ratio.delta;
    if (d > 0.1) return log_ratio(ratio) - d;
    double sum = 0.0;  // Σ δⁿ/n from n = 2, in Horner's form
    for (int n = 17; n >= 2; --n) sum = sum * d + 1.0 / n;
    return sum * d * d;
}

}  // namespace bioprint
