#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>

#include "lattice/axisymmetric.hpp"

namespace bioprint::lattice {
namespace {

constexpr double pi = std::numbers::pi;

double dot(std::size_t k, double x, double r) {
    return D2Q9::x[k] * x + D2Q9::r[k] * r;
}

}  // namespace

void AxisymmetricFlow::start(std::span<const double> velocity, std::span<const double> shear,
                             double pressure_slope) {
    assert(!odd_);
    const int rows = domain_.radius;
    double flux = 0.0;
    for (int j = 0; j < rows; ++j) {
        flux += 2.0 * (j + 0.5) * velocity[static_cast<std::size_t>(j)] / (static_cast<double>(rows) * rows);
    }
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < domain_.length; ++i) {
            const bool tube = i < domain_.lip;
            const double u = tube ? velocity[static_cast<std::size_t>(j)] : flux;
            const double d_xr = tube ? 0.5 * shear[static_cast<std::size_t>(j)] : 0.0;
            const double rho =
                domain_.periodic || !tube ? 0.0 : 3.0 * pressure_slope * (domain_.lip - i - 0.5);
            double& t = t_[static_cast<std::size_t>(j) * static_cast<std::size_t>(domain_.length) +
                           static_cast<std::size_t>(i)];
            if (!ink_.uniform()) {
                t = ink_.t_inf + (ink_.t0 - ink_.t_inf) /
                                     (1.0 + std::pow(ink_.time_constant * 2.0 * std::abs(d_xr), ink_.alpha));
            }
            const double n_xr = -d_xr * (t + 0.5) / 1.5;
            const double force = domain_.body_force - n_xr * t / ((t + 0.5) * (j + 0.5));
            const auto p = pointers(i, j);
            for (std::size_t k = 0; k < D2Q9::size; ++k) {
                *p[k] = D2Q9::weight[k] * (rho + 3.0 * D2Q9::x[k] * (u - 0.5 * force)) +
                        0.25 * n_xr * D2Q9::x[k] * D2Q9::r[k];
            }
        }
    }
}

AxisymmetricFlow::Node AxisymmetricFlow::node(int i, int j) const {
    Node n{};
    const auto p = pointers(i, j);
    for (std::size_t k = 0; k < D2Q9::size; ++k) {
        n.f[k] = *p[k];
    }
    const auto at =
        static_cast<std::size_t>(j) * static_cast<std::size_t>(domain_.length) + static_cast<std::size_t>(i);
    n.t = t_[at];
    const double s = 1.0 / (j + 0.5);
    const double diagonal = n.f[5] + n.f[6] + n.f[7] + n.f[8];
    const double xx = n.f[1] + n.f[2] + diagonal;
    const double rr = n.f[3] + n.f[4] + diagonal;
    n.m0 = n.f[0] + n.f[1] + n.f[2] + rr;
    n.n_xx = xx - n.m0 / 3.0;
    n.n_rr = rr - n.m0 / 3.0;
    n.n_xr = n.f[5] + n.f[6] - n.f[7] - n.f[8];
    const double k = n.t / (n.t + 0.5);
    n.fx = domain_.body_force + force_x_[at] - k * n.n_xr * s;
    const double fr = force_r_[at] - k * n.n_rr * s;
    const double nu = n.t / 3.0;
    const double momentum_r = n.f[3] - n.f[4] + n.f[5] - n.f[6] - n.f[7] + n.f[8];
    n.ur = (momentum_r + 0.5 * fr) / (1.0 + nu * s * s);
    n.ux = n.f[1] - n.f[2] + n.f[5] - n.f[6] + n.f[7] - n.f[8] + 0.5 * n.fx;
    n.fr = fr - 2.0 * nu * s * s * n.ur;
    n.source = -n.ur * s;
    return n;
}

AxisymmetricFields AxisymmetricFlow::measure() const {
    AxisymmetricFields fields;
    fields.length = domain_.length;
    fields.radius = domain_.radius;
    const auto size = t_.size();
    for (auto* v : {&fields.velocity_x, &fields.velocity_r, &fields.pressure, &fields.rate, &fields.viscosity,
                    &fields.elongation}) {
        v->resize(size);
    }
    for (int j = 0; j < domain_.radius; ++j) {
        for (int i = 0; i < domain_.length; ++i) {
            const Node n = node(i, j);
            const auto at = fields.at(i, j);
            const double to_rate = -1.5 / (n.t + 0.5);
            const double hoop = n.ur / (j + 0.5);
            const double square = n.n_xx * n.n_xx + n.n_rr * n.n_rr + 2.0 * n.n_xr * n.n_xr;
            fields.velocity_x[at] = n.ux;
            fields.velocity_r[at] = n.ur;
            fields.pressure[at] = (n.m0 + 0.5 * n.source) / 3.0;
            fields.rate[at] = std::sqrt(2.0 * (to_rate * to_rate * square + hoop * hoop));
            fields.viscosity[at] = n.t / 3.0;
            fields.elongation[at] = -to_rate * n.n_xx;
        }
    }
    return fields;
}

double AxisymmetricFlow::flow_rate(int i) const {
    double sum = 0.0;
    for (int j = 0; j < domain_.radius; ++j) {
        sum += 2.0 * pi * (j + 0.5) * node(i, j).ux;
    }
    return sum;
}

// In a steady state of two relaxation times with fixed Λ, velocities and gradients scale alone when
// rate × (non-equilibrium + half the source) scales like velocity in its even part and like stress in its odd
// part.
void AxisymmetricFlow::rescale(double velocity, double viscosity) {
    const double stress = velocity * viscosity;
    for (int j = 0; j < domain_.radius; ++j) {
        for (int i = 0; i < domain_.length; ++i) {
            const Node n = node(i, j);
            const double rho = n.m0 + 0.5 * n.source;
            const auto rates = [](double t) {
                return std::array{1.0 / (t + 0.5), t / (0.5 * t + magic_parameter)};
            };
            const auto [lp, lm] = rates(n.t);
            const auto [lp_new, lm_new] = rates(n.t * viscosity);
            const auto p = pointers(i, j);
            for (std::size_t k = 0; k < D2Q9::size; ++k) {
                const double w = D2Q9::weight[k];
                const auto back = static_cast<std::size_t>(D2Q9::opposite[k]);
                const double even = 0.5 * (n.f[k] + n.f[back]) - w * rho + 0.5 * w * n.source;
                const double odd =
                    0.5 * (n.f[k] - n.f[back]) - 3.0 * w * dot(k, n.ux, n.ur) + 1.5 * w * dot(k, n.fx, n.fr);
                *p[k] = w * stress * rho + velocity * (even * lp / lp_new - 0.5 * w * n.source) +
                        3.0 * w * velocity * dot(k, n.ux, n.ur) +
                        stress * (odd * lm / lm_new - 1.5 * w * dot(k, n.fx, n.fr));
            }
        }
    }
    for (double& t : t_) {
        t *= viscosity;
    }
    for (auto& addition : additions_) {
        for (double& a : addition) {
            a *= velocity;
        }
    }
    domain_.body_force *= stress;
    ink_.t0 *= viscosity;
    ink_.t_inf *= viscosity;
    ink_.time_constant /= velocity;
}

bool AxisymmetricFlow::run_to_steady(double tolerance, long limit, const std::function<bool(double)>& go_on) {
    SteadySearch search;
    return run_to_steady(tolerance, limit, go_on, search);
}

bool AxisymmetricFlow::run_to_steady(double tolerance, long limit, const std::function<bool(double)>& go_on,
                                     SteadySearch& search) {
    const int interval = std::max(32, 2 * domain_.radius);
    while (search.done < limit) {
        for (int n = 0; n < interval; ++n) {
            step();
        }
        search.done += interval;
        const std::vector<double> before = std::exchange(search.before, measure().velocity_x);
        const std::vector<double>& now = search.before;
        if (!before.empty()) {
            double change = 0.0;
            double largest = 0.0;
            for (std::size_t n = 0; n < now.size(); ++n) {
                change = std::max(change, std::abs(now[n] - before[n]));
                largest = std::max(largest, std::abs(now[n]));
            }
            if (!std::isfinite(largest)) {
                return false;
            }
            const double ratio =
                search.last_change > 0.0 ? std::min(change / search.last_change, 0.99) : 0.99;
            search.last_change = change;
            const double distance = change / (1.0 - ratio);
            if (distance <= tolerance * largest && !odd_) {
                return true;
            }
            if (go_on && !go_on(distance / largest)) {
                return false;
            }
        }
    }
    return false;
}

std::vector<double> AxisymmetricFlow::state() const {
    std::vector<double> s{static_cast<double>(steps_), odd_ ? 1.0 : 0.0, domain_.body_force};
    s.insert(s.end(), storage_.begin(), storage_.end());
    s.insert(s.end(), t_.begin(), t_.end());
    return s;
}

void AxisymmetricFlow::restore(std::span<const double> s) {
    assert(s.size() == 3 + storage_.size() + t_.size());
    steps_ = static_cast<long>(s[0]);
    odd_ = s[1] != 0.0;
    domain_.body_force = s[2];
    const auto populations = s.subspan(3, storage_.size());
    std::copy(populations.begin(), populations.end(), storage_.begin());
    const auto t = s.subspan(3 + storage_.size());
    std::copy(t.begin(), t.end(), t_.begin());
}

}  // namespace bioprint::lattice
