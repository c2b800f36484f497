#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/errors.hpp"
#include "lattice/d3q19.hpp"
#include "lattice/d3q19_stencil.hpp"

// Every population that does not come from a fluid node is put into the slot from which the streaming half of
// a cycle reads it ("filling"), and what that half leaves in the same slot is put where the local half reads
// it ("collecting"). Each slot has one reader, so threads share the links in any way and write the same
// bytes.

namespace bioprint {

namespace {

// How much of a free-slip wall's lag behind the fluid's turning is made up in one step. At 0.25 a disturbance off the axis
// grew (noticed when a cell passed, after 1300 steps); at 0.05 noise decays over 10 000 steps for ν from 0.5 to 2.
constexpr float slip_follow = 0.05F;

}  // namespace

using d3q19::directions;
using d3q19::mirrored_z;
using d3q19::opposite;
using d3q19::weight;

template <class Real>
void D3q19<Real>::build_links() {
    for (int r = 0; r < fluid_rows_; ++r) {
        const auto [y, z] = place_of_[r];
        for (int q = 1; q < directions; ++q) {
            const auto [cx, cy, cz] = d3q19::velocity[q];
            const int source = neighbour_[r][3 * (1 - cy) + 1 - cz];
            const bool mirror = source >= fluid_rows_ && source < fluid_rows_ + mirror_rows_;
            if (mirror) {
                mirror_links_.push_back({.ghost_slot = opposite(q),
                                         .real_slot = mirrored_z(opposite(q)),
                                         .ghost_row = source,
                                         .real_row = row(y - cy, z - cz)});
            }
            if (cx != 0 && ends_ == Ends::inflow_outflow && source < fluid_rows_ + mirror_rows_) {
                add_end(r, y, z, q);
            }
        }
    }
    for (const WallLink& wall : section_.links) {
        add_wall(wall, row(wall.y, wall.z));
    }
}

template <class Real>
void D3q19<Real>::add_end(int row, int y, int z, int q) {
    const auto [cx, cy, cz] = d3q19::velocity[q];
    const double u = cx > 0 ? inflow_(section_.y_of(y - 0.5 * cy), section_.z_of(z - 0.5 * cz)) : 0.0;
    end_links_.push_back({.q = q,
                          .row = row,
                          .source_row = neighbour_[row][3 * (1 - cy) + 1 - cz],
                          .sign = static_cast<Real>(cx > 0 ? 1 : -1),
                          .velocity = static_cast<Real>(6.0 * weight(q) * u),
                          .low = cx > 0});
}

template <class Real>
void D3q19<Real>::add_wall(const WallLink& wall, int row) {
    const bool slip = slip_begin_ < slip_end_;
    const int slip_point = slip ? add_slip_point(wall) : -1;
    for (int q = 1; q < directions; ++q) {
        const auto [cx, cy, cz] = d3q19::velocity[q];
        if (cy != wall.dy || cz != wall.dz) {
            continue;
        }
        const int far_row = neighbour_[row][3 * (1 - cy) + 1 - cz];
        // A node with walls on both sides of a link has no far neighbour; it takes the wall to be half-way.
        const bool narrow = far_row >= fluid_rows_ + mirror_rows_;
        const double fraction = narrow ? 0.5 : wall.fraction;
        const double scale = 12.0 * weight(q) / (1.0 + 2.0 * fraction);
        const double cu = cx * wall.velocity[0] + cy * wall.velocity[1] + cz * wall.velocity[2];
        const double around = -wall.normal[1] * cy + wall.normal[0] * cz;
        cut_links_.push_back({.q = q,
                              .row = row,
                              .far_row = narrow ? row : far_row,
                              .ghost_row = neighbour_[row][3 * (1 + cy) + 1 + cz],
                              .kappa = static_cast<Real>((1.0 - 2.0 * fraction) / (1.0 + 2.0 * fraction)),
                              .wall = static_cast<Real>(scale * cu),
                              .fraction = static_cast<Real>(fraction),
                              .slip_point = slip_point,
                              .slip_around = static_cast<Real>(scale * around)});
    }
}

template <class Real>
int D3q19<Real>::add_slip_point(const WallLink& wall) {
    // Where the fluid is read. From 1.5 on, all four nodes around the place are fluid. Extrapolating from a
    // second, deeper place would be third order, and was unstable.
    const double depth = 1.5;
    const std::array<double, 2> around{-wall.normal[1], wall.normal[0]};
    const std::array<double, 2> point{(section_.radius - depth) * wall.normal[0],
                                      (section_.radius - depth) * wall.normal[1]};
    SlipPoint slip{};
    const double at_y = point[0] + section_.origin_y - 0.5;
    const double at_z = point[1] + section_.origin_z - 0.5;
    const int y = static_cast<int>(std::floor(at_y));
    const int z = static_cast<int>(std::floor(at_z));
    // u_θ/r, not u_θ, is what has no gradient at a stress-free cylinder.
    const double growth = section_.radius / std::hypot(point[0], point[1]);
    for (int corner = 0; corner < 4; ++corner) {
        const int dy = corner % 2;
        const int dz = corner / 2;
        const double share =
            (dy == 1 ? at_y - y : 1.0 - (at_y - y)) * (dz == 1 ? at_z - z : 1.0 - (at_z - z));
        const int r = row(y + dy, z + dz);
        if (r < 0) {
            throw UsageError("the section is too narrow for free-slip walls");
        }
        const bool mirrored = z + dz < 0 || z + dz >= section_.nz;
        slip.row[corner] = r;
        slip.y[corner] = static_cast<Real>(share * growth * around[0]);
        slip.z[corner] = static_cast<Real>(share * growth * around[1] * (mirrored ? -1.0 : 1.0));
        observed_[r] = 1;
    }
    slip_points_.push_back(slip);
    return static_cast<int>(slip_points_.size()) - 1;
}

template <class Real>
void D3q19<Real>::fill(const Share& share) {
    if (!borders_.empty()) {
        send_from_borders(share, true);
#pragma omp barrier
    }
    if (ends_ == Ends::periodic) {
        wrap_ends(share, true);
#pragma omp barrier
    }
    if (!mirror_links_.empty()) {
        mirrors(share, true);
#pragma omp barrier
    }
    if (!end_links_.empty()) {
        ends(share, true);
#pragma omp barrier
    }
    if (!slip_points_.empty()) {
        slip_velocities(share, slip_follow);
#pragma omp barrier
    }
    walls(share, true);
#pragma omp barrier
}

template <class Real>
void D3q19<Real>::collect(const Share& share) {
    if (!borders_.empty()) {
        send_from_borders(share, false);
#pragma omp barrier
    }
    if (ends_ == Ends::periodic) {
        wrap_ends(share, false);
#pragma omp barrier
    }
    if (!mirror_links_.empty()) {
        mirrors(share, false);
#pragma omp barrier
    }
    if (!end_links_.empty()) {
        ends(share, false);
#pragma omp barrier
    }
    if (!slip_points_.empty()) {
        slip_velocities(share, slip_follow);
#pragma omp barrier
    }
    walls(share, false);
    if (!borders_.empty()) {
#pragma omp barrier
        restore_borders(share);
    }
}

template <class Real>
void D3q19<Real>::wrap_ends(const Share& share, bool filling) {
    // Slip walls collect from neighbours along x, so the rows behind them wrap as well.
    const int rows = filling ? fluid_rows_ : (slip_points_.empty() ? fluid_rows_ + mirror_rows_ : all_rows_);
    const int last = static_cast<int>(share.end(rows));
    for (int r = static_cast<int>(share.begin(rows)); r < last; ++r) {
        for (int q = 1; q < directions; ++q) {
            const int cx = d3q19::velocity[q].x;
            if (cx == 0) {
                continue;
            }
            // Outgoing population q leaves through one face and enters through the other.
            const int inside = cx > 0 ? nx_ - 1 : 0;
            const int entry = cx > 0 ? -1 : nx_;
            const int exit = cx > 0 ? nx_ : -1;
            const int first = cx > 0 ? 0 : nx_ - 1;
            if (filling) {
                Real* const f = slot(opposite(q), r);
                f[entry] = f[inside];
            } else {
                Real* const f = slot(q, r);
                f[first] = f[exit];
            }
        }
    }
}

template <class Real>
void D3q19<Real>::mirrors(const Share& share, bool filling) {
    for (std::size_t i = share.begin(mirror_links_.size()); i < share.end(mirror_links_.size()); ++i) {
        const MirrorLink& link = mirror_links_[i];
        Real* const ghost = slot(link.ghost_slot, link.ghost_row);
        Real* const real = slot(link.real_slot, link.real_row);
        if (filling) {
            std::copy(real + begin_ - 1, real + end_ + 1, ghost + begin_ - 1);
        } else {
            std::copy(ghost + begin_, ghost + end_, real + begin_);
        }
    }
}

template <class Real>
void D3q19<Real>::ends(const Share& share, bool filling) {
    for (std::size_t i = share.begin(end_links_.size()); i < share.end(end_links_.size()); ++i) {
        const EndLink& link = end_links_[i];
        if (link.low ? begin_ > 0 : end_ < nx_) {
            continue;
        }
        Real& beside = slot(opposite(link.q), link.source_row)[link.low ? -1 : nx_];
        Real& inside = slot(link.q, link.row)[link.low ? 0 : nx_ - 1];
        if (filling) {
            beside = link.sign * inside + link.velocity;
        } else {
            inside = link.sign * beside + link.velocity;
        }
    }
}

template <class Real>
void D3q19<Real>::walls(const Share& share, bool filling) {
    Real* const scratch = scratch_[share.index].data();
    for (std::size_t i = share.begin(cut_links_.size()); i < share.end(cut_links_.size()); ++i) {
        const CutLink& link = cut_links_[i];
        if (link.slip_point < 0) {
            rigid_row(link, begin_, end_, filling);
            continue;
        }
        // A population that crosses the lip meets the rigid wall, from either side.
        const int cx = d3q19::velocity[link.q].x;
        const bool outlet = cx > 0 && slip_end_ == nx_ && ends_ == Ends::inflow_outflow;
        const auto in_window = [this](int x) { return std::clamp(x, begin_, end_); };
        const int begin = in_window(slip_begin_ + (cx < 0 && slip_begin_ > 0 ? 1 : 0));
        const int end = in_window(slip_end_ - (cx > 0 && (slip_end_ < nx_ || outlet) ? 1 : 0));
        slip_momentum(link, scratch);
        rigid_row(link, begin_, begin, filling);
        slip_row(link, begin, end, scratch, filling);
        if (outlet && end_ == nx_) {
            // Out of the corner of slip wall and outlet: pressure 0, as for the outlet's other populations.
            Real& beside = slot(link.q, link.ghost_row)[nx_];
            Real& inside = slot(opposite(link.q), link.row)[nx_ - 1];
            (filling ? beside : inside) = -(filling ? inside : beside);
        } else {
            rigid_row(link, end, end_, filling);
        }
    }
}

template <class Real>
void D3q19<Real>::rigid_row(const CutLink& link, int begin, int end, bool filling) {
    if (begin >= end) {
        return;
    }
    const int cx = d3q19::velocity[link.q].x;
    const int back = opposite(link.q);
    Real* const ghost = slot(link.q, link.ghost_row) + cx + begin;
    Real* const home = slot(back, link.row) + begin;
    const Real* const far = slot(back, link.far_row) - cx + begin;
    const Real* const own = slot(link.q, link.row) + begin;
    kernels_->link({.destination = filling ? ghost : home,
                    .near = filling ? home : ghost,
                    .far = filling ? far : own,
                    .back = filling ? own : far,
                    .wall = nullptr,
                    .wall_constant = link.wall,
                    .kappa = link.kappa,
                    .nodes = end - begin});
}

template <class Real>
void D3q19<Real>::slip_row(const CutLink& link, int begin, int end, const Real* wall, bool filling) {
    if (begin >= end) {
        return;
    }
    // The population sent back at x left the neighbour x + c_x with the same velocity along x.
    const int cx = d3q19::velocity[link.q].x;
    const int back = opposite(link.q);
    const int sent = d3q19::mirrored_x(link.q);
    const int from = filling ? begin + cx : begin;
    Real* const home = slot(back, link.row) + begin;
    Real* const ghost = slot(link.q, link.ghost_row) + from;
    const Real* const near =
        filling ? slot(opposite(sent), link.row) + from : slot(sent, link.ghost_row) + from;
    const Real* const far = filling ? slot(opposite(sent), link.far_row) + from : slot(sent, link.row) + from;
    const Real* const own = filling ? slot(link.q, link.row) + from : slot(back, link.far_row) + from;
    kernels_->link({.destination = filling ? ghost : home,
                    .near = near,
                    .far = far,
                    .back = own,
                    .wall = wall + begin,
                    .wall_constant = 0,
                    .kappa = link.kappa,
                    .nodes = end - begin});
}

template <class Real>
void D3q19<Real>::slip_velocities(const Share& share, Real follow) {
    const std::size_t last = share.end(slip_points_.size());
    for (std::size_t i = share.begin(slip_points_.size()); i < last; ++i) {
        const SlipPoint& slip = slip_points_[i];
        Real* const around = slip_around(static_cast<int>(i));
        for (int x = std::max(slip_begin_, begin_); x < std::min(slip_end_, end_); ++x) {
            Real v = 0;
            for (int k = 0; k < 4; ++k) {
                const std::ptrdiff_t place = offset(slip.row[k]) + x;
                v += slip.y[k] * velocity_[1][place] + slip.z[k] * velocity_[2][place];
            }
            around[x] += follow * (v - around[x]);
        }
    }
}

template <class Real>
void D3q19<Real>::slip_momentum(const CutLink& link, Real* wall) const {
    const Real* const around = slip_around(link.slip_point);
    for (int x = std::max(slip_begin_, begin_); x < std::min(slip_end_, end_); ++x) {
        wall[x] = link.slip_around * around[x];
    }
}

template class D3q19<float>;
template class D3q19<double>;

}  // namespace bioprint
