#include "simulate/space_limits.hpp"

#include <cmath>
#include <string>

#include "bioprint/errors.hpp"
#include "simulate/message_number.hpp"
#include "simulate/offset_view.hpp"

namespace bioprint {
namespace {

constexpr double most_load = 1.9;
constexpr double most_steps = 1e5;   ///< for each nozzle radius of the way, as on the axis
constexpr double rigid_load = 0.01;  ///< G R_c/μ below which a softer cell bears the same stress

double steps_a_radius(const Scene& scene, const NozzleFlow& flow, double modulus, double nodes) {
    const OffsetUnits units = offset_units({scene.cell.radius, modulus, nodes}, flow);
    return scene.nozzle_radius / (scene.velocity_average * units.time);
}

}  // namespace

void check_offset_softness(const Scene& scene, const NozzleFlow& flow, const SimulationOptions& options) {
    if (options.channel_time > 0.0) return;
    const double stress = 0.5 * flow.pressure_gradient() * scene.offset;
    const double load = stress / scene.cell.shear_modulus;
    if (load <= most_load) return;
    throw UsageError(
        "--shear-modulus: this cell is too soft to keep a shape at its offset: the ink's stress over its "
        "shear modulus is " +
            number(load) + " and runs above " + number(most_load) +
            " have ended with elements inside out; take a shear modulus of " + number(stress / most_load) +
            " Pa or more, an offset of " + number(scene.offset * most_load / load) +
            " m or less, or say how long it stays in the nozzle with --channel-time",
        "--shear-modulus");
}

void check_offset_duration(const Scene& scene, const NozzleFlow& flow, double nodes) {
    const double steps = steps_a_radius(scene, flow, scene.cell.shear_modulus, nodes);
    if (scene.kind != SceneKind::exit || steps <= most_steps) return;
    const std::string what = number(steps) + " steps for each nozzle radius of its way, and " +
                             number(most_steps) + " are the limit; ";
    constexpr int tenths_of_decades = 120;
    double modulus = scene.cell.shear_modulus;
    for (int i = 0; i < tenths_of_decades; ++i) {
        modulus *= std::pow(10.0, -0.1);
        const double load = flow.pressure_gradient() * scene.cell.radius / modulus;
        if (load >= rigid_load) break;
        if (steps_a_radius(scene, flow, modulus, nodes) <= most_steps) {
            throw UsageError(
                "--shear-modulus: a cell of " + number(scene.cell.shear_modulus) +
                    " Pa in this slow flow would take " + what + "one of " + number(modulus) +
                    " Pa fits and bears the same stress, for it is all but rigid as well (G R_c/μ " +
                    number(load) + ")",
                "--shear-modulus");
        }
    }
    throw UsageError("--alpha: through the exit the cell would take " + what +
                         "lower --alpha, --time-constant or --resolution, or take a softer cell",
                     "--alpha");
}

}  // namespace bioprint
