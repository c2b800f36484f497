#include "lattice/d3q19.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bioprint/errors.hpp"
#include "lattice/d3q19_stencil.hpp"

namespace bioprint {

using d3q19::Coupling;
using d3q19::directions;
using d3q19::opposite;
using d3q19::weight;

namespace {

constexpr double magic_number = 3.0 / 16.0;  // puts half-way walls exactly half-way in plane Poiseuille flow
constexpr int row_padding = 16;

void check(const D3q19Setup& setup) {
    if (setup.nx < 16 || setup.nx % 16 != 0) {
        throw UsageError("a 3-D lattice needs a length of a multiple of 16 nodes, got " +
                         std::to_string(setup.nx));
    }
    const LatticeViscosity& v = setup.viscosity;
    if (!(v.nu0 > 0.0) || !(v.nu_inf >= 0.0) || v.nu_inf > v.nu0 || !(v.alpha >= 0.0) || v.alpha > 2.0 ||
        !(v.time_constant >= 0.0)) {
        throw UsageError("a lattice viscosity needs 0 <= nu_inf <= nu0, nu0 > 0 and 0 <= alpha <= 2");
    }
    if (setup.ends == Ends::inflow_outflow && !setup.inflow) {
        throw UsageError("an inflow needs a velocity profile");
    }
    if (setup.slip_begin < setup.slip_end && setup.section.radius < 6.0) {
        throw UsageError("free-slip walls need a round section of radius 6 nodes or more");
    }
}

}  // namespace

double LatticeViscosity::at(double rate) const {
    if (time_constant == 0.0) {
        return nu0;
    }
    return nu_inf + (nu0 - nu_inf) / (1.0 + std::pow(time_constant * rate, alpha));
}

template <class Real>
D3q19<Real>::D3q19(const D3q19Setup& setup)
    : nx_(setup.nx),
      section_(setup.section),
      viscosity_(setup.viscosity),
      body_force_(setup.body_force),
      ends_(setup.ends),
      inflow_(setup.inflow),
      slip_begin_(std::max(setup.slip_begin, 0)),
      slip_end_(std::min(setup.slip_end, setup.nx)),
      begin_(0),
      end_(setup.nx),
      threads_(std::max(setup.threads, 1)),
      kernels_(d3q19::kernels<Real>(setup.instructions)) {
    check(setup);
    if (kernels_ == nullptr) {
        throw UsageError("this processor has not the instruction set asked for");
    }
    const double newtonian =
        viscosity_.time_constant == 0.0 ? viscosity_.nu0 : 0.5 * (viscosity_.nu0 + viscosity_.nu_inf);
    cross_ = viscosity_.time_constant > 0.0 && viscosity_.alpha > 0.0;
    constants_.t0 = static_cast<Real>(3.0 * (cross_ ? viscosity_.nu0 : newtonian));
    constants_.t_inf = static_cast<Real>(3.0 * viscosity_.nu_inf);
    constants_.rate_factor = static_cast<Real>(4.5 * viscosity_.time_constant * viscosity_.time_constant);
    constants_.half_alpha = static_cast<Real>(0.5 * viscosity_.alpha);
    constants_.magic = static_cast<Real>(magic_number);
    set_body_force(body_force_);
    build_rows();
    build_links();
    allocate();
    initialise([](double, double, double) { return FlowState{}; });
}

template <class Real>
void D3q19<Real>::build_rows() {
    row_of_.assign(static_cast<std::size_t>(section_.ny) * section_.nz, -1);
    for (int z = 0; z < section_.nz; ++z) {
        for (int y = 0; y < section_.ny; ++y) {
            if (section_.is_fluid(y, z)) {
                row_of_[static_cast<std::size_t>(z) * section_.ny + y] = fluid_rows_++;
                place_of_.push_back({y, z});
            }
        }
    }
    if (fluid_rows_ == 0) {
        throw UsageError("the section holds no fluid");
    }
    all_rows_ = fluid_rows_;
    neighbour_.assign(fluid_rows_, {});
    coupling_.assign(fluid_rows_, Coupling::none);
    observed_.assign(fluid_rows_, 0);
    // Ghost rows behind mirrors come first, for they take part in the wrapping of periodic ends.
    for (const bool behind_mirror : {true, false}) {
        for (int r = 0; r < fluid_rows_; ++r) {
            for (int k = 0; k < 9; ++k) {
                const int y = place_of_[r][0] + k / 3 - 1;
                const int z = place_of_[r][1] + k % 3 - 1;
                const bool outside = z < 0 || z >= section_.nz;
                const bool mirror = outside && !section_.periodic_z && section_.is_fluid(y, z);
                if (mirror == behind_mirror) {
                    const bool fluid = !mirror && section_.is_fluid(y, z);
                    neighbour_[r][k] = fluid ? row(y, z) : ghost_row(y, z);
                }
            }
        }
        if (behind_mirror) {
            mirror_rows_ = all_rows_ - fluid_rows_;
        }
    }
}

template <class Real>
int D3q19<Real>::ghost_row(int y, int z) {
    if (section_.periodic_y) {
        y = (y + section_.ny) % section_.ny;
    }
    if (section_.periodic_z) {
        z = (z + section_.nz) % section_.nz;
    }
    for (int r = fluid_rows_; r < all_rows_; ++r) {
        if (place_of_[r][0] == y && place_of_[r][1] == z) {
            return r;
        }
    }
    place_of_.push_back({y, z});
    return all_rows_++;
}

template <class Real>
int D3q19<Real>::row(int y, int z) const {
    if (!section_.is_fluid(y, z)) {
        return -1;
    }
    const Section& s = section_;
    if (s.periodic_y) {
        y = (y + s.ny) % s.ny;
    }
    if (s.periodic_z) {
        z = (z + s.nz) % s.nz;
    }
    z = z < 0 ? -1 - z : z;
    z = z >= s.nz ? 2 * s.nz - 1 - z : z;
    return row_of_[static_cast<std::size_t>(z) * s.ny + y];
}

template <class Real>
void D3q19<Real>::allocate() {
    constexpr std::size_t line = 64;
    constexpr std::size_t page = 4096;
    constexpr int fields = directions + 7;
    pitch_ = nx_ + row_padding;
    const std::size_t row_bytes = static_cast<std::size_t>(pitch_) * sizeof(Real);
    const std::size_t bytes = ((all_rows_ + 1) * row_bytes + page) / page * page;
    // Seven cache lines apart modulo a page: no two arrays start in the same set of the first-level cache.
    const std::size_t stagger = 7 * line;
    memory_ = std::make_unique<HugeBuffer>(fields * (bytes + stagger));
    char* const start = static_cast<char*>(memory_->data()) + row_padding * sizeof(Real);
    const auto field = [&](int i) { return reinterpret_cast<Real*>(start + i * (bytes + stagger)); };
    for (int q = 0; q < directions; ++q) {
        f_[q] = field(q);
    }
    t_ = field(directions);
    for (int axis = 0; axis < 3; ++axis) {
        force_[axis] = field(directions + 1 + axis);
        velocity_[axis] = field(directions + 4 + axis);
    }
    scratch_.assign(threads_, std::vector<Real>(static_cast<std::size_t>(pitch_)));
    if (!slip_points_.empty()) {
        slip_buffer_ = std::make_unique<HugeBuffer>(slip_points_.size() * nx_ * sizeof(Real));
        slip_memory_ = static_cast<Real*>(slip_buffer_->data());
    }
}

template <class Real>
void D3q19<Real>::set_body_force(const std::array<double, 3>& force) {
    body_force_ = force;
    for (int axis = 0; axis < 3; ++axis) {
        constants_.body_force[axis] = static_cast<Real>(force[axis]);
    }
}

template <class Real>
void D3q19<Real>::set_coupling(int row, Coupling coupling) {
    coupling_[row] = coupling;
}

template <class Real>
void D3q19<Real>::initialise(const std::function<FlowState(double, double, double)>& flow) {
    odd_ = false;
    set_window(0, nx_);
    for (int r = 0; r < fluid_rows_; ++r) {
        const double y = section_.y_of(place_of_[r][0]);
        const double z = section_.z_of(place_of_[r][1]);
        for (int x = 0; x < nx_; ++x) {
            const FlowState state = flow(x + 0.5, y, z);
            const std::array<double, 6>& s = state.strain_rate;
            const double square = s[0] * s[0] + s[1] * s[1] + s[2] * s[2];
            const double mixed = s[3] * s[3] + s[4] * s[4] + s[5] * s[5];
            const double t = cross_ ? 3.0 * viscosity_.at(std::sqrt(2.0 * square + 4.0 * mixed))
                                    : static_cast<double>(constants_.t0);
            t_[offset(r) + x] = static_cast<Real>(t);
            for (int axis = 0; axis < 3; ++axis) {
                velocity_[axis][offset(r) + x] = static_cast<Real>(state.velocity[axis]);
            }
            const double trace = (s[0] + s[1] + s[2]) / 3.0;
            for (int q = 0; q < directions; ++q) {
                const auto [cx, cy, cz] = d3q19::velocity[q];
                const double cu = cx * (state.velocity[0] - 0.5 * body_force_[0]) +
                                  cy * (state.velocity[1] - 0.5 * body_force_[1]) +
                                  cz * (state.velocity[2] - 0.5 * body_force_[2]);
                const double strain = cx * cx * s[0] + cy * cy * s[1] + cz * cz * s[2] +
                                      2.0 * (cx * cy * s[3] + cx * cz * s[4] + cy * cz * s[5]) - trace;
                const double value = state.density + 3.0 * cu - 3.0 * (t + 0.5) * strain;
                slot(q, r)[x] = static_cast<Real>(weight(q) * value);
            }
        }
    }
    slip_velocities({0, 1}, Real(1));
}

template <class Real>
NodeState D3q19<Real>::at(int x, int row) const {
    if (odd_) {
        throw std::logic_error("a lattice can be read only between cycles");
    }
    NodeState state{};
    std::array<double, 6> n{};
    for (int q = 0; q < directions; ++q) {
        const double f = static_cast<double>(slot(q, row)[x]);
        const auto [cx, cy, cz] = d3q19::velocity[q];
        state.density += f;
        state.velocity[0] += cx * f;
        state.velocity[1] += cy * f;
        state.velocity[2] += cz * f;
        n[0] += cx * cx * f;
        n[1] += cy * cy * f;
        n[2] += cz * cz * f;
        n[3] += cx * cy * f;
        n[4] += cx * cz * f;
        n[5] += cy * cz * f;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const bool field = coupling_[row] == Coupling::coupled;
        const double extra = field ? static_cast<double>(force_[axis][offset(row) + x]) : 0.0;
        state.velocity[axis] += 0.5 * (body_force_[axis] + extra);
    }
    const double mean = (n[0] + n[1] + n[2]) / 3.0;
    for (int i = 0; i < 3; ++i) {
        n[i] -= mean;
    }
    const double t = cross_ ? static_cast<double>(t_[offset(row) + x]) : static_cast<double>(constants_.t0);
    state.viscosity = t / 3.0;
    for (int i = 0; i < 6; ++i) {
        state.strain_rate[i] = -1.5 * n[i] / (t + 0.5);
        state.viscous_stress[i] = 2.0 * state.viscosity * state.strain_rate[i];
        state.rate += (i < 3 ? 2.0 : 4.0) * state.strain_rate[i] * state.strain_rate[i];
    }
    state.rate = std::sqrt(state.rate);
    return state;
}

template <class Real>
double D3q19<Real>::flow_rate(int x) const {
    double sum = 0.0;
    for (int r = 0; r < fluid_rows_; ++r) {
        sum += at(x, r).velocity[0];
    }
    return sum;
}

template <class Real>
double D3q19<Real>::bytes_per_step() const {
    double values = 0.0;
    for (int r = 0; r < fluid_rows_; ++r) {
        const bool coupled = coupling_[r] == Coupling::coupled;
        const bool observed = coupled || observed_[r] != 0 || coupling_[r] == Coupling::observed;
        values += 2.0 * directions + (cross_ ? 2.0 : 0.0) + (coupled ? 3.0 : 0.0) + (observed ? 3.0 : 0.0);
    }
    return values * nx_ * sizeof(Real);
}

template <class Real>
void D3q19<Real>::collide(const Share& share, bool streaming) {
    const int last = static_cast<int>(share.end(fluid_rows_));
    for (int r = static_cast<int>(share.begin(fluid_rows_)); r < last; ++r) {
        d3q19::RowTask<Real> task{};
        for (int q = 0; q < directions; ++q) {
            const auto [cx, cy, cz] = d3q19::velocity[q];
            if (streaming) {
                const int source = neighbour_[r][3 * (1 - cy) + 1 - cz];
                task.f[q] = slot(opposite(q), source) + begin_ - cx;
            } else {
                task.f[q] = slot(q, r) + begin_;
            }
        }
        task.t = t_ + offset(r) + begin_;
        for (int axis = 0; axis < 3; ++axis) {
            task.force[axis] = force_[axis] + offset(r) + begin_;
            task.velocity[axis] = velocity_[axis] + offset(r) + begin_;
        }
        task.blocks = (end_ - begin_) / 16;
        Coupling coupling = coupling_[r];
        if (observed_[r] != 0 && coupling == Coupling::none) {
            coupling = Coupling::observed;
        }
        const auto& table = cross_ ? kernels_->cross : kernels_->newtonian;
        table[static_cast<int>(coupling)](task, constants_);
    }
}

template <class Real>
void D3q19<Real>::step() {
    const bool streaming = odd_;
#pragma omp parallel num_threads(threads_)
    {
        const Share share{omp_get_thread_num(), omp_get_num_threads()};
        if (streaming) {
            fill(share);
        }
        collide(share, streaming);
        if (streaming) {
#pragma omp barrier
            collect(share);
        }
    }
    odd_ = !odd_;
}

template class D3q19<float>;
template class D3q19<double>;

}  // namespace bioprint
