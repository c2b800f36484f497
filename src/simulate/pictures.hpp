#pragma once

#include "bioprint/simulate/snapshot.hpp"
#include "lattice/axisymmetric.hpp"
#include "simulate/immersed_cell.hpp"
#include "simulate/lattice_units.hpp"

/// Pictures of the axisymmetric scenes.
namespace bioprint {

/// Where a lattice lies and moves.
struct PictureFrame {
    double offset = 0.0;  ///< x of the picture less x of the lattice, in nodes
    double drift = 0.0;   ///< velocity of the lattice, lattice units
    int first = 0;        ///< column of a periodic lattice the picture begins with
};

CellPicture cell_picture(const ImmersedCell& cell, const LatticeUnits& units, const PictureFrame& frame);
FlowPicture flow_picture(const lattice::AxisymmetricFlow& flow, const LatticeUnits& units,
                         const PictureFrame& frame);

}  // namespace bioprint
