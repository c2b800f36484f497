#include "predict/exit_kind.hpp"

namespace bioprint {

ExitKind exit_kind(double excess_ratio, double wall_index) {
    return {.index = excess_ratio / (2.0 - excess_ratio), .wall_index = wall_index};
}

ExitKind exit_kind(const NozzleFlow& flow) {
    if (flow.velocity_average() == 0.0) return {.index = 1.0, .wall_index = 1.0};
    return exit_kind(flow.velocity_excess() / flow.velocity_average(),
                     flow_index(flow.ink(), flow.shear_rate_max()));
}

}  // namespace bioprint
