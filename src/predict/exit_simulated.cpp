#include "predict/exit_simulated.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>

#include "predict/cubic_between.hpp"
#include "predict/exit_series.hpp"

namespace bioprint {
namespace {

using Line = std::vector<double>;

/// Where f falls below `value`, coming from the strand.
double place_of(const Line& x, const Line& f, double value) {
    std::size_t i = x.size() - 1;
    while (i > 1 && f[i - 1] < value) --i;
    double low = x[i - 1];
    double high = x[i];
    for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (low + high);
        (cubic_between(x, f, middle) > value ? low : high) = middle;
    }
    return low;
}

Line extrapolated(const Line& x, const SimulatedExit& ink) {
    const auto& [fine, f] = *ink.f.rbegin();
    const auto& [coarse, c] = *std::next(ink.f.rbegin());
    double shift = 0.0;
    for (const double value : {0.35, 0.5, 0.65})
        shift += (place_of(x, c, value) - place_of(x, f, value)) / 3.0;
    shift /= 1.0 / coarse - 1.0 / fine;
    const double ratio = static_cast<double>(fine) / coarse;
    Line line;
    for (const double at : x) {
        const double p = cubic_between(x, c, at + shift / coarse);
        const double q = cubic_between(x, f, at + shift / fine);
        line.push_back(q + (q - p) / (ratio * ratio - 1.0));
    }
    return line;
}

/// The numbers that make the spline: the logit in front of the place where it is 0, then the places of its levels.
Line nodes(const Line& x, const Line& f) {
    Line y;
    for (const double value : f) y.push_back(exit_logit(std::max(value, 1e-7)));
    Line places;
    for (std::size_t level = 0; level < exit_levels; ++level) {
        const double wanted = exit_level_step * static_cast<double>(level);
        std::size_t i = x.size() - 1;
        while (i > 1 && y[i - 1] > wanted) --i;
        double low = x[i - 1];
        double high = x[i];
        for (int n = 0; n < 50; ++n) {
            const double middle = 0.5 * (low + high);
            (cubic_between(x, y, middle) < wanted ? low : high) = middle;
        }
        places.push_back(low);
    }
    Line result;
    for (const double before : exit_before)
        result.push_back(exit_logit(cubic_between(x, f, places[0] + before)));
    result.insert(result.end(), places.begin(), places.end());
    return result;
}

}  // namespace

SimulatedExits read_simulated_exits(const std::string& path) {
    std::ifstream file(path);
    SimulatedExits all;
    auto& [x, inks] = all;
    std::string line;
    std::getline(file, line);
    for (std::size_t at = line.find("f("); at != std::string::npos; at = line.find("f(", at + 2)) {
        x.push_back(std::stod(line.substr(at + 2)));
    }
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        if (cells.size() != x.size() + 7) continue;  // a row the last run did not finish
        const std::string name = cells[0] + "," + cells[1] + "," + cells[2];
        auto ink = std::find_if(inks.begin(), inks.end(), [&](const auto& i) { return i.name == name; });
        if (ink == inks.end()) {
            inks.push_back({.name = name,
                            .alpha = std::stod(cells[0]),
                            .rate = std::stod(cells[1]),
                            .remainder = std::stod(cells[2]),
                            .held_out = cells[4] == "1",
                            .excess = std::stod(cells[5]),
                            .wall_index = std::stod(cells[6]),
                            .f = {},
                            .exact = {},
                            .nodes = {}});
            ink = std::prev(inks.end());
        }
        Line& f = ink->f[std::stoi(cells[3])];
        f.clear();
        for (std::size_t i = 7; i < cells.size(); ++i) f.push_back(std::stod(cells[i]));
    }
    std::erase_if(inks, [](const SimulatedExit& i) { return i.f.size() < 2; });
    for (SimulatedExit& ink : inks) {
        ink.exact = extrapolated(x, ink);
        ink.nodes = nodes(x, ink.exact);
    }
    return all;
}

}  // namespace bioprint
