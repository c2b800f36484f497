#pragma once

/// GSL reports errors by status once its aborting handler is off; a status becomes an exception here.
namespace bioprint {

/// Turns GSL's aborting error handler off, once per process.
void use_gsl_status_codes();

/// @throws NotConverged  naming `what` and GSL's reason, unless `status` is success
void check_gsl(int status, const char* what);

}  // namespace bioprint
