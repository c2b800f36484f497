#pragma once

#include "bioprint/flow/nozzle_flow.hpp"

/// Which exit flow a nozzle flow runs into, whatever the law of its ink.
///
/// What an ink's law does to the exit, its nozzle flow shows already: how far the middle runs ahead of the
/// average (n_e, the exponent of the power law with the same ratio of the two), and how the ink thins where it is
/// sheared most (n_w). The exit profiles are tabulated over these two, so that no parameter of a law is asked for.
///
///   e = (u_max − u_avg)/u_avg = 2 n_e/(1 + n_e)          n_w = d ln τ/d ln γ̇ at the wall
///
/// Accuracy: an ink with η_inf = 0 as in exit_axis.hpp; of nine inks with η_inf from 1e-4 to 0.1 η0 f is within 0.035, of
/// a tenth (α 0.95, K u/R 10, η_inf 0.003 η0, least index inside the wall) within 0.1, each left out of the fit of its terms.
///
/// Power law: n_e = n_w = n; Newtonian: both 1; a Cross ink with η_inf = 0 has n_w < n_e; a yield stress or a
/// remaining viscosity η_inf raises n_w above n_e.
namespace bioprint {

struct ExitKind {
    double index;       ///< n_e, 0 … 1
    double wall_index;  ///< n_w, 0 … 1
};

/// A flow at rest is Newtonian.
ExitKind exit_kind(const NozzleFlow& flow);

/// The same from the two numbers themselves.
/// @param excess_ratio  (u_max − u_avg)/u_avg, 0 … 1
ExitKind exit_kind(double excess_ratio, double wall_index);

}  // namespace bioprint
