#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bioprint/predict/case.hpp"
#include "bioprint/predict/population.hpp"

/// What is answered. SI units; what does not exist is nullopt and a warning says why.
namespace bioprint {

struct NozzleAnswer {
    double flow_rate;                      ///< [m³/s]
    double pressure_gradient;              ///< [Pa/m]
    double velocity_average;               ///< [m/s]
    double velocity_max;                   ///< [m/s]
    double shear_rate_max;                 ///< at the wall [1/s]
    double shear_rate_average;             ///< over the cross-section [1/s]
    double stress_max;                     ///< at the wall [Pa]
    double stress_average;                 ///< over the cross-section [Pa]
    double viscosity_wall;                 ///< [Pa s]; +infinity at rest in an ink that has none there
    std::optional<double> pressure_drop;   ///< [Pa], with a length
    std::optional<double> residence_time;  ///< length/u_avg [s], with a length and a flow
    std::optional<double> plug_radius;     ///< within which the ink is not sheared [m], with a yield stress
    double error = 0.0;                    ///< relative, of each of these, against references of fifty digits
};

struct ExitAnswer {
    double elongation_rate;      ///< [1/s]
    double elongational_stress;  ///< [Pa]
    std::optional<double> error =
        {};  ///< relative, of both, as measured; none: not known, as everywhere below
};

enum class Place { nozzle, exit };
enum class Model { bullet, roscoe_shear, roscoe_elongation, ellipsoid };

struct CellStress {
    double von_mises;               ///< [Pa]
    std::array<double, 3> elastic;  ///< principal deviatoric stresses [Pa]
    double viscous;                 ///< [Pa]
};

/// One cell at one place by one model. The ellipsoid is carried in time: its entry in the nozzle is the cell
/// at the nozzle's end (streamline_passage.hpp), that at the exit the moment of its largest stress there.
struct CellAnswer {
    Place place;
    Model model;
    double offset;  ///< [m]
    double offset_in_cell_radii;
    double fluid_stress;  ///< σ_f, undisturbed, where the cell's centre is [Pa]
    double stress_ratio;  ///< σ_f/μ
    std::optional<std::array<double, 3>> stretch;
    std::optional<double> angle;      ///< [rad]; at the exit negative where axis 1 leans away from the axis
    std::optional<double> frequency;  ///< of tank treading [1/s]
    std::optional<CellStress> stress;
    std::optional<double> relaxation_time;    ///< in the strand [s]; exit only
    std::optional<double> error = {};         ///< relative, of its stress, as measured (ladder.hpp)
    std::optional<double> strain_error = {};  ///< relative, of each stretch less one
    std::optional<bool> applies = {};         ///< of a steady model: whether its assumptions hold here
};

/// The whole way of one cell carried in time, through nozzle and exit into the strand.
struct PassageAnswer {
    double offset;  ///< [m]
    double offset_in_cell_radii;
    double von_mises;                ///< the largest on the way [Pa]
    Place place;                     ///< where that is
    std::optional<double> position;  ///< and how far from the lip, negative in the nozzle [m]; none where the
                                     ///< cell has settled in a nozzle without a length
    double nozzle_peak;              ///< the largest in the nozzle, start-up included [Pa]
    double nozzle_steady;            ///< that of the settled cell [Pa]
    double exit_peak;                ///< the largest at the exit [Pa]
    double exit_position;            ///< and how far behind the lip [m]
    std::optional<bool> settles;     ///< whether the nozzle is long enough; with a length, as the next two
    std::optional<double> settling_time;      ///< from the entrance to within 5 % of the settled stress [s]
    std::optional<double> nozzle_exposure;    ///< ∫ von Mises dt to 4 radii before the lip [Pa s]
    double exit_exposure;                     ///< the same from there to 7.5 radii behind the lip [Pa s]
    double strand_offset;                     ///< distance from the axis in the strand [m]
    std::optional<double> error = {};         ///< relative, of the largest stress on the way
    std::optional<double> nozzle_error = {};  ///< of the stresses and the exposure in the nozzle
    std::optional<double> exit_error = {};    ///< of those at the exit
};

struct RadialProfile {
    std::vector<double> r;           ///< [m]
    std::vector<double> velocity;    ///< [m/s]
    std::vector<double> shear_rate;  ///< [1/s]
    std::vector<double> viscosity;   ///< [Pa s]; +infinity where the ink rests and has none there
    std::vector<double> stress;      ///< [Pa]
};

/// A result that left the range in which it was checked, or a value that looks like a slip.
struct Warning {
    std::string code;  ///< stable, snake_case
    std::string message;
};

struct Prediction {
    Case question;  ///< with `positions` filled in, as lengths
    NozzleAnswer nozzle;
    ExitAnswer exit;
    std::vector<CellAnswer> cells;        ///< by position, nozzle before exit
    std::vector<PassageAnswer> passages;  ///< by position; only of cells carried in time
    std::optional<RadialProfile> profile;
    std::optional<Population> population;
    std::optional<double> population_error = {};  ///< relative, of its stresses; cells at the wall aside
    std::vector<Warning> warnings;
};

/// Answers a case: flow, exit, and each cell's stress and strain.
/// @param jobs  threads that the population may take; the answer does not depend on them
/// @throws UsageError    the case is not sound (`problems_of`)
/// @throws NoSteadyFlow  the ink cannot bear the load, or the inputs are so far apart that no number holds the answer
/// @throws NotConverged  a stress ratio above 1e40
Prediction predict(const Case& question, unsigned jobs = 1);

}  // namespace bioprint
