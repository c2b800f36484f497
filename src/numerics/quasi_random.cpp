#include "numerics/quasi_random.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>

#include <memory>
#include <new>
#include <string>

#include "bioprint/errors.hpp"
#include "numerics/gsl_errors.hpp"

namespace bioprint {
namespace {

struct FreeGenerator {
    void operator()(gsl_qrng* generator) const { gsl_qrng_free(generator); }
};

}  // namespace

std::vector<double> sobol_points(std::size_t dimensions, std::size_t count) {
    constexpr std::size_t most = 40;
    if (dimensions == 0 || dimensions > most) {
        throw UsageError("sampling: " + std::to_string(dimensions) +
                         " uncertain inputs; 1 to 40 can be sampled");
    }
    use_gsl_status_codes();
    const std::unique_ptr<gsl_qrng, FreeGenerator> generator(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimensions)));
    if (!generator) throw std::bad_alloc();
    // GSL leaves out the sequence's first point, the corner of the cube.
    std::vector<double> points(dimensions * count, 0.0);
    for (std::size_t i = 1; i < count; ++i) {
        check_gsl(gsl_qrng_get(generator.get(), &points[i * dimensions]), "quasi-random points");
    }
    double cells = 1.0;
    while (cells < static_cast<double>(count)) cells *= 2.0;
    for (double& coordinate : points) coordinate += 0.5 / cells;
    return points;
}

double normal_probability(double z) {
    return gsl_cdf_ugaussian_P(z);
}

double normal_quantile(double p) {
    return gsl_cdf_ugaussian_Pinv(p);
}

}  // namespace bioprint
