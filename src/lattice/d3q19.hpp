#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lattice/d3q19_kernel.hpp"
#include "lattice/huge_buffer.hpp"
#include "lattice/section.hpp"

/// Creeping flow of a shear-thinning fluid in three dimensions, by the lattice-Boltzmann method on 19
/// velocities, in a channel along x whose cross-section does not change.
///
/// Everything is in lattice units: node spacing, time step and density of the fluid at rest are 1.
///
///   f_q += −λ+ (f+ − w δρ) − λ− (f− − 3w c·u) + (1 − λ−/2) 3w c·F,      then f_q moves by c_q
///   λ+ = 1/(3ν + ½),   λ− = 1/(½ + Λ/(3ν)),   Λ = 3/16,   u = Σ c f + F/2,   pressure δρ/3
///
/// No u² in the equilibrium, so a steady state is exactly creeping flow at any lattice Reynolds number. ν is
/// local: ν_inf + (ν0 − ν_inf)/(1 + (K γ̇)^α), γ̇ from the non-equilibrium second moments, one step behind.
/// Populations are kept as deviations from the fluid at rest, which is what lets `float` reach 1e-5.
///
/// Streaming is in place (AA pattern): two steps make one cycle, and whole fields (`at`) can be read only
/// between cycles. A row is a line of nodes along x; only rows of fluid are stored. Walls, mirrors and ends
/// fill slots beside the fluid before the streaming half of a cycle and collect from them after it, so the
/// bulk has no case to tell.
///
/// Walls: u = wall velocity where the link is cut, by central linear interpolation (Ginzburg, Verhaeghe,
/// d'Humières 2008, "CLI": with Λ fixed the wall stays put for every viscosity), second order:
///   incoming = post_q(x) + κ (post_q(x − c_q) − post_q̄(x)) − 12 w/(1 + 2δ) c_q·u_wall,   κ = (1 − 2δ)/(1 +
///   2δ)
/// Free slip: the same interpolation between populations that keep their velocity along x, so that the shear
/// stress along x vanishes where the link is cut, while u_θ of the wall follows the fluid (zero gradient of
/// u_θ/r, read 1.5 spacings from the wall).
///
/// A window: where a flow with open ends stands still but about a body, only the columns about it need be
/// stepped. The columns beside the window send into it what they hold, so a flow at rest stays as it is, and a
/// disturbance that reaches them is not sent back but for the share that a fixed inflow would.
///
/// Results do not depend on the number of threads, to the last bit.
/// Accuracy, order of convergence and speed: tests/verify/d3q19.cpp, tests/bench/lattice3d.cpp.
namespace bioprint {

/// ν(γ̇) = nu_inf + (nu0 − nu_inf)/(1 + (time_constant γ̇)^alpha). A time constant of 0 is a Newtonian fluid of
/// nu0.
struct LatticeViscosity {
    double nu0 = 0.5;
    double nu_inf = 0.0;
    double time_constant = 0.0;
    double alpha = 0.0;

    [[nodiscard]] double at(double rate) const;
};

/// How the two x faces are closed. `inflow_outflow`: given velocity at x = −½, pressure 0 at x = nx − ½.
enum class Ends { periodic, inflow_outflow };

struct D3q19Setup {
    int nx = 16;  ///< a multiple of 16
    Section section{};
    LatticeViscosity viscosity{};
    std::array<double, 3> body_force{};
    Ends ends = Ends::periodic;
    std::function<double(double y, double z)> inflow{};  ///< u_x, positions relative to the section's centre
    int slip_begin = 0;  ///< walls are free-slip for slip_begin ≤ x < slip_end (round sections only)
    int slip_end = 0;
    int threads = 1;
    d3q19::InstructionSet instructions = d3q19::InstructionSet::best;
};

/// Symmetric tensors are kept as xx, yy, zz, xy, xz, yz.
struct FlowState {
    double density = 0.0;  ///< deviation from rest; the pressure is a third of it
    std::array<double, 3> velocity{};
    std::array<double, 6> strain_rate{};
};

struct NodeState {
    double density;
    std::array<double, 3> velocity;
    std::array<double, 6> strain_rate;     ///< deviatoric
    std::array<double, 6> viscous_stress;  ///< 2 ν × strain rate
    double rate;                           ///< sqrt(2 S:S)
    double viscosity;
};

template <class Real>
class D3q19 {
  public:
    /// @throws UsageError  a setup that cannot run: nx not a multiple of 16, ν ≤ 0, slip on a section without
    /// radius …
    explicit D3q19(const D3q19Setup& setup);

    /// Sets every node to the state `flow` gives at a position; x + ½ is the position of node x.
    void initialise(const std::function<FlowState(double x, double y, double z)>& flow);

    void step();
    /// From here on only the columns begin ≤ x < end are stepped; the others stay as they are. A step covers all
    /// of them at first. Needs `whole()`.
    /// @throws UsageError  not multiples of 16, not within the lattice, or part of a periodic lattice
    void set_window(int begin, int end);
    [[nodiscard]] int window_begin() const { return begin_; }
    [[nodiscard]] int window_end() const { return end_; }
    /// Two steps, so that `at` may be called.
    void cycle() {
        step();
        step();
    }
    [[nodiscard]] bool whole() const { return !odd_; }

    void set_body_force(const std::array<double, 3>& force);
    [[nodiscard]] std::array<double, 3> body_force() const { return body_force_; }
    [[nodiscard]] const LatticeViscosity& viscosity() const { return viscosity_; }

    [[nodiscard]] int nx() const { return nx_; }
    [[nodiscard]] const Section& section() const { return section_; }
    [[nodiscard]] int rows() const { return fluid_rows_; }
    [[nodiscard]] long fluid_nodes() const { return static_cast<long>(fluid_rows_) * nx_; }
    [[nodiscard]] long stepped_nodes() const { return static_cast<long>(fluid_rows_) * (end_ - begin_); }
    /// The row of (y, z), periodic images and mirror images included; −1 where there is no fluid.
    [[nodiscard]] int row(int y, int z) const;

    /// Needs `whole()`.
    [[nodiscard]] NodeState at(int x, int row) const;
    /// Σ u_x over the section at node x; needs `whole()`.
    [[nodiscard]] double flow_rate(int x) const;

    /// Coupled rows read their force field and write their velocity in every step.
    void set_coupling(int row, d3q19::Coupling coupling);
    [[nodiscard]] Real* force(int axis, int row) { return force_[axis] + offset(row); }
    [[nodiscard]] const Real* velocity(int axis, int row) const { return velocity_[axis] + offset(row); }

    /// Everything a fresh lattice of the same setup needs to go on to the same numbers; needs `whole()`.
    [[nodiscard]] std::vector<double> state() const;
    /// @throws DataError  the numbers are of another lattice
    void restore(std::span<const double> state);

    /// Bytes a step moves through memory: every population read and written once, the rate kept, the fields
    /// of coupled rows.
    [[nodiscard]] double bytes_per_step() const;

  private:
    struct Share {
        int index;
        int count;
        [[nodiscard]] std::size_t begin(std::size_t total) const { return total * index / count; }
        [[nodiscard]] std::size_t end(std::size_t total) const { return total * (index + 1) / count; }
    };
    /// A population that a mirror turns into another one.
    struct MirrorLink {
        int ghost_slot, real_slot;
        int ghost_row, real_row;
    };
    /// A population that enters through an x face.
    struct EndLink {
        int q;
        int row, source_row;
        Real sign;      ///< of the population sent back
        Real velocity;  ///< 6 w c·u of the inflow
        bool low;
    };
    /// The stress-free continuation of u_θ to a wall point, as weights of velocity rows.
    struct SlipPoint {
        std::array<int, 4> row;
        std::array<Real, 4> y;  ///< of u_y in u_θ
        std::array<Real, 4> z;  ///< of u_z in u_θ
    };
    /// A column beside the window, which stays as it is.
    struct Border {
        int beside, inside;                       ///< this column, and the window's column next to it
        std::array<int, 5> q{};                   ///< into the window
        std::array<std::vector<Real>, 5> sent{};  ///< the population of direction q of every row
        std::array<std::vector<Real>, 5> own{};   ///< what the opposite slot of every row holds
    };
    /// A population that a wall sends back.
    struct CutLink {
        int q;  ///< towards the wall
        int row, far_row, ghost_row;
        Real kappa;
        Real wall;      ///< 12 w/(1 + 2δ) c·u of a moving wall
        Real fraction;  ///< δ
        int slip_point;
        Real slip_around;  ///< 12 w/(1 + 2δ) c·θ
    };

    [[nodiscard]] std::ptrdiff_t offset(int row) const { return static_cast<std::ptrdiff_t>(row) * pitch_; }
    [[nodiscard]] Real* slot(int q, int row) const { return f_[q] + offset(row); }
    /// Visits every row of numbers that a state consists of.
    template <class Visit>
    void each_state_row(const Visit& visit) const;
    void build_rows();
    int ghost_row(int y, int z);
    void build_links();
    void add_wall(const WallLink& wall, int row);
    int add_slip_point(const WallLink& wall);
    void add_end(int row, int y, int z, int q);
    void allocate();
    void collide(const Share& share, bool streaming);
    void fill(const Share& share);
    void collect(const Share& share);
    void wrap_ends(const Share& share, bool filling);
    void mirrors(const Share& share, bool filling);
    void ends(const Share& share, bool filling);
    void walls(const Share& share, bool filling);
    [[nodiscard]] Border border(bool low) const;
    void send_from_borders(const Share& share, bool filling);
    void restore_borders(const Share& share);
    void rigid_row(const CutLink& link, int begin, int end, bool filling);
    void slip_row(const CutLink& link, int begin, int end, const Real* wall, bool filling);
    void slip_velocities(const Share& share, Real follow);
    [[nodiscard]] Real* slip_around(int point) const {
        return slip_memory_ + static_cast<std::ptrdiff_t>(point) * nx_;
    }
    void slip_momentum(const CutLink& link, Real* wall) const;

    int nx_;
    Section section_;
    LatticeViscosity viscosity_;
    std::array<double, 3> body_force_;
    Ends ends_;
    std::function<double(double, double)> inflow_;
    int slip_begin_, slip_end_;
    int begin_, end_;  ///< of the window
    int threads_;
    const d3q19::Kernels<Real>* kernels_;
    d3q19::FluidConstants<Real> constants_{};
    bool cross_ = false;
    bool odd_ = false;

    int fluid_rows_ = 0;
    int mirror_rows_ = 0;  ///< ghost rows behind a mirror, numbered after the fluid rows
    int all_rows_ = 0;
    std::ptrdiff_t pitch_ = 0;
    std::vector<int> row_of_;
    std::vector<std::array<int, 2>> place_of_;   ///< (y, z) of every row
    std::vector<std::array<int, 9>> neighbour_;  ///< of every fluid row, [3 (dy + 1) + dz + 1]
    std::vector<d3q19::Coupling> coupling_;      ///< as asked for
    std::vector<char> observed_;                 ///< rows that free-slip walls read
    std::vector<MirrorLink> mirror_links_;
    std::vector<EndLink> end_links_;
    std::vector<SlipPoint> slip_points_;
    std::vector<CutLink> cut_links_;
    std::vector<Border> borders_;             ///< none where the window ends with the lattice
    std::vector<std::vector<Real>> scratch_;  ///< wall momentum of a row, one for each thread

    std::unique_ptr<HugeBuffer> memory_;
    std::unique_ptr<HugeBuffer> slip_buffer_;
    Real* slip_memory_ = nullptr;  ///< u_θ of every slip point
    std::array<Real*, 19> f_{};
    Real* t_ = nullptr;
    std::array<Real*, 3> force_{};
    std::array<Real*, 3> velocity_{};
};

extern template class D3q19<float>;
extern template class D3q19<double>;

}  // namespace bioprint
