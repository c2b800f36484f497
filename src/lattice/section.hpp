#pragma once

#include <array>
#include <vector>

/// The cross-section of a channel that is the same all along x: which nodes (y, z) hold fluid, where its
/// walls cut the links between nodes, and what closes it elsewhere. Lengths in node spacings.
///
/// Node (y, z) sits at (y + ½ − origin_y, z + ½ − origin_z) from the section's centre.
namespace bioprint {

/// A link (dy, dz) from a fluid node that a wall cuts at `fraction` of its length, 0 < fraction ≤ 1.
struct WallLink {
    int y, z;
    int dy, dz;
    double fraction;
    std::array<double, 3> velocity{};    ///< of the wall where it is cut
    std::array<double, 2> normal{};      ///< out of the fluid, (y, z)
    std::array<double, 2> wall_point{};  ///< where it is cut, relative to the centre
};

struct Section {
    int ny = 0;
    int nz = 0;
    bool periodic_y = false;
    bool periodic_z = false;
    bool mirror_low = false;   ///< mirror plane half a spacing below z = 0
    bool mirror_high = false;  ///< mirror plane half a spacing above z = nz − 1
    double origin_y = 0.0;
    double origin_z = 0.0;
    double radius = 0.0;      ///< of a round section; 0 otherwise
    std::vector<char> fluid;  ///< [z ny + y]
    std::vector<WallLink> links;

    [[nodiscard]] bool is_fluid(int y, int z) const;
    [[nodiscard]] double y_of(double y) const { return y + 0.5 - origin_y; }
    [[nodiscard]] double z_of(double z) const { return z + 0.5 - origin_z; }
    [[nodiscard]] int fluid_nodes() const;
};

/// How the two z faces of a plane channel are closed.
enum class Sides { periodic, mirrors };

/// Two plates normal to y, half a spacing outside the first and last node, moving along x.
Section plates(int ny, int nz, double velocity_low, double velocity_high, Sides sides);

/// A tube of any radius ≥ 2 about the x axis; `half` keeps z > 0 and a mirror at z = 0.
Section tube(double radius, bool half);

}  // namespace bioprint
