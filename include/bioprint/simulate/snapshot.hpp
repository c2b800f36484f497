#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

/// Pictures of a simulation at one moment: the cell's mesh and the flow about it, SI units.
///
/// The nozzle's axis is x, from the lip (from the start of its way in the long nozzle, from the middle between
/// plates). Axisymmetric scenes lie in the half plane y = r ≥ 0, z = 0; scenes in space show the half z ≥ 0 of their
/// mirror plane.
namespace bioprint {

/// Triangles of the half plane, or tetrahedra.
struct CellPicture {
    std::vector<std::array<double, 3>> position;      ///< of the nodes [m]
    std::vector<std::array<double, 3>> displacement;  ///< from the undeformed cell about the same centre [m]
    int nodes_per_element = 3;                        ///< 3 or 4
    std::vector<int> elements;                        ///< nodes of each, one element after another
    std::vector<double> von_mises;                    ///< of each element [Pa]
    std::vector<double> jacobian;                     ///< volume of each element over its undeformed volume
};

/// Fields on a regular grid, x fastest, then y, then z.
struct FlowPicture {
    std::array<int, 3> nodes{};
    std::array<double, 3> origin{};               ///< of the first node [m]
    double spacing = 0.0;                         ///< [m]
    std::vector<std::array<double, 3>> velocity;  ///< [m/s]
    std::vector<double> pressure;                 ///< [Pa]; in a periodic nozzle without its mean slope
    std::vector<double> shear_rate;               ///< √(2 S:S) [1/s]
    std::vector<double> viscosity;                ///< [Pa s]
    std::vector<double> stress;                   ///< viscosity × shear rate [Pa]
    std::vector<char> fluid;                      ///< 0 outside the nozzle; empty when all nodes are fluid
};

struct SimulationSnapshot {
    int index = 0;      ///< 0, 1, 2 … in the run; a resumed run hands out the same ones again
    const char* stage;  ///< as in SimulationProgress
    double time = 0.0;  ///< as in the series [s]; 0 for the steady flow without cell
    std::optional<CellPicture> cell;
    std::optional<FlowPicture> flow;
};

}  // namespace bioprint
