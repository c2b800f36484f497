#include "simulate/immersed_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bioprint {
namespace {

int layers_of(const ImmersedCellSetup& setup) {
    return std::max(2, static_cast<int>(std::lround((setup.radius - setup.retraction) / setup.spacing)));
}

/// The four nodes about a point: bilinear weights; row −1 is row 0 seen in the axis.
struct Stencil {
    std::array<std::size_t, 4> node;
    std::array<double, 4> weight;
    std::array<double, 4> radial_weight;
    std::array<double, 4> inverse_radius;
};

Stencil stencil(const solid::RingPoint& p, const lattice::AxisymmetricDomain& domain) {
    Stencil s{};
    const double column = std::floor(p.x - 0.5);
    const double row = std::floor(p.r - 0.5);
    const double fx = p.x - 0.5 - column;
    const double fr = p.r - 0.5 - row;
    const int n = domain.length;
    std::size_t m = 0;
    for (int b = 0; b < 2; ++b) {
        const int j = static_cast<int>(row) + b;
        const int folded = j < 0 ? -1 - j : std::min(j, domain.radius - 1);
        for (int a = 0; a < 2; ++a, ++m) {
            const int i = ((static_cast<int>(column) + a) % n + n) % n;
            s.node[m] =
                static_cast<std::size_t>(folded) * static_cast<std::size_t>(n) + static_cast<std::size_t>(i);
            s.weight[m] = (a == 0 ? 1.0 - fx : fx) * (b == 0 ? 1.0 - fr : fr);
            s.radial_weight[m] = j < 0 ? -s.weight[m] : s.weight[m];
            s.inverse_radius[m] = 1.0 / (folded + 0.5);
        }
    }
    return s;
}

}  // namespace

ImmersedCell::ImmersedCell(const ImmersedCellSetup& setup, double centre)
    : setup_(setup),
      body_(solid::half_disk(setup.radius - setup.retraction, layers_of(setup))),
      volume_(body_.mesh()),
      stiffened_{},
      position_(body_.mesh().vertices),
      force_(position_.size()) {
    const double stiffer = std::pow(setup.radius / body_.mesh().radius, 3.0);
    stiffened_ = {.shear_modulus = setup.shear_modulus * stiffer,
                  .bulk_modulus = setup.bulk_modulus * stiffer};
    shift(centre);
}

void ImmersedCell::shift(double x) {
    for (auto& p : position_) {
        p.x += x;
    }
}

void ImmersedCell::set_positions(std::span<const solid::RingPoint> position) {
    position_.assign(position.begin(), position.end());
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
            const int i = ((loaded_.begin + c) % n + n) % n;
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(j) * n + i;
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
    body_.energy(position_, stiffened_, force_);
    constexpr double two_pi = 2.0 * std::numbers::pi;
    for (std::size_t v = 0; v < position_.size(); ++v) {
        const Stencil s = stencil(position_[v], flow.domain());
        for (std::size_t m = 0; m < 4; ++m) {
            const double per_ring = s.inverse_radius[m] / two_pi;
            flow.force_x()[s.node[m]] += force_[v].x * s.weight[m] * per_ring;
            flow.force_r()[s.node[m]] += force_[v].r * s.radial_weight[m] * per_ring;
        }
    }
}

void ImmersedCell::move(const lattice::AxisymmetricFlow& flow) {
    for (std::size_t v = 0; v < position_.size(); ++v) {
        const Stencil s = stencil(position_[v], flow.domain());
        double ux = 0.0;
        double ur = 0.0;
        for (std::size_t m = 0; m < 4; ++m) {
            ux += s.weight[m] * flow.velocity_x()[s.node[m]];
            ur += s.radial_weight[m] * flow.velocity_r()[s.node[m]];
        }
        position_[v].x += ux;
        if (!body_.mesh().on_axis(static_cast<int>(v))) {
            position_[v].r += ur;
        }
    }
    if (setup_.volume_strength > 0.0) {
        volume_.apply(position_, setup_.volume_strength);
    }
}

solid::RingShape ImmersedCell::shape() const {
    return body_.shape(position_, {.shear_modulus = setup_.shear_modulus});
}

}  // namespace bioprint
