#pragma once

#include <map>
#include <string>
#include <vector>

/// The simulated exit flows of data/exit/axis_profiles.csv, extrapolated to an endless resolution: for the maker of the
/// table and for the tests that hold the table against them.
///
/// Two resolutions of an ink give its profile. The lattice's lip acts as one a fraction of a node farther on, found by
/// where f passes a half; with that shift taken out, the rest is of second order.
/// Accuracy: 3e-4 of u_max − u_avg, 1e-3 of the largest slope, against finite elements at α 0, 0.3 and 0.75.
namespace bioprint {

struct SimulatedExit {
    std::string name;  ///< "alpha,rate,eta_inf/eta0"
    double alpha;
    double rate;       ///< K u_avg/R
    double remainder;  ///< η_inf/η0
    bool held_out;     ///< of the fit
    double excess;     ///< (u_max − u_avg)/u_avg
    double wall_index;
    std::map<int, std::vector<double>> f;  ///< at each place, by nodes a radius
    std::vector<double> exact;             ///< extrapolated
    std::vector<double> nodes;             ///< those of exit_series.hpp
};

struct SimulatedExits {
    std::vector<double> places;  ///< X
    std::vector<SimulatedExit> inks;
};

/// Inks of which the file has only one resolution are left out.
SimulatedExits read_simulated_exits(const std::string& path);

}  // namespace bioprint
