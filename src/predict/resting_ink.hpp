#pragma once

#include <optional>

#include "bioprint/cell/bullet.hpp"
#include "bioprint/flow/nozzle_flow.hpp"

/// Inks that have no viscosity at rest, in models that ask for one: power law, yield stress.
namespace bioprint {

/// Rates below it are taken as it [1/s]: a millionth of u_avg/R, at which such an ink holds a cell as it is; 0 for an
/// ink with a viscosity at rest.
inline double least_rate(const NozzleFlow& flow) {
    return has_rest_viscosity(flow.ink()) ? 0.0 : 1e-6 * flow.velocity_average() / flow.radius();
}

/// Whether a cell about the axis travels wholly inside the plug of an ink with a yield stress, where nothing shears it.
inline bool inside_plug(const NozzleFlow& flow, double cell_radius) {
    return flow.plug_radius() > 0.0 && flow.plug_radius() >= cell_radius;
}

/// The relaxation time of a cell in the strand [s], where the ink is at rest; none in an ink without a viscosity there.
inline std::optional<double> strand_relaxation(const Ink& ink, double shear_modulus, double viscosity_ratio) {
    if (!has_rest_viscosity(ink)) return std::nullopt;
    return relaxation_time(viscosity(ink, 0.0), shear_modulus, viscosity_ratio);
}

}  // namespace bioprint
