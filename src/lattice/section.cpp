#include "lattice/section.hpp"

#include <cmath>
#include <cstddef>

#include "bioprint/errors.hpp"

namespace bioprint {

namespace {

// Closer to the wall than this a node counts as solid: its links would have no length left.
constexpr double closest_node = 1e-6;

double cut_fraction(double radius, double y, double z, int dy, int dz) {
    const double a = dy * dy + dz * dz;
    const double b = y * dy + z * dz;
    const double c = radius * radius - y * y - z * z;  // > 0 inside
    // The positive root of a s² + 2 b s − c = 0, in the form that does not cancel.
    const double root = std::sqrt(b * b + a * c);
    return b > 0 ? c / (b + root) : (root - b) / a;
}

template <class Visit>
void for_each_link(const Section& section, Visit visit) {
    for (int z = 0; z < section.nz; ++z) {
        for (int y = 0; y < section.ny; ++y) {
            if (!section.is_fluid(y, z)) {
                continue;
            }
            for (int dz = -1; dz <= 1; ++dz) {
                for (int dy = -1; dy <= 1; ++dy) {
                    if ((dy != 0 || dz != 0) && !section.is_fluid(y + dy, z + dz)) {
                        visit(y, z, dy, dz);
                    }
                }
            }
        }
    }
}

}  // namespace

bool Section::is_fluid(int y, int z) const {
    if (periodic_y) {
        y = (y + ny) % ny;
    }
    if (periodic_z) {
        z = (z + nz) % nz;
    }
    if (mirror_low && z < 0) {
        z = -1 - z;
    }
    if (mirror_high && z >= nz) {
        z = 2 * nz - 1 - z;
    }
    return y >= 0 && y < ny && z >= 0 && z < nz && fluid[static_cast<std::size_t>(z) * ny + y] != 0;
}

int Section::fluid_nodes() const {
    int count = 0;
    for (const char is : fluid) {
        count += is;
    }
    return count;
}

Section plates(int ny, int nz, double velocity_low, double velocity_high, Sides sides) {
    if (ny < 2 || nz < 1) {
        throw UsageError("a channel between plates needs at least 2 x 1 nodes");
    }
    Section section{.ny = ny,
                    .nz = nz,
                    .periodic_z = sides == Sides::periodic,
                    .mirror_low = sides == Sides::mirrors,
                    .mirror_high = sides == Sides::mirrors,
                    .origin_y = 0.5 * ny,
                    .origin_z = sides == Sides::mirrors ? 0.0 : 0.5 * nz,
                    .fluid = std::vector<char>(static_cast<std::size_t>(ny) * nz, 1),
                    .links = {}};
    for_each_link(section, [&](int y, int z, int dy, int dz) {
        const double velocity = dy < 0 ? velocity_low : velocity_high;
        section.links.push_back({.y = y,
                                 .z = z,
                                 .dy = dy,
                                 .dz = dz,
                                 .fraction = 0.5,
                                 .velocity = {velocity, 0.0, 0.0},
                                 .normal = {static_cast<double>(dy), 0.0},
                                 .wall_point = {section.y_of(y + 0.5 * dy), section.z_of(z + 0.5 * dz)}});
    });
    return section;
}

Section tube(double radius, bool half) {
    if (!(radius >= 2.0) || radius > 10000.0) {
        throw UsageError("the radius of a tube must lie between 2 and 10000 nodes");
    }
    const int reach = static_cast<int>(std::ceil(radius));
    Section section{.ny = 2 * reach,
                    .nz = half ? reach : 2 * reach,
                    .mirror_low = half,
                    .origin_y = static_cast<double>(reach),
                    .origin_z = half ? 0.0 : static_cast<double>(reach),
                    .radius = radius,
                    .fluid = {},
                    .links = {}};
    section.fluid.resize(static_cast<std::size_t>(section.ny) * section.nz);
    for (int z = 0; z < section.nz; ++z) {
        for (int y = 0; y < section.ny; ++y) {
            const double distance = std::hypot(section.y_of(y), section.z_of(z));
            section.fluid[static_cast<std::size_t>(z) * section.ny + y] =
                distance < radius - closest_node ? 1 : 0;
        }
    }
    for_each_link(section, [&](int y, int z, int dy, int dz) {
        const double at_y = section.y_of(y);
        const double at_z = section.z_of(z);
        const double fraction = cut_fraction(radius, at_y, at_z, dy, dz);
        const std::array<double, 2> point{at_y + fraction * dy, at_z + fraction * dz};
        section.links.push_back({.y = y,
                                 .z = z,
                                 .dy = dy,
                                 .dz = dz,
                                 .fraction = fraction,
                                 .velocity = {},
                                 .normal = {point[0] / radius, point[1] / radius},
                                 .wall_point = point});
    });
    return section;
}

}  // namespace bioprint
