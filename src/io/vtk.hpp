#pragma once

#include <string>
#include <vector>

#include "bioprint/simulate/snapshot.hpp"

/// Pictures in the XML files of the Visualization Toolkit, which ParaView and VisIt open; numbers inline in base64,
/// little-endian. The cell's in double, the flow's in single precision.
namespace bioprint {

/// Unstructured grid (.vtu): displacement [m] at the nodes, von_mises [Pa] and jacobian in the elements.
std::string vtu_text(const CellPicture& cell);

/// Image (.vti): velocity [m/s], pressure [Pa], shear_rate [1/s], viscosity [Pa s], stress [Pa], and fluid (0 or 1)
/// where not every node is.
std::string vti_text(const FlowPicture& flow);

struct TimelineEntry {
    double time;  ///< [s]
    std::string file;
};

/// The list of files over time (.pvd).
std::string pvd_text(const std::vector<TimelineEntry>& entries);

}  // namespace bioprint
