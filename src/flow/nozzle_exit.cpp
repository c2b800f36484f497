#include "bioprint/flow/nozzle_exit.hpp"

#include <numbers>

namespace bioprint {

NozzleExit nozzle_exit(const NozzleFlow& flow) {
    const double rate = flow.velocity_excess() / (2.0 * flow.radius());
    return {.elongation_rate = rate, .elongational_stress = stress(flow.ink(), std::numbers::sqrt3 * rate)};
}

}  // namespace bioprint
