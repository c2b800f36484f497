#include "numerics/gsl_errors.hpp"

#include <gsl/gsl_errno.h>

#include <string>

#include "bioprint/errors.hpp"

namespace bioprint {

void use_gsl_status_codes() {
    static const auto* const previous = reinterpret_cast<const void*>(gsl_set_error_handler_off());
    (void)previous;
}

void check_gsl(int status, const char* what) {
    if (status != GSL_SUCCESS) throw NotConverged(std::string(what) + ": " + gsl_strerror(status));
}

}  // namespace bioprint
