#pragma once

#include "bioprint/flow/nozzle_flow.hpp"

/// The nozzle flow by another route: GSL's adaptive quadrature of the plain profile integrals, which
/// estimates its own error. Two hundred times slower than the fixed rule; the reference it is held against.
namespace bioprint {

struct FlowCheck {
    double velocity_average;  ///< [m/s]
    double velocity_excess;   ///< u_max − u_avg [m/s]
    double relative_error;    ///< the larger one of the quadrature's own estimates
};

/// @throws NotConverged  the quadrature gave up
FlowCheck check_flow(const NozzleFlow& flow);

}  // namespace bioprint
