#pragma once

#include <optional>
#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"

/// The peak stress over all cells of a print. Cells are carried in proportion to the flux u(r) r, none nearer
/// to the wall than its own radius; each is followed on its streamline (streamline_passage.hpp).
///
/// Near the axis the effects of the cell's size are added: in the nozzle the bullet's stress, as the root of
/// the sum of squares (the two parts are orthogonal over the cell's volume, so this bounds the average from
/// above and is exact on the axis); at the exit the factor between the passage on the axis with and without
/// those effects (exit_passage.hpp), in the part of the flow there that is elongation.
///
/// Deterministic: `nodes` streamlines, their peaks interpolated over the radius.
/// Accuracy of the quadrature: 1e-3 of every number.                    tests/verify/population.cpp
/// Cost: 6 to 10 ms on one core.                                           tests/bench/exit_passage.cpp
namespace bioprint {

struct PopulationRequest {
    double cell_radius;                   ///< [m], > 0, less than the nozzle's
    double shear_modulus;                 ///< μ [Pa], > 0
    double viscosity_ratio = 1.0;         ///< λ ≥ 0
    std::optional<double> length = {};    ///< nozzle length [m]; none: settled, and no exposure in the nozzle
    std::vector<double> thresholds = {};  ///< von Mises stresses [Pa] whose excess is asked for
    int nodes = 16;                       ///< streamlines, at least 4
    unsigned jobs = 1;                    ///< threads; the answer does not depend on them
};

struct Distribution {
    double mean;
    double median;
    double percentile_90;
    double percentile_95;
    double percentile_99;
    double largest;
};

struct Population {
    Distribution peak_stress;              ///< von Mises [Pa]
    std::vector<double> share_above;       ///< part of the cells whose peak is above each threshold, 0 to 1
    double share_peaking_at_exit;          ///< part of the cells that bear their largest stress at the exit
    std::optional<Distribution> exposure;  ///< ∫ von Mises dt, nozzle and exit [Pa s]; with a length only
    std::vector<double> radius;            ///< of the streamlines in the nozzle [m]
    std::vector<double> nozzle_peak;       ///< along them [Pa]
    std::vector<double> exit_peak;         ///< [Pa]
};

/// @throws UsageError    a value outside its range or not finite
/// @throws NotConverged  an integration gave up
Population population(const NozzleFlow& flow, const PopulationRequest& request);

}  // namespace bioprint
