#pragma once

#include <optional>

#include "bioprint/cell/transient.hpp"
#include "bioprint/flow/nozzle_flow.hpp"

/// A cell off the axis on its whole way: from round at the nozzle's entrance through the developed shear, the
/// exit and into the strand, as an ellipsoid on its streamline.
///
/// In the nozzle: start-up from a sphere, which overshoots in soft cells (stress ratio above 0.1), then
/// tank-treading as in roscoe.hpp. Without a nozzle length the cell is taken to have settled. At the exit:
/// the flow of exit_field.hpp. No effects of the cell's size and no thinning of the ink by the cell: on the
/// axis use exit_passage.hpp. Accuracy: integration 1e-5. The exit flow off the axis is an interpolation,
/// whose rates are off by some 10 %. Cost: about 0.5 ms.
namespace bioprint {

struct StreamlineRequest {
    double start_radius;                ///< radial position in the nozzle [m], 0 < r < R
    double shear_modulus;               ///< μ [Pa], > 0
    double viscosity_ratio = 1.0;       ///< λ ≥ 0
    std::optional<double> length = {};  ///< nozzle length [m]; none: long enough to settle
};

enum class StreamlinePlace { nozzle, exit };

struct StreamlinePassage {
    double nozzle_steady;                 ///< von Mises stress of the settled cell [Pa]
    double nozzle_peak;                   ///< the largest inside, start-up included [Pa]
    double exit_peak;                     ///< the largest from 1.5 radii before the lip on [Pa]
    double exit_position;                 ///< of that peak from the lip [m]
    double exit_shear_share;              ///< part of the squared rate of strain that is shear there
    StreamlinePlace place;                ///< where the stress is largest
    double end_radius;                    ///< of the streamline in the strand [m]
    std::optional<double> settling_time;  ///< from the entrance until within 5 % of the settled stress [s]
    std::optional<bool> settles;          ///< whether the nozzle is long enough for that
    std::optional<double> exposure;  ///< ∫ von Mises dt in the nozzle, to 4 radii before the lip [Pa s]
    double exit_exposure;            ///< the same from there to 6 radii behind the lip [Pa s]
};

/// @throws UsageError    a value outside its range or not finite
/// @throws NotConverged  the integrator gave up
StreamlinePassage streamline_passage(const NozzleFlow& flow, const StreamlineRequest& request);

}  // namespace bioprint
