#pragma once

#include <array>
#include <cstddef>

#include "cell/planar_cell.hpp"
#include "predict/exit_field.hpp"
#include "predict/size_effect.hpp"

/// What a cell meets along one streamline through the nozzle's end, tabulated once: the field is far dearer
/// than the table, and an integration in time asks a thousand times.
///
/// The place on the way is s with x = 0.4 R sinh s: its steps are fine at the lip and coarse far from it.
/// Gradients are per s in place of time, the viscosity is multiplied to match, so that an integration over s
/// is one over time. Between the 129 knots cubic interpolation, the streamline itself from the stream
/// function.
///
/// Accuracy: 1e-5 of the largest rate.                              tests/verify/streamline_passage.cpp
namespace bioprint {

class StreamlinePath {
  public:
    /// In nozzle radii from the lip.
    static constexpr double before = 4.0;
    static constexpr double after = 7.5;

    /// @param size          of the cell, which is carried along at the ink's place
    /// @param start_radius  far up in the nozzle [m], 0 ≤ r < R
    StreamlinePath(const ExitField& field, const NozzleFlow& flow, const SizeEffect& size,
                   double start_radius);

    /// The s of a distance from the lip [m], and back.
    [[nodiscard]] double at_position(double x) const;
    [[nodiscard]] double position(double s) const;
    [[nodiscard]] double stride(double s) const;  ///< dx/ds [m]

    /// Per s.
    [[nodiscard]] PlanarFlow flow(double s) const;

    struct Place {
        double radius;
        double slowness;     ///< dt/ds [s]
        double viscosity;    ///< [Pa s]
        double rate;         ///< sqrt(2 S:S) [1/s]
        double shear_share;  ///< part of rate² that is shear in the plane of x and r
    };
    [[nodiscard]] Place place(double s) const;

    /// What the cell's own size adds there.
    struct Size {
        double square_stretch;  ///< λ² − 1 of the stretch by which it is longer along the axis
        double linear;          ///< L [Pa]
    };
    [[nodiscard]] Size size(double s) const;
    [[nodiscard]] double cell_slowness(double s) const;  ///< dt/ds of the cell, which slips [s]

  private:
    static constexpr std::size_t knots = 129;
    static constexpr std::size_t columns = 13;
    using Row = std::array<double, columns>;
    struct Spot {
        std::size_t index;
        double part;
    };
    [[nodiscard]] Spot spot(double s) const;
    [[nodiscard]] double read(const Spot& at, std::size_t column) const;
    /// Of a viscosity.
    [[nodiscard]] double read_positive(const Spot& at, std::size_t column) const;

    double scale_;
    double first_;
    double step_;
    bool
        logarithmic_;  ///< an ink without a viscosity at rest passes decades of it: its logarithms are tabulated
    std::array<Row, knots> value_{};
    std::array<Row, knots> slope_{};
};

}  // namespace bioprint
