#include "simulate/immersed_body.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"

namespace bioprint {

template <class Real>
ImmersedBody<Real>::ImmersedBody(const ImmersedBodySetup& setup, D3q19<Real>& lattice, const Vector3& centre)
    : setup_(setup),
      lattice_(lattice),
      half_(lattice.section().mirror_low),
      solid_(ball_mesh(setup.radius, setup.spacing, half_),
             {.shear_modulus = setup.shear_modulus, .bulk_modulus = setup.bulk_modulus}, half_),
      inside_(solid_.mesh(), half_),
      volume_(solid_.mesh(), half_),
      is_touched_(lattice.rows(), 0),
      position_(solid_.mesh().nodes),
      velocity_(solid_.nodes()) {
    const Section& s = lattice_.section();
    for (int z = -1; z <= s.nz; ++z) {
        for (int y = -1; y <= s.ny; ++y) {
            row_of_.push_back(lattice_.row(y, z));
        }
    }
    for (auto& p : position_) {
        for (int i = 0; i < 3; ++i) {
            p[i] += centre[i];
        }
    }
    const std::size_t points = setup_.inside ? inside_.size() : position_.size();
    stencil_.resize(points);
    point_velocity_.resize(points);
}

template <class Real>
typename ImmersedBody<Real>::Stencil ImmersedBody<Real>::stencil(const Vector3& point) const {
    const Section& s = lattice_.section();
    const double at_x = point[0] - 0.5;
    const double at_y = point[1] + s.origin_y - 0.5;
    const double at_z = point[2] + s.origin_z - 0.5;
    const double x = std::floor(at_x);
    const double y = std::floor(at_y);
    const double z = std::floor(at_z);
    const int nx = lattice_.nx();
    if (!(y >= -1.0 && y < s.ny && z >= -1.0 && z < s.nz && std::abs(x) < 1e9)) {
        throw NotConverged("the cell left the fluid");
    }
    Stencil stencil{};
    stencil.x = static_cast<int>(x - nx * std::floor(x / nx));
    stencil.next_x = stencil.x + 1 == nx ? 0 : stencil.x + 1;
    stencil.share = at_x - x;
    stencil.low_sign = z < 0.0 && half_ ? -1.0 : 1.0;
    const double wy = at_y - y;
    const double wz = at_z - z;
    stencil.weight = {(1 - wy) * (1 - wz), wy * (1 - wz), (1 - wy) * wz, wy * wz};
    const int first = (static_cast<int>(z) + 1) * (s.ny + 2) + static_cast<int>(y) + 1;
    stencil.row = {row_of_[first], row_of_[first + 1], row_of_[first + s.ny + 2], row_of_[first + s.ny + 3]};
    for (const int row : stencil.row) {
        if (row < 0) {
            throw NotConverged("the cell touches a wall");
        }
    }
    return stencil;
}

template <class Real>
void ImmersedBody<Real>::clear() {
    for (const int row : touched_) {
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(lattice_.force(axis, row), lattice_.nx(), Real(0));
        }
        is_touched_[row] = 0;
    }
}

template <class Real>
void ImmersedBody<Real>::load() {
    if (solid_.forces(position_, force_) > 0) {
        throw NotConverged(
            "an element of the cell turned inside out; take a stiffer --shear-modulus, a lower --velocity, "
            "or a --channel-time that ends before");
    }
    const std::vector<Vector3>* points = &position_;
    const std::vector<Vector3>* forces = &force_;
    if (setup_.inside) {
        inside_.place(position_, point_);
        inside_.spread(force_, point_force_);
        points = &point_;
        forces = &point_force_;
    }
    const std::vector<int> before = touched_;
    clear();
    touched_.clear();
    for (std::size_t q = 0; q < points->size(); ++q) {
        const Stencil s = stencil((*points)[q]);
        const Vector3& f = (*forces)[q];
        stencil_[q] = s;
        for (int k = 0; k < 4; ++k) {
            const int row = s.row[k];
            if (is_touched_[row] == 0) {
                is_touched_[row] = 1;
                touched_.push_back(row);
                lattice_.set_coupling(row, d3q19::Coupling::coupled);
            }
            for (int axis = 0; axis < 3; ++axis) {
                const double sign = axis == 2 && k < 2 ? s.low_sign : 1.0;
                const double value = sign * s.weight[k] * f[axis];
                Real* const field = lattice_.force(axis, row);
                field[s.x] += static_cast<Real>((1.0 - s.share) * value);
                field[s.next_x] += static_cast<Real>(s.share * value);
            }
        }
    }
    for (const int row : before) {
        if (is_touched_[row] == 0) {
            lattice_.set_coupling(row, d3q19::Coupling::none);
        }
    }
}

template <class Real>
void ImmersedBody<Real>::move() {
    for (std::size_t q = 0; q < stencil_.size(); ++q) {
        const Stencil& s = stencil_[q];
        Vector3 u{};
        for (int k = 0; k < 4; ++k) {
            for (int axis = 0; axis < 3; ++axis) {
                const double sign = axis == 2 && k < 2 ? s.low_sign : 1.0;
                const Real* const field = lattice_.velocity(axis, s.row[k]);
                const double here = static_cast<double>(field[s.x]);
                const double there = static_cast<double>(field[s.next_x]);
                u[axis] += sign * s.weight[k] * (here + s.share * (there - here));
            }
        }
        point_velocity_[q] = u;
    }
    if (setup_.inside) {
        inside_.gather(point_velocity_, velocity_);
    } else {
        velocity_ = point_velocity_;
    }
    for (std::size_t n = 0; n < position_.size(); ++n) {
        const bool in_mirror = half_ && solid_.mesh().nodes[n][2] == 0.0;
        for (int axis = 0; axis < (in_mirror ? 2 : 3); ++axis) {
            position_[n][axis] += velocity_[n][axis];
        }
    }
    if (setup_.volume_strength > 0.0) {
        volume_.relax(position_, setup_.volume_strength);
    }
}

template <class Real>
void ImmersedBody<Real>::shift(const Vector3& by) {
    for (Vector3& p : position_) {
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] += by[axis];
        }
    }
}

template <class Real>
std::vector<double> ImmersedBody<Real>::record() const {
    std::vector<double> record;
    for (const Vector3& p : position_) {
        record.insert(record.end(), p.begin(), p.end());
    }
    return record;
}

template <class Real>
void ImmersedBody<Real>::restore(std::span<const double> record) {
    if (record.size() != 3 * position_.size()) {
        throw DataError("the checkpoint is of another mesh");
    }
    for (std::size_t n = 0; n < position_.size(); ++n) {
        std::copy_n(record.begin() + static_cast<std::ptrdiff_t>(3 * n), 3, position_[n].begin());
    }
}

template class ImmersedBody<float>;
template class ImmersedBody<double>;

}  // namespace bioprint
