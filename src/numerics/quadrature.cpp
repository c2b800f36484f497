#include "numerics/quadrature.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>

#include "bioprint/errors.hpp"
#include "numerics/gsl_errors.hpp"

namespace bioprint {
namespace {

constexpr std::size_t max_intervals = 2000;

double call(double x, void* f) {
    return (*static_cast<const std::function<double(double)>*>(f))(x);
}

struct FreeWorkspace {
    void operator()(gsl_integration_workspace* w) const { gsl_integration_workspace_free(w); }
};

gsl_integration_workspace* workspace() {
    thread_local const std::unique_ptr<gsl_integration_workspace, FreeWorkspace> space(
        gsl_integration_workspace_alloc(max_intervals));
    return space.get();
}

/// Round-off met on the way to a tolerance below it is not a failure: the estimate says how far it got.
Integral finish(int status, Integral integral) {
    const bool at_round_off =
        status == GSL_EROUND && std::abs(integral.error) <= 1e-9 * std::abs(integral.value);
    if (!at_round_off) check_gsl(status, "quadrature");
    return integral;
}

}  // namespace

Integral integrate(const std::function<double(double)>& f, double low, double high, double relative) {
    use_gsl_status_codes();
    gsl_function g{.function = call, .params = const_cast<std::function<double(double)>*>(&f)};
    Integral result{};
    const int status = gsl_integration_qag(&g, low, high, 0.0, relative, max_intervals, GSL_INTEG_GAUSS31,
                                           workspace(), &result.value, &result.error);
    return finish(status, result);
}

Integral integrate_to_infinity(const std::function<double(double)>& f, double low, double relative) {
    use_gsl_status_codes();
    gsl_function g{.function = call, .params = const_cast<std::function<double(double)>*>(&f)};
    Integral result{};
    const int status = gsl_integration_qagiu(&g, low, 0.0, relative, max_intervals, workspace(),
                                             &result.value, &result.error);
    return finish(status, result);
}

const GaussRule& gauss_rule() {
    static const GaussRule rule = [] {
        GaussRule r{};
        gsl_integration_glfixed_table* table = gsl_integration_glfixed_table_alloc(GaussRule::size);
        for (std::size_t i = 0; i < GaussRule::size; ++i) {
            gsl_integration_glfixed_point(0.0, 1.0, i, &r.node[i], &r.weight[i], table);
        }
        gsl_integration_glfixed_table_free(table);
        return r;
    }();
    return rule;
}

}  // namespace bioprint
