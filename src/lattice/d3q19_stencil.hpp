#pragma once

/// The 19 velocities of the three-dimensional lattice, in pairs: q and `opposite(q)` point in opposite
/// directions.
namespace bioprint::d3q19 {

inline constexpr int directions = 19;

struct Velocity {
    int x, y, z;
};

inline constexpr Velocity velocity[directions] = {
    {0, 0, 0},                //
    {1, 0, 0},  {-1, 0, 0},   // 1, 2
    {0, 1, 0},  {0, -1, 0},   // 3, 4
    {0, 0, 1},  {0, 0, -1},   // 5, 6
    {1, 1, 0},  {-1, -1, 0},  // 7, 8
    {1, -1, 0}, {-1, 1, 0},   // 9, 10
    {1, 0, 1},  {-1, 0, -1},  // 11, 12
    {1, 0, -1}, {-1, 0, 1},   // 13, 14
    {0, 1, 1},  {0, -1, -1},  // 15, 16
    {0, 1, -1}, {0, -1, 1},   // 17, 18
};

constexpr double weight(int q) {
    return q == 0 ? 1.0 / 3.0 : (q < 7 ? 1.0 / 18.0 : 1.0 / 36.0);
}

constexpr int opposite(int q) {
    return q == 0 ? 0 : (q % 2 == 1 ? q + 1 : q - 1);
}

/// The direction q seen in a mirror normal to z.
constexpr int mirrored_z(int q) {
    for (int p = 0; p < directions; ++p) {
        if (velocity[p].x == velocity[q].x && velocity[p].y == velocity[q].y &&
            velocity[p].z == -velocity[q].z) {
            return p;
        }
    }
    return -1;
}

/// The direction q with its component along x reversed.
constexpr int mirrored_x(int q) {
    for (int p = 0; p < directions; ++p) {
        if (velocity[p].x == -velocity[q].x && velocity[p].y == velocity[q].y &&
            velocity[p].z == velocity[q].z) {
            return p;
        }
    }
    return -1;
}

}  // namespace bioprint::d3q19
