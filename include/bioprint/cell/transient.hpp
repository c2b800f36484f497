#pragma once

#include <array>

#include "bioprint/function_ref.hpp"

/// A cell in a flow that changes: Roscoe's ellipsoid without the assumption that it rests.
///
/// The ellipsoid is carried through the undisturbed velocity gradient along its path, rate e and spin ω, with
/// the ink's viscosity η there. B = F Fᵀ is the deformation of its inside, which moves with the uniform
/// gradient d + w:
///
///   dB/dt = Λ B + B Λᵀ,   Λ = d + w,    E* = (1−λ) d − (μ/2η) dev B,    d = e + S:E*,    w = ω + Π:E*
///
/// S and Π are Eshelby's tensors of the ellipsoid of the moment (shape_integrals.hpp). Steady states are
/// Roscoe's; a small deformation relaxes in (3/2+λ) η/μ; a cell carried fast enough deforms with the ink.
/// There is no turning point.
///
/// B is held as C Cᵀ with a lower triangular C, by C − 1 and the logarithms of its diagonal: their sum is an
/// invariant that is linear, so that det B = 1 holds to round-off, and a deformation of 1e-8 keeps its
/// digits. Accuracy: that of the tolerance asked for, down to 1e-10. tests/verify/transient.cpp Cost: 1.5 µs
/// an evaluation, seven a step; nothing is allocated.                         tests/bench/cell.cpp
namespace bioprint {

using Tensor = std::array<std::array<double, 3>, 3>;

/// The undisturbed ink at the cell's place.
struct AmbientFlow {
    Tensor gradient;   ///< L_ij = ∂u_i/∂x_j, traceless [1/s]
    double viscosity;  ///< η [Pa s], > 0
};

struct TransientCell {
    double shear_modulus;          ///< μ [Pa], > 0
    double viscosity_ratio = 1.0;  ///< λ ≥ 0
};

/// The deformation of a cell: B = C Cᵀ.
struct Deformation {
    std::array<double, 3> log_diagonal{};  ///< ln C11, ln C22, ln C33; their sum is zero
    std::array<double, 3> lower{};         ///< C21, C31, C32
};

/// B − 1, to the relative accuracy of the deformation itself.
Tensor strain_of(const Deformation& deformation);

/// What `deformation` gives back as B − 1; for a start from a known shape. The determinant of B is set to 1.
Deformation deformation_of(const Tensor& strain);

struct TransientState {
    double time;
    Deformation deformation;
    std::array<double, 3> stretch;  ///< α1 ≥ α2 ≥ α3
    Tensor axes;                    ///< column i: the unit vector of axis i
    double von_mises;               ///< of the elastic stress [Pa]
};

struct TransientOptions {
    double tolerance = 1e-8;  ///< relative, of each step
    int max_steps = 200000;
    int samples = 1;  ///< calls of the observer a step, evenly spread over it
};

/// The gradient Λ inside a cell.
Tensor inner_gradient(const AmbientFlow& flow, const TransientCell& cell, const Deformation& deformation);

/// Shape and stress of a deformation.
TransientState transient_state(double time, const Deformation& deformation, const TransientCell& cell);

/// Carries the cell from one time to another.
/// @param flow     the ink at a time [s]; smooth or in few pieces
/// @param observe  called at the start and then in every step, options.samples times, the last at its end
/// @throws UsageError    a value outside its range or not finite
/// @throws NotConverged  the integrator gave up
TransientState carry_cell(FunctionRef<AmbientFlow(double)> flow, const TransientCell& cell,
                          const Deformation& start, double from, double to, const TransientOptions& options,
                          FunctionRef<void(const TransientState&)> observe);
TransientState carry_cell(FunctionRef<AmbientFlow(double)> flow, const TransientCell& cell,
                          const Deformation& start, double from, double to,
                          const TransientOptions& options = {});

}  // namespace bioprint
