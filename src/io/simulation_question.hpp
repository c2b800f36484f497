#pragma once

#include <optional>
#include <string>

#include "bioprint/predict/comparison.hpp"
#include "bioprint/predict/ladder.hpp"
#include "bioprint/simulate/work.hpp"

/// What is asked of a simulation, which scene that is, and what it takes.
namespace bioprint {

enum class Fidelity { draft, standard, fine };

struct SimulationQuestion {
    std::string scene = "auto";  ///< shear, channel, exit-flow, exit, or auto
    Fidelity fidelity = Fidelity::standard;
    int snapshots = 20;                  ///< pictures of each stage of a run that is kept
    std::optional<double> resolution;    ///< nodes a cell radius; overrides the fidelity's 3, 6 or 12
    std::optional<double> fluid_stress;  ///< of the shear scene [Pa]
    std::optional<double> channel_time;  ///< how long the cell stays in the nozzle [s]
    std::optional<double> tolerance;     ///< relative error down to which the run is refined
    std::optional<double> budget;        ///< time that a refined run may be expected to take [s]
};

/// A scene and the position it is simulated for.
struct ChosenScene {
    SceneChoice scene;
    std::string remark;  ///< which of several positions was taken; empty: there was no choice
};

/// Of several positions the one on the axis is simulated, which costs seconds; else the first. The shear scene takes
/// the first off the axis.
/// @throws UsageError  not a scene, or one that this question does not fit
ChosenScene choose_scene(const SimulationQuestion& question, const Prediction& prediction);
double resolution_of(const SimulationQuestion& question);
/// The other options stay as they are.
SimulationOptions options_of(const SimulationQuestion& question, SimulationOptions options = {});
/// "draft", "standard", "fine" or "custom".
std::string_view fidelity_name(const SimulationQuestion& question);
/// The same at twice the resolution.
SimulationQuestion finer_than(SimulationQuestion question);
/// Why `--tolerance` does not try a run at twice the resolution of this one; empty when it does.
std::string why_not_finer(const Prediction& prediction, const SimulationQuestion& question);
/// The rung of so many nodes a cell radius, or the next finer one.
Rung rung_of(double resolution);

/// Everything that would refuse the simulation of this question before it takes time.
/// @throws UsageError  what does not fit, and what would
void check_simulation(const Prediction& prediction, const SimulationQuestion& question);
/// What it takes, one thread.
/// @throws UsageError  as check_simulation()
SimulationWork work_of(const Prediction& prediction, const SimulationQuestion& question);

}  // namespace bioprint
