#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "lattice/axisymmetric_kernel.hpp"

/// Creeping flow with axial symmetry by lattice Boltzmann on the plane (x, r); lattice units only.
///
/// Node (i, j) sits at x = i + 1/2, r = j + 1/2; the wall is half-way beyond the last row, at r = `radius`.
/// Columns below `lip` end at a no-slip wall, those from `lip` on at a free surface that is a straight line
/// (free slip).
///   open      column 0 is fed with a given profile (half-way velocity bounce-back), the last column lets out
///   at
///             pressure zero (half-way anti-bounce-back)
///   periodic  the two ends are one; a body force drives
/// At the lip the two diagonal links that cross it bounce back.
///
/// Degenerate: alpha = 0 is a uniform viscosity, the mean of t0 and t_inf.
/// Accuracy: second order; the tube is exact for a uniform viscosity. tests/verify/axisymmetric_tube.cpp
namespace bioprint::lattice {

struct AxisymmetricDomain {
    int length;  ///< columns; a multiple of 16 is fastest
    int radius;  ///< rows
    int lip;     ///< first column of the free surface; = length for a tube
    bool periodic = false;
    double body_force = 0.0;
    int viscosity_interval = 4;  ///< steps between updates of the viscosity
};

/// Where the force field is read and the velocity stored: columns [begin, begin + columns) modulo the length.
struct ForceWindow {
    int begin = 0;
    int columns = 0;
    int rows = 0;
};

/// Fields on the nodes, row after row.
struct AxisymmetricFields {
    int length = 0;
    int radius = 0;
    std::vector<double> velocity_x, velocity_r, pressure, rate, viscosity;
    std::vector<double> elongation;  ///< −∂u_x/∂x

    [[nodiscard]] std::size_t at(int i, int j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(length) + static_cast<std::size_t>(i);
    }
};

/// How far a search for the steady state is; what it needs, beside the flow's own state, to go on.
struct SteadySearch {
    long done = 0;               ///< steps
    double last_change = 0.0;    ///< of the velocity between the last two checks
    std::vector<double> before;  ///< the velocity at the last check
};

class AxisymmetricFlow {
  public:
    /// @param inflow_nodes  velocity at r = 1/2, 3/2 … (radius values), for an open domain
    /// @param inflow_links  velocity at r = 0, 1, 2 … radius (radius + 1 values)
    AxisymmetricFlow(const AxisymmetricDomain& domain, const CrossRelaxation& ink,
                     std::span<const double> inflow_nodes = {}, std::span<const double> inflow_links = {});

    AxisymmetricFlow(AxisymmetricFlow&&) noexcept = default;
    AxisymmetricFlow& operator=(AxisymmetricFlow&&) noexcept = default;
    AxisymmetricFlow(const AxisymmetricFlow&) = delete;  // its links point into its own storage
    AxisymmetricFlow& operator=(const AxisymmetricFlow&) = delete;
    ~AxisymmetricFlow() = default;

    /// Starts from a developed profile before the lip and a plug behind it.
    /// @param velocity, shear  u_x and du_x/dr at r = 1/2, 3/2 …
    /// @param pressure_slope   −dp/dx before the lip
    void start(std::span<const double> velocity, std::span<const double> shear, double pressure_slope);

    void step();
    /// Steps until the velocity's estimated distance from the steady state falls below `tolerance` of its
    /// maximum. The distance is that of a geometric sequence through the last three checks.
    /// @param go_on  asked now and then with the estimated distance; false ends the run
    /// @return whether it did within `limit` steps
    bool run_to_steady(double tolerance, long limit, const std::function<bool(double)>& go_on = {});
    /// The same, going on where `search` is; it stands at the last check when `go_on` is asked.
    bool run_to_steady(double tolerance, long limit, const std::function<bool(double)>& go_on,
                       SteadySearch& search);

    /// Turns a steady state into that of velocities × `velocity` and viscosities × `viscosity`, exactly.
    void rescale(double velocity, double viscosity);

    void set_body_force(double force) { domain_.body_force = force; }
    void set_window(const ForceWindow& window) { window_ = window; }
    /// Force density and velocity on all nodes, row after row with `stride()`; the velocity is only that of
    /// the window.
    [[nodiscard]] double* force_x() { return force_x_.data(); }
    [[nodiscard]] double* force_r() { return force_r_.data(); }
    [[nodiscard]] const double* velocity_x() const { return velocity_x_.data(); }
    [[nodiscard]] const double* velocity_r() const { return velocity_r_.data(); }
    [[nodiscard]] int stride() const { return domain_.length; }

    [[nodiscard]] const AxisymmetricDomain& domain() const { return domain_; }
    [[nodiscard]] const CrossRelaxation& ink() const { return ink_; }
    [[nodiscard]] long steps() const { return steps_; }
    [[nodiscard]] AxisymmetricFields measure() const;
    /// Σ 2πr u_x through column i.
    [[nodiscard]] double flow_rate(int i) const;
    /// Everything a run needs to go on, and its inverse.
    [[nodiscard]] std::vector<double> state() const;
    void restore(std::span<const double> state);

  private:
    struct Link {
        int direction;  ///< what comes in
        int i, j;       ///< where
        int from;       ///< the direction it left along
        int from_i, from_j;
        int count;
        bool along_row;
        double sign;
    };
    struct Copy {
        double* to;
        const double* from;
        int count;
        std::ptrdiff_t stride;
        double sign;
        const double* add;
    };
    struct Node {
        std::array<double, D2Q9::size> f;
        double t, m0, ux, ur, fx, fr, n_xx, n_rr, n_xr, source;
    };

    [[nodiscard]] std::ptrdiff_t index(int i, int j) const { return (j + 1) * row_ + i + margin; }
    void link(const Link& link, std::span<const double> add = {});
    void link_rows();
    void link_periodic_ends();
    void link_open_ends(std::span<const double> nodes, std::span<const double> links);
    [[nodiscard]] std::array<double*, D2Q9::size> pointers(int i, int j) const;
    [[nodiscard]] Node node(int i, int j) const;
    void collide_row(int j, const KernelTable& table, bool update);

    static constexpr std::ptrdiff_t margin = 8;
    AxisymmetricDomain domain_;
    CrossRelaxation ink_;
    ForceWindow window_;
    std::ptrdiff_t row_;
    std::vector<double> storage_;
    std::array<double*, D2Q9::size> f_{};
    std::vector<double> t_, force_x_, force_r_, velocity_x_, velocity_r_;
    std::vector<std::vector<double>> additions_;
    std::vector<Copy> after_even_, after_odd_;
    bool odd_ = false;
    long steps_ = 0;
};

}  // namespace bioprint::lattice
