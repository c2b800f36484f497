#pragma once

#include <array>

/// The nine velocities of the plane lattice (x, r), as pairs of opposites, and their weights.
namespace bioprint::lattice {

struct D2Q9 {
    static constexpr int size = 9;
    static constexpr std::array<int, size> x{0, 1, -1, 0, 0, 1, -1, 1, -1};
    static constexpr std::array<int, size> r{0, 0, 0, 1, -1, 1, -1, -1, 1};
    static constexpr std::array<int, size> opposite{0, 2, 1, 4, 3, 6, 5, 8, 7};
    /// The velocity with its radial part reversed.
    static constexpr std::array<int, size> mirror{0, 1, 2, 4, 3, 7, 8, 5, 6};
    static constexpr double rest = 4.0 / 9.0;
    static constexpr double straight = 1.0 / 9.0;
    static constexpr double diagonal = 1.0 / 36.0;
    static constexpr std::array<double, size> weight{rest,     straight, straight, straight, straight,
                                                     diagonal, diagonal, diagonal, diagonal};
};

}  // namespace bioprint::lattice
