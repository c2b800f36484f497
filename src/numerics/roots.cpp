#include "numerics/roots.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <memory>

#include "bioprint/errors.hpp"
#include "numerics/gsl_errors.hpp"

namespace bioprint {
namespace {

constexpr int max_iterations = 200;

double call(double x, void* f) {
    return (*static_cast<const std::function<double(double)>*>(f))(x);
}

struct FreeSolver {
    void operator()(gsl_root_fsolver* s) const { gsl_root_fsolver_free(s); }
};

}  // namespace

double find_root(const std::function<double(double)>& f, Bracket bracket, RootTolerance tolerance) {
    use_gsl_status_codes();
    const double at_low = f(bracket.low);
    const double at_high = f(bracket.high);
    if (at_low == 0.0) return bracket.low;
    if (at_high == 0.0) return bracket.high;
    if (!(std::signbit(at_low) != std::signbit(at_high)) || !std::isfinite(at_low) ||
        !std::isfinite(at_high)) {
        throw NotConverged("root search: the interval does not bracket a root");
    }

    thread_local const std::unique_ptr<gsl_root_fsolver, FreeSolver> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
    gsl_function g{.function = call, .params = const_cast<std::function<double(double)>*>(&f)};
    check_gsl(gsl_root_fsolver_set(solver.get(), &g, bracket.low, bracket.high), "root search");
    for (int i = 0; i < max_iterations; ++i) {
        check_gsl(gsl_root_fsolver_iterate(solver.get()), "root search");
        const double low = gsl_root_fsolver_x_lower(solver.get());
        const double high = gsl_root_fsolver_x_upper(solver.get());
        if (gsl_root_test_interval(low, high, tolerance.absolute, tolerance.relative) == GSL_SUCCESS) {
            return gsl_root_fsolver_root(solver.get());
        }
    }
    throw NotConverged("root search: no root found in the interval");
}

}  // namespace bioprint
