#pragma once

#include <array>
#include <optional>

#include "bioprint/cell/transient.hpp"
#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/function_ref.hpp"

/// A cell off the axis on its whole way: from round at the nozzle's entrance through the developed shear, the
/// exit and into the strand, as an ellipsoid on its streamline.
///
/// In the nozzle: start-up from a sphere, which overshoots in soft cells (stress ratio above 0.1), then
/// tank-treading as in roscoe.hpp. Without a nozzle length the cell is taken to have settled. The nozzle ends
/// where the exit begins to be felt at all, 4 radii before the lip; what bears the largest stress up to 1.5
/// radii before the lip (or in the first half of a nozzle shorter than 3) bears it in the nozzle. At the exit: the flow of exit_field.hpp.
///
/// With a cell radius the effects of the cell's size are those on the axis (exit_passage.hpp), carried off it
/// as src/predict/size_effect.hpp says, so that every value here tends to that of the axis.
///
/// Accuracy: integration 1e-4 of the peak stress. The exit flow off the axis is an interpolation, whose rates
/// are off by some 10 %. Cost: about 0.2 ms.         tests/verify/streamline_passage.cpp
namespace bioprint {

struct StreamlineRequest {
    double start_radius;                ///< radial position in the nozzle [m], 0 ≤ r < R
    double shear_modulus;               ///< μ [Pa], > 0
    double viscosity_ratio = 1.0;       ///< λ ≥ 0
    std::optional<double> length = {};  ///< nozzle length [m]; none: long enough to settle
    double cell_radius = 0.0;           ///< [m]; 0: no effects of size
    double observe_every = 0.0;  ///< distance between calls of the observer at the exit [m]; 0: none there
};

enum class StreamlinePlace { nozzle, exit };

/// The cell at one place of its way.
struct StreamlineState {
    double position;  ///< x from the lip, negative in the nozzle [m]
    double time;      ///< since the entrance, without a length since 4 radii before the lip [s]
    double radius;    ///< r [m]
    std::array<double, 3>
        stretch;       ///< of the axis in the plane of x and r nearer to x, the other in it, and θ
    double angle;      ///< of the first to x [rad], positive where it leans towards the axis
    double von_mises;  ///< volume average of the elastic stress [Pa]
    std::array<double, 3> elastic;    ///< principal deviatoric values of its uniform part, in that order [Pa]
    double viscous;                   ///< viscous shear stress between the first two axes inside [Pa]
    std::optional<double> frequency;  ///< of tank treading [1/s]; in the nozzle, where the axes differ
    double fluid_stress;              ///< σ_f of the undisturbed ink at the cell's centre [Pa]
    double exposure;                  ///< ∫ von Mises dt since the start [Pa s]
};

struct StreamlinePassage {
    StreamlineState nozzle_end;                  ///< the cell where the nozzle ends
    StreamlineState exit;                        ///< at the largest stress behind that
    double nozzle_steady;                        ///< von Mises stress of the settled cell [Pa]
    double nozzle_peak;                          ///< the largest inside, start-up included [Pa]
    std::optional<double> nozzle_peak_position;  ///< x of it [m]; none: everywhere, the cell has settled
    double exit_peak;                            ///< the largest behind the nozzle's end [Pa]
    double exit_position;                        ///< of that peak from the lip [m]
    double exit_shear_share;                     ///< part of the squared rate of strain that is shear there
    StreamlinePlace place;                       ///< where the stress is largest
    double end_radius;                           ///< of the streamline in the strand [m]
    std::optional<double> settling_time;  ///< from the entrance until within 5 % of the settled stress [s]
    std::optional<bool> settles;          ///< whether the nozzle is long enough for that; with a length
    std::optional<double> exposure;  ///< ∫ von Mises dt to 4 radii before the lip [Pa s]; with a length
    double exit_exposure;            ///< the same from there to 7.5 radii behind the lip [Pa s]
};

/// @param observe  called in order of place: in the nozzle a few times a step of the integrator
/// @throws UsageError    a value outside its range or not finite
/// @throws NotConverged  the integrator gave up
StreamlinePassage streamline_passage(const NozzleFlow& flow, const StreamlineRequest& request,
                                     FunctionRef<void(const StreamlineState&)> observe);
StreamlinePassage streamline_passage(const NozzleFlow& flow, const StreamlineRequest& request);

}  // namespace bioprint
