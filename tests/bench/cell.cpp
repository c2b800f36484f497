// Nanoseconds of CPU time a call of the cell room's public functions, the fastest of several passes.
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "bioprint/cell/roscoe.hpp"
#include "bioprint/cell/shape_integrals.hpp"

namespace {

template <typename F>
void measure(const char* name, int calls, F&& f) {
    double best = 1e300;
    volatile double sink = 0.0;
    for (int pass = 0; pass < 7; ++pass) {
        double sum = 0.0;
        const std::clock_t start = std::clock();
        for (int i = 0; i < calls; ++i) sum += f(i / static_cast<double>(calls));
        const double time = 1e9 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        sink = sum;
        best = std::fmin(best, time / calls);
    }
    (void)sink;
    std::printf("%-48s %10.0f ns\n", name, best);
}

}  // namespace

int main() {
    using namespace bioprint;
    const auto shear = [](double lambda, double low, double high) {
        return [=](double u) {
            const double stress = 1000.0 * low * std::pow(high / low, u);
            return roscoe_shear({.fluid_stress = stress,
                                 .shear_rate = 10.0,
                                 .shear_modulus = 1000.0,
                                 .viscosity_ratio = lambda})
                .von_mises;
        };
    };
    measure("roscoe_shear, load 0.01 to 10, lambda 1", 20000, shear(1.0, 0.01, 10.0));
    measure("roscoe_shear, load 1e-8 to 1e4, lambda 1", 20000, shear(1.0, 1e-8, 1e4));
    measure("roscoe_shear, load 0.01 to 10, lambda 5", 20000, shear(5.0, 0.01, 10.0));
    measure("roscoe_elongation, load up to the limit", 20000, [](double u) {
        const auto state = roscoe_elongation({.fluid_stress = 490.0 * u, .shear_modulus = 1000.0});
        return state ? state->von_mises : 0.0;
    });
    measure("shape_integrals, moderate ratio", 20000, [](double u) {
        return shape_integrals({1.0 + u, 1.0, 1.0 / (1.0 + u)}).second[0];
    });
    measure("shape_integrals_adaptive", 50, [](double u) {
        return shape_integrals_adaptive({1.0 + u, 1.0, 1.0 / (1.0 + u)}).value.second[0];
    });
    return 0;
}
