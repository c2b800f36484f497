#pragma once

#include "bioprint/simulate/snapshot.hpp"
#include "simulate/immersed_body.hpp"

/// Pictures of the scenes in space.
namespace bioprint {

/// What turns lattice units into SI, and where the lattice lies.
struct SpaceScale {
    double spacing;         ///< [m]
    double time;            ///< [s] a step
    double stress;          ///< [Pa] a lattice unit
    double offset = 0.0;    ///< x of the picture less x of the lattice [m]
    double velocity = 0.0;  ///< of the lattice [m/s]
    bool centred = false;   ///< a periodic lattice is shown about the cell
};

/// The lattice must be between two cycles. A flow of more than `most_points` shows every second node, or third …
inline constexpr double most_points = 1.5e5;
template <class Real>
SimulationSnapshot space_picture(const D3q19<Real>& lattice, const ImmersedBody<Real>& cell,
                                 const SpaceScale& scale, double time);

extern template SimulationSnapshot space_picture<float>(const D3q19<float>&, const ImmersedBody<float>&,
                                                        const SpaceScale&, double);
extern template SimulationSnapshot space_picture<double>(const D3q19<double>&, const ImmersedBody<double>&,
                                                         const SpaceScale&, double);

}  // namespace bioprint
