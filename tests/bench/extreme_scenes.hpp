#pragma once

#include <string>
#include <vector>

/// Scenes at the edges of what can be asked of the simulation: always the same ones, so that a table of their outcomes
/// can be compared with the next.
namespace bioprint::extremes {

inline constexpr double nozzle_radius = 50e-6;  ///< [m]; with the viscosity the scales of every scene
inline constexpr double eta0 = 10.0;            ///< [Pa s]
inline constexpr double draft_nodes = 3.0;      ///< a cell radius

struct ExtremeScene {
    int number;
    std::string group;       ///< "corner", "interior", "edge", "wall", "ratio": how it was drawn
    std::string kind;        ///< as --simulate takes it
    double alpha;            ///< thinning exponent
    double reduced_rate;     ///< K · 4u/R
    double velocity;         ///< average [m/s]
    double confinement;      ///< cell over nozzle radius
    double shear_modulus;    ///< [Pa]
    double offset = 0.0;     ///< of the cell's centre over the nozzle radius
    double stress = 0.0;     ///< of the undisturbed ink [Pa]; shear alone
    double inner_ratio = 1;  ///< viscosity inside the cell over that of the ink
    double poisson = 0.48;   ///< recorded by the program, used by no model

    [[nodiscard]] double cell_radius() const { return confinement * nozzle_radius; }
    /// What loads the cell over its shear modulus: G R_c/μ, or σ_f/μ in shear; 0 without a cell.
    [[nodiscard]] double load() const;
    /// The program's arguments, at so many nodes a cell radius.
    [[nodiscard]] std::vector<std::string> arguments(double nodes) const;
};

/// All of them: every corner, the inside by quasi-random points, the neighbourhood of what a cell bears, places near
/// the wall, viscosity and Poisson ratios.
std::vector<ExtremeScene> extreme_scenes();

/// Some of them, of seconds in all: answers, refusals and what once failed.
std::vector<ExtremeScene> few_extreme_scenes();

}  // namespace bioprint::extremes
