#include "simulate/immersed_cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bioprint/errors.hpp"

namespace bioprint {
namespace {

/// Far above any velocity of a sound run and far below what would carry a vertex out of the lattice.
constexpr double largest_velocity = 0.5;

int layers_of(const ImmersedCellSetup& setup) {
    return std::max(2, static_cast<int>(std::lround((setup.radius - setup.retraction) / setup.spacing)));
}

/// i modulo n for an i that is at most one period outside; the division only when it strays further.
int wrapped(int i, int n) {
    if (i < 0) {
        i += n;
    } else if (i >= n) {
        i -= n;
    }
    return i >= 0 && i < n ? i : ((i % n) + n) % n;
}

}  // namespace

ImmersedCell::Stencil ImmersedCell::stencil(const solid::RingPoint& p,
                                            const lattice::AxisymmetricDomain& domain) {
    Stencil s{};
    const double column = std::floor(p.x - 0.5);
    const double row = std::floor(p.r - 0.5);
    const std::array<double, 2> wx{1.0 - (p.x - 0.5 - column), p.x - 0.5 - column};
    const std::array<double, 2> wr{1.0 - (p.r - 0.5 - row), p.r - 0.5 - row};
    const int n = domain.length;
    const std::array<int, 2> i{wrapped(static_cast<int>(column), n),
                               wrapped(static_cast<int>(column) + 1, n)};
    std::size_t m = 0;
    for (std::size_t b = 0; b < 2; ++b) {
        const int j = static_cast<int>(row) + static_cast<int>(b);
        const int folded = j < 0 ? -1 - j : std::min(j, domain.radius - 1);
        for (std::size_t a = 0; a < 2; ++a, ++m) {
            s.node[m] = static_cast<std::size_t>(folded) * static_cast<std::size_t>(n) +
                        static_cast<std::size_t>(i[a]);
            s.weight[m] = wx[a] * wr[b];
            s.radial_weight[m] = j < 0 ? -s.weight[m] : s.weight[m];
            s.inverse_radius[m] = 1.0 / (folded + 0.5);
        }
    }
    return s;
}

ImmersedCell::ImmersedCell(const ImmersedCellSetup& setup, double centre)
    : setup_(setup),
      body_(solid::half_disk(setup.radius - setup.retraction, layers_of(setup))),
      volume_(body_.mesh()),
      inside_(body_.mesh()),
      stiffened_{},
      position_(body_.mesh().vertices),
      mean_position_(position_),
      vertex_velocity_(position_.size(), {.x = 0.0, .r = 0.0}),
      force_(position_.size()) {
    const double stiffer = std::pow(setup.radius / body_.mesh().radius, 3.0);
    stiffened_ = {.shear_modulus = setup.shear_modulus * stiffer,
                  .bulk_modulus = setup.bulk_modulus * stiffer};
    const std::size_t points = setup.coupling == Coupling::inside ? inside_.size() : position_.size();
    point_.resize(points);
    point_velocity_.resize(points);
    point_force_.resize(points);
    stencil_.resize(points);
    shift(centre);
}

void ImmersedCell::shift(double x) {
    for (auto& p : position_) {
        p.x += x;
    }
}

void ImmersedCell::set_positions(std::span<const solid::RingPoint> position) {
    position_.assign(position.begin(), position.end());
    std::fill(vertex_velocity_.begin(), vertex_velocity_.end(), solid::RingPoint{.x = 0.0, .r = 0.0});
}

std::vector<double> ImmersedCell::state() const {
    std::vector<double> flat;
    flat.reserve(4 * position_.size());
    for (const auto* const list : {&position_, &vertex_velocity_}) {
        for (const auto& p : *list) {
            flat.push_back(p.x);
            flat.push_back(p.r);
        }
    }
    return flat;
}

void ImmersedCell::restore(std::span<const double> state) {
    const std::size_t count = position_.size();
    if (state.size() != 4 * count) {
        throw DataError("the checkpoint is of another mesh");
    }
    for (std::size_t v = 0; v < count; ++v) {
        position_[v] = {.x = state[2 * v], .r = state[2 * v + 1]};
        vertex_velocity_[v] = {.x = state[2 * (count + v)], .r = state[2 * (count + v) + 1]};
    }
}

lattice::ForceWindow ImmersedCell::window() const {
    double low = position_.front().x;
    double high = low;
    double top = 0.0;
    for (const auto& p : position_) {
        low = std::min(low, p.x);
        high = std::max(high, p.x);
        top = std::max(top, p.r);
    }
    const int begin = static_cast<int>(std::floor((low - 1.0) / 8.0)) * 8;
    const int end = static_cast<int>(std::floor((high + 1.0) / 8.0)) * 8 + 8;
    return {.begin = begin, .columns = end - begin, .rows = static_cast<int>(top) + 2};
}

void ImmersedCell::clear(lattice::AxisymmetricFlow& flow) const {
    const int n = flow.domain().length;
    const int rows = std::min(loaded_.rows, flow.domain().radius);
    for (int j = 0; j < rows; ++j) {
        for (int c = 0; c < std::min(loaded_.columns, n); ++c) {
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(j) * n + wrapped(loaded_.begin + c, n);
            flow.force_x()[at] = 0.0;
            flow.force_r()[at] = 0.0;
        }
    }
}

void ImmersedCell::load(lattice::AxisymmetricFlow& flow) {
    clear(flow);
    loaded_ = window();
    flow.set_window(loaded_);
    std::fill(force_.begin(), force_.end(), solid::RingForce{.x = 0.0, .r = 0.0});
    for (std::size_t v = 0; v < position_.size(); ++v) {
        mean_position_[v] = {.x = position_[v].x - 0.5 * vertex_velocity_[v].x,
                             .r = position_[v].r - 0.5 * vertex_velocity_[v].r};
    }
    body_.energy(mean_position_, stiffened_, force_);
    if (setup_.coupling == Coupling::inside) {
        inside_.place(position_, point_);
        inside_.spread(force_, point_force_);
    } else {
        point_ = position_;
        point_force_ = force_;
    }
    constexpr double per_turn = 0.5 / std::numbers::pi;
    for (std::size_t q = 0; q < point_.size(); ++q) {
        const Stencil s = stencil(point_[q], flow.domain());
        for (std::size_t m = 0; m < 4; ++m) {
            const double per_ring = s.inverse_radius[m] * per_turn;
            flow.force_x()[s.node[m]] += point_force_[q].x * s.weight[m] * per_ring;
            flow.force_r()[s.node[m]] += point_force_[q].r * s.radial_weight[m] * per_ring;
        }
        stencil_[q] = s;
    }
}

bool ImmersedCell::move(const lattice::AxisymmetricFlow& flow) {
    for (std::size_t q = 0; q < point_.size(); ++q) {
        const Stencil& s = stencil_[q];
        solid::RingPoint u{.x = 0.0, .r = 0.0};
        for (std::size_t m = 0; m < 4; ++m) {
            u.x += s.weight[m] * flow.velocity_x()[s.node[m]];
            u.r += s.radial_weight[m] * flow.velocity_r()[s.node[m]];
        }
        point_velocity_[q] = u;
    }
    if (setup_.coupling == Coupling::inside) {
        inside_.gather(point_velocity_, vertex_velocity_);
    } else {
        vertex_velocity_ = point_velocity_;
    }
    for (const auto& u : vertex_velocity_) {
        if (!(std::abs(u.x) < largest_velocity && std::abs(u.r) < largest_velocity)) {
            return false;
        }
    }
    for (std::size_t v = 0; v < position_.size(); ++v) {
        position_[v].x += vertex_velocity_[v].x;
        if (body_.mesh().on_axis(static_cast<int>(v))) {
            vertex_velocity_[v].r = 0.0;
        }
        position_[v].r += vertex_velocity_[v].r;
    }
    if (setup_.volume_strength > 0.0) {
        for (int sweep = 0; sweep < setup_.volume_sweeps; ++sweep) {
            volume_.apply(position_, setup_.volume_strength);
        }
    }
    return true;
}

solid::RingShape ImmersedCell::shape() const {
    return body_.shape(position_, {.shear_modulus = setup_.shear_modulus});
}

std::vector<double> ImmersedCell::von_mises() const {
    return body_.von_mises(position_, {.shear_modulus = setup_.shear_modulus});
}

}  // namespace bioprint
