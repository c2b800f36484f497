#include "lattice/axisymmetric.hpp"

#include <algorithm>
#include <cassert>

namespace bioprint::lattice {
namespace {

/// Array starts one page and a few lines apart keep the nine streams out of each other's cache sets.
constexpr std::ptrdiff_t stagger = std::ptrdiff_t{8} * 13;

}  // namespace

AxisymmetricFlow::AxisymmetricFlow(const AxisymmetricDomain& domain, const CrossRelaxation& ink,
                                   std::span<const double> inflow_nodes, std::span<const double> inflow_links)
    : domain_(domain), ink_(ink), row_(domain.length + 2 * margin) {
    assert(domain.periodic || (inflow_nodes.size() == static_cast<std::size_t>(domain.radius) &&
                               inflow_links.size() == static_cast<std::size_t>(domain.radius) + 1));
    const std::ptrdiff_t plane = row_ * (domain.radius + 2) + stagger;
    storage_.assign(static_cast<std::size_t>(plane) * D2Q9::size, 0.0);
    for (std::size_t k = 0; k < D2Q9::size; ++k) {
        f_[k] = storage_.data() + static_cast<std::ptrdiff_t>(k) * plane;
    }
    const auto nodes = static_cast<std::size_t>(domain.length) * static_cast<std::size_t>(domain.radius);
    t_.assign(nodes, ink.uniform() ? ink.uniform_t() : ink.t0);
    force_x_.assign(nodes, 0.0);
    force_r_.assign(nodes, 0.0);
    velocity_x_.assign(nodes, 0.0);
    velocity_r_.assign(nodes, 0.0);
    link_rows();
    if (domain.periodic) {
        link_periodic_ends();
    } else {
        link_open_ends(inflow_nodes, inflow_links);
    }
}

// A population that comes in at the border is, with a sign and a constant, one that left: after an even step
// both wait beside their nodes, after an odd step they have moved already.
void AxisymmetricFlow::link(const Link& link, std::span<const double> add) {
    const auto k = static_cast<std::size_t>(link.direction);
    const auto m = static_cast<std::size_t>(link.from);
    const auto back = static_cast<std::size_t>(D2Q9::opposite[k]);
    const auto from_back = static_cast<std::size_t>(D2Q9::opposite[m]);
    const double* addition = nullptr;
    if (!add.empty()) {
        additions_.emplace_back(add.begin(), add.end());
        addition = additions_.back().data();
    }
    const std::ptrdiff_t stride = link.along_row ? 1 : row_;
    after_even_.push_back({.to = f_[back] + index(link.i - D2Q9::x[k], link.j - D2Q9::r[k]),
                           .from = f_[from_back] + index(link.from_i, link.from_j),
                           .count = link.count,
                           .stride = stride,
                           .sign = link.sign,
                           .add = addition});
    after_odd_.push_back({.to = f_[k] + index(link.i, link.j),
                          .from = f_[m] + index(link.from_i + D2Q9::x[m], link.from_j + D2Q9::r[m]),
                          .count = link.count,
                          .stride = stride,
                          .sign = link.sign,
                          .add = addition});
}

void AxisymmetricFlow::link_rows() {
    const int n = domain_.length;
    const int top = domain_.radius - 1;
    const int lip = domain_.lip;
    // Columns whose diagonal neighbours exist; the ends see to the others.
    const auto specular = [&](int k, int j, int begin, int end) {
        const auto kk = static_cast<std::size_t>(k);
        const int shift = D2Q9::x[kk];
        const auto reflect = [&](int first, int from, int count) {
            link({.direction = k,
                  .i = first,
                  .j = j,
                  .from = D2Q9::mirror[kk],
                  .from_i = from,
                  .from_j = j,
                  .count = count,
                  .along_row = true,
                  .sign = 1.0});
        };
        const int first = std::max(begin, shift);
        const int last = std::min(end, n + shift);
        if (first < last) {
            reflect(first, first - shift, last - first);
        }
        if (domain_.periodic && shift != 0) {
            reflect(shift > 0 ? 0 : n - 1, shift > 0 ? n - 1 : 0, 1);
        }
    };
    const auto bounce = [&](int k, int j, int begin, int end) {
        const auto kk = static_cast<std::size_t>(k);
        const int first = domain_.periodic ? begin : std::max(begin, D2Q9::x[kk]);
        const int last = domain_.periodic ? end : std::min(end, n + D2Q9::x[kk]);
        if (first < last) {
            link({.direction = k,
                  .i = first,
                  .j = j,
                  .from = D2Q9::opposite[kk],
                  .from_i = first,
                  .from_j = j,
                  .count = last - first,
                  .along_row = true,
                  .sign = 1.0});
        }
    };
    for (const int k : {3, 5, 8}) {
        specular(k, 0, 0, n);
    }
    for (const int k : {4, 6, 7}) {
        bounce(k, top, 0, lip);
    }
    if (lip < n) {
        specular(4, top, lip, n);
        specular(6, top, lip, n);
        bounce(7, top, lip, lip + 1);
        specular(7, top, lip + 1, n);
    }
}

void AxisymmetricFlow::link_periodic_ends() {
    const int n = domain_.length;
    const int rows = domain_.radius;
    for (int k = 1; k < D2Q9::size; ++k) {
        const auto kk = static_cast<std::size_t>(k);
        if (D2Q9::x[kk] != 0) {
            const bool right = D2Q9::x[kk] > 0;
            const int first = D2Q9::r[kk] == 1 ? 1 : 0;
            const int last = D2Q9::r[kk] == -1 ? rows - 1 : rows;
            link({.direction = k,
                  .i = right ? 0 : n - 1,
                  .j = first,
                  .from = k,
                  .from_i = right ? n - 1 : 0,
                  .from_j = first - D2Q9::r[kk],
                  .count = last - first,
                  .along_row = false,
                  .sign = 1.0});
        }
    }
}

void AxisymmetricFlow::link_open_ends(std::span<const double> nodes, std::span<const double> links) {
    const int n = domain_.length;
    const int rows = domain_.radius;
    for (const int k : {1, 5, 7}) {
        const auto kk = static_cast<std::size_t>(k);
        std::vector<double> add(static_cast<std::size_t>(rows));
        for (std::size_t j = 0; j < add.size(); ++j) {
            const double u = k == 1 ? nodes[j] : links[k == 5 ? j : j + 1];
            add[j] = 6.0 * D2Q9::weight[kk] * u;
        }
        link({.direction = k,
              .i = 0,
              .j = 0,
              .from = D2Q9::opposite[kk],
              .from_i = 0,
              .from_j = 0,
              .count = rows,
              .along_row = false,
              .sign = 1.0},
             add);
    }
    for (const int k : {2, 6, 8}) {
        const auto kk = static_cast<std::size_t>(k);
        link({.direction = k,
              .i = n - 1,
              .j = 0,
              .from = D2Q9::opposite[kk],
              .from_i = n - 1,
              .from_j = 0,
              .count = rows,
              .along_row = false,
              .sign = -1.0});
    }
}

std::array<double*, D2Q9::size> AxisymmetricFlow::pointers(int i, int j) const {
    std::array<double*, D2Q9::size> p{};
    const std::ptrdiff_t here = index(i, j);
    for (std::size_t k = 0; k < D2Q9::size; ++k) {
        p[k] = odd_ ? f_[static_cast<std::size_t>(D2Q9::opposite[k])] + here - D2Q9::x[k] - D2Q9::r[k] * row_
                    : f_[k] + here;
    }
    return p;
}

void AxisymmetricFlow::collide_row(int j, const KernelTable& table, bool update) {
    const int n = domain_.length;
    const auto stretch = [&](int begin, int end, bool forced) {
        if (begin >= end) {
            return;
        }
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(j) * n + begin;
        const RowStretch row{.population = pointers(begin, j),
                             .t = t_.data() + at,
                             .force_x = forced ? force_x_.data() + at : nullptr,
                             .force_r = forced ? force_r_.data() + at : nullptr,
                             .velocity_x = forced ? velocity_x_.data() + at : nullptr,
                             .velocity_r = forced ? velocity_r_.data() + at : nullptr,
                             .count = end - begin,
                             .inverse_radius = 1.0 / (j + 0.5),
                             .body_force = domain_.body_force};
        if (forced) {
            (update ? table.forced_update : table.forced)(row, ink_);
        } else {
            (update ? table.plain_update : table.plain)(row, ink_);
        }
    };
    if (j >= window_.rows || window_.columns == 0) {
        stretch(0, n, false);
        return;
    }
    if (window_.columns >= n) {
        stretch(0, n, true);
        return;
    }
    const int begin = ((window_.begin % n) + n) % n;
    const int end = begin + window_.columns;
    if (end <= n) {
        stretch(0, begin, false);
        stretch(begin, end, true);
        stretch(end, n, false);
    } else {
        stretch(0, end - n, true);
        stretch(end - n, begin, false);
        stretch(begin, n, true);
    }
}

void AxisymmetricFlow::step() {
    const KernelTable& table = kernels(ink_);
    const bool update = !ink_.uniform() && steps_ % domain_.viscosity_interval == 0;
    for (int j = 0; j < domain_.radius; ++j) {
        collide_row(j, table, update);
    }
    for (const Copy& c : odd_ ? after_odd_ : after_even_) {
        if (c.stride == 1 && c.add == nullptr && c.sign == 1.0) {
            std::copy_n(c.from, c.count, c.to);
            continue;
        }
        for (int n = 0; n < c.count; ++n) {
            const std::ptrdiff_t at = n * c.stride;
            c.to[at] = c.sign * c.from[at] + (c.add == nullptr ? 0.0 : c.add[n]);
        }
    }
    odd_ = !odd_;
    ++steps_;
}

}  // namespace bioprint::lattice
