#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bioprint/rheology/ink.hpp"

/// What is asked: a nozzle, what drives the flow through it, an ink, a cell and where it flows. SI units.
namespace bioprint {

/// A number that came from a preset carries its name and source; what the user gave has the source "user".
struct InkChoice {
    std::string name;
    std::string source;
    Ink law;
};

struct CellChoice {
    std::string name;
    std::string source;
    double radius;                 ///< [m]
    double shear_modulus;          ///< μ [Pa]
    double poisson_ratio = 0.48;   ///< recorded; every model takes the cell as incompressible
    double viscosity_ratio = 1.0;  ///< λ = inner over outer viscosity
    std::string remark = {};  ///< what the preset did not hold and was taken from elsewhere; empty: nothing
};

/// The one quantity that drives the flow.
enum class Drive { flow_rate, velocity, pressure_gradient, pressure };

/// Radial position of a cell's centre: a length [m], or a multiple of the cell radius.
struct CellPosition {
    double value;
    bool in_cell_radii = false;
};

/// A needle the nozzle was taken from; `name` says which bore was used.
struct NeedleChoice {
    std::string name;
    std::string source;
    std::string remark;  ///< which other bores the gauge could have meant; empty when it was unambiguous
    bool tapered = false;
};

struct Case {
    double radius;                 ///< nozzle inner radius [m]
    std::optional<double> length;  ///< nozzle length [m]; required when pressure drives the flow
    Drive drive;
    double drive_value;  ///< [m³/s], [m/s], [Pa/m] or [Pa]
    InkChoice ink;
    CellChoice cell;
    std::vector<CellPosition> positions;  ///< empty: 0, 1.5, 3 and 4.5 cell radii as far as they fit
    std::optional<NeedleChoice> needle;
    bool transient =
        true;  ///< also carry the cells through nozzle and exit in time (model "ellipsoid"); ~0.2 ms each
    bool population = false;              ///< also the distribution over all cells of a print; ~8 ms
    std::vector<double> thresholds = {};  ///< stresses whose excess the population is asked for [Pa]
    int profile_points = 0;               ///< radial profile from axis to wall; 0: none, else at least 2
};

/// Every way in which a case is not a case: negative sizes, numbers that are not finite, a cell that does not
/// fit. Each sentence names the quantity, its value and the remedy. Empty when the case is sound.
std::vector<std::string> problems_of(const Case& question);
/// The same of an ink alone.
std::vector<std::string> problems_of(const Ink& ink);

}  // namespace bioprint
