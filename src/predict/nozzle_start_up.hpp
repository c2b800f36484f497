#pragma once

#include <optional>

#include "bioprint/function_ref.hpp"
#include "cell/planar_cell.hpp"

/// A cell that enters a nozzle round: its start-up in the steady shear of its streamline.
///
/// Followed until it is at its steady shape to 2e-5, or to the nozzle's end, or through a strain of 3000: a
/// cell that takes longer counts as unsettled. The uniform part is the transient ellipsoid, the linear part
/// grows as bullet_growth says.
///
/// Accuracy: integration 1e-6.                                tests/verify/streamline_passage.cpp
namespace bioprint {

struct StartUpQuestion {
    PlanarFlow shear;
    PlanarCell cell;
    PlanarStrain settled;  ///< what it tends to
    double linear;         ///< the linear part of the settled cell [Pa]
    double duration;       ///< of its stay [s], > 0
};

struct StartUp {
    PlanarState end;
    bool at_rest;      ///< the end is the settled state
    double growth;     ///< part of the linear stress that has grown, 0 to 1
    double peak;       ///< the largest von Mises stress [Pa]
    double peak_time;  ///< [s]
    double exposure;   ///< ∫ von Mises dt [Pa s]
    bool settles;      ///< within 5 % of the settled stress before the end, and from then on
    std::optional<double> settling_time;  ///< [s]
};

/// The cell on its way.
struct StartUpState {
    double time;
    PlanarStrain strain;
    double linear;
    double exposure;
};

/// @throws NotConverged  the integrator gave up
StartUp start_up(const StartUpQuestion& question, FunctionRef<void(const StartUpState&)> observe);

}  // namespace bioprint
