#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "bioprint/flow/nozzle_flow.hpp"
#include "lattice/axisymmetric.hpp"
#include "predict/cubic_between.hpp"
#include "simulate/lattice_units.hpp"

// Simulates the exit flows behind the exit table: the velocity on the axis through a nozzle exit,
//
//   f(X) = (u − u_avg)/(u_max − u_avg),   X = x/R from the lip
//
//   make_exit_profiles data/exit/axis_profiles.csv [nodes a radius, 48] [only where 1 - excess is this or more]
//
// appends a row for each ink that the file lacks at that resolution and at half of it: f at the places X of the
// header. It can be stopped and started again. A row takes 1 to 60 s.
// make_exit_table turns the rows into the table.

using namespace bioprint;

namespace {

struct Entry {
    double alpha;
    double rate;       ///< Cu = K u_avg/R
    double remainder;  ///< η_inf/η0
    bool held_out = false;
};

// From weak thinning to the power law (Cu → ∞), the table's and those it is tested with.
const std::vector<Entry> entries{
    {0.0, 1.0, 0.0},         {0.95, 1.0, 0.0},         {0.95, 1e4, 0.0},          {0.95, 1e-1, 0.0},
    {0.75, 5.0, 0.0, true},  {0.3, 5.0, 0.0, true},    {0.5, 1e4, 0.0},           {0.5, 1e-2, 0.0},
    {0.5, 1.0, 0.0},         {0.75, 1e4, 0.0},         {0.75, 1.0, 0.0},          {0.75, 1e-1, 0.0},
    {0.95, 10.0, 0.0},       {0.95, 100.0, 0.0},       {0.95, 1e-2, 0.0},         {0.95, 0.3, 0.0},
    {0.95, 3.0, 0.0},        {0.75, 10.0, 0.0},        {0.75, 100.0, 0.0},        {0.3, 1e6, 0.0},
    {0.3, 1.0, 0.0},         {0.5, 10.0, 0.0},         {0.5, 100.0, 0.0},         {0.15, 1e8, 0.0},
    {0.15, 1.0, 0.0},        {0.85, 0.3, 0.0},         {0.85, 3.0, 0.0},          {0.85, 30.0, 0.0},
    {0.85, 1e4, 0.0},        {0.9, 1.0, 0.0},          {0.9, 10.0, 0.0},          {0.9, 1e3, 0.0},
    {0.6, 0.3, 0.0},         {0.6, 3.0, 0.0},          {0.6, 30.0, 0.0},          {0.6, 1e4, 0.0},
    {0.7, 1e4, 0.0},         {0.8, 1e4, 0.0},          {0.9, 1e4, 0.0},           {0.4, 1e4, 0.0},
    {0.4, 1e-1, 0.0},        {0.95, 3e-2, 0.0},        {0.75, 0.3, 0.0},          {0.75, 3.0, 0.0},
    {0.75, 1e-2, 0.0},       {0.95, 1e3, 0.0},         {0.95, 30.0, 0.0},         {0.15, 100.0, 0.0},
    {0.95, 1.7, 0.0},        {0.95, 5.5, 0.0},         {0.95, 17.0, 0.0},         {0.95, 55.0, 0.0},
    {0.9, 30.0, 0.0},        {0.9, 3.0, 0.0},          {0.9, 100.0, 0.0},         {0.85, 10.0, 0.0},
    {0.85, 100.0, 0.0},      {0.8, 10.0, 0.0},         {0.8, 50.0, 0.0},          {0.8, 1e3, 0.0},
    {0.8, 1.0, 0.0},         {0.65, 3.0, 0.0},         {0.65, 300.0, 0.0},        {0.7, 30.0, 0.0},
    {0.7, 1.0, 0.0},         {0.55, 1.0, 0.0},         {0.55, 30.0, 0.0},         {0.95, 0.6, 0.0},
    {0.85, 1.0, 0.0},        {0.3, 100.0, 0.0},        {0.3, 0.03, 0.0},          {0.8, 0.3, 0.0},
    {0.65, 0.05, 0.0},       {0.9, 0.1, 0.0},          {0.2, 0.1, 0.0},           {0.7, 0.02, 0.0},
    {0.4, 1.0, 0.0, true},   {0.4, 100.0, 0.0, true},  {0.65, 0.5, 0.0, true},    {0.65, 30.0, 0.0, true},
    {0.8, 2.0, 0.0, true},   {0.8, 200.0, 0.0, true},  {0.92, 0.5, 0.0, true},    {0.92, 50.0, 0.0, true},
    {0.92, 2e3, 0.0, true},  {0.95, 0.05, 0.0, true},  {0.95, 300.0, 0.0, true},  {0.2, 10.0, 0.0, true},
    {0.75, 5.0, 0.02, true}, {0.9, 100.0, 0.01, true}, {0.6, 1e3, 0.05, true},    {0.95, 10.0, 3e-3, true},
    {0.75, 1e4, 1e-3, true}, {0.8, 30.0, 0.02, true},  {0.95, 100.0, 1e-3, true}, {0.9, 1e3, 1e-4, true},
    {0.5, 1e4, 0.01, true},  {0.7, 3.0, 0.1, true},
};

constexpr double radius = 50e-6;
constexpr double velocity = 5e-3;
constexpr double steady_tolerance = 1e-5;  ///< of u_max − u_avg
constexpr long step_limit = 3'000'000;

/// Settles soonest, measured from ratios of 1 to 1e5 between axis and wall: a stiffer lattice makes the plug's
/// stress follow slowly, a softer one the wall's layer.
LatticeUnits units(const NozzleFlow& flow, int nodes) {
    const double apparent = flow.pressure_gradient() * flow.radius() * flow.radius() /
                            (8.0 * flow.velocity_average() * cross_law(flow.ink()).eta0);
    constexpr double velocity_lu = 0.05;
    return units_for_flow(flow, nodes).with(velocity_lu, 0.3 * nodes / std::sqrt(apparent), flow);
}

/// The lattice's own developed profile, so that nothing develops behind the inflow.
struct Tube {
    std::vector<double> nodes, links, slope;
    double axis;
};

double on_axis(const lattice::AxisymmetricFields& f, int i) {
    return (9.0 * f.velocity_x[f.at(i, 0)] - f.velocity_x[f.at(i, 1)]) / 8.0;
}

Tube tube(const NozzleFlow& flow, const LatticeUnits& u) {
    const LatticeProfile exact = lattice_profile(flow, u);
    lattice::AxisymmetricFlow lattice({.length = 16,
                                       .radius = u.radius,
                                       .lip = 16,
                                       .periodic = true,
                                       .body_force = exact.pressure_gradient},
                                      u.relaxation(flow.ink()));
    lattice.start(exact.velocity, exact.slope, 0.0);
    lattice.run_to_steady(0.1 * steady_tolerance, step_limit);
    const auto f = lattice.measure();
    Tube t{.nodes = {}, .links = {}, .slope = exact.slope, .axis = on_axis(f, 0)};
    const int n = u.radius;
    const auto at = [&](int j) { return f.velocity_x[f.at(0, j >= 0 ? j : -1 - j)]; };
    for (int j = 0; j < n; ++j) t.nodes.push_back(at(j));
    for (int j = 0; j < n - 1; ++j) {
        t.links.push_back((9.0 * (at(j - 1) + at(j)) - at(j - 2) - at(j + 1)) / 16.0);
    }
    t.links.push_back(at(n - 1) + at(n - 2) / 3.0);
    t.links.push_back(0.0);
    return t;
}

/// Where f is kept: densest about the lip.
std::vector<double> places() {
    std::vector<double> x;
    const auto add = [&](double to, double step) {
        for (const double from = x.back(); x.back() < to - 0.5 * step;) {
            x.push_back(from + step * std::round((x.back() - from) / step + 1.0));
        }
    };
    x.push_back(-8.0);
    add(-3.0, 0.25);
    add(-1.0, 0.1);
    add(1.0, 0.04);
    add(3.0, 0.1);
    return x;
}

/// Between the columns; 1 before the inflow.
double interpolate(const std::vector<double>& x, const std::vector<double>& f, double at) {
    return at < x.front() ? 1.0 : cubic_between(x, f, at);
}

int columns(double radii, int nodes) {
    return static_cast<int>(std::lround(radii * nodes));
}

std::vector<double> simulated(const NozzleFlow& flow, int nodes) {
    const LatticeUnits u = units(flow, nodes);
    const Tube t = tube(flow, u);
    const double plug = 1.0 - flow.velocity_excess() / flow.velocity_average();
    const int lip = columns(4.0 + 5.0 * plug, nodes);
    const int length = (lip + columns(3.5, nodes) + 15) / 16 * 16;
    lattice::AxisymmetricFlow lattice({.length = length, .radius = nodes, .lip = lip},
                                      u.relaxation(flow.ink()), t.nodes, t.links);
    lattice.start(t.nodes, t.slope, lattice_profile(flow, u).pressure_gradient);
    const double tolerance = steady_tolerance * flow.velocity_excess() / flow.velocity_max();
    if (!lattice.run_to_steady(tolerance, step_limit)) return {};
    const auto fields = lattice.measure();
    const double end = on_axis(fields, length - 1);
    std::vector<double> x;
    std::vector<double> f;
    for (int i = 0; i < length; ++i) {
        x.push_back((i + 0.5 - lip) / nodes);
        f.push_back((on_axis(fields, i) - end) / (t.axis - end));
    }
    std::fprintf(stderr, "%ld steps, axis %.5f of %.5f, end %.5f", lattice.steps(), t.axis / u.velocity_lu,
                 flow.velocity_max() / velocity, end / u.velocity_lu);
    std::vector<double> kept;
    for (const double at : places()) kept.push_back(interpolate(x, f, at));
    return kept;
}

std::string key(const Entry& e, int nodes) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%g,%g,%g,%d", e.alpha, e.rate, e.remainder, nodes);
    return text.data();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 2;
    const int fine = argc > 2 ? std::atoi(argv[2]) : 48;
    const double least = argc > 3 ? std::atof(argv[3]) : 0.0;
    std::set<std::string> done;
    std::ifstream before(argv[1]);
    for (std::string line; std::getline(before, line);) {
        std::size_t end = 0;
        for (int i = 0; i < 4 && end != std::string::npos; ++i) end = line.find(',', end + (i > 0 ? 1 : 0));
        done.insert(line.substr(0, end));
    }
    std::FILE* file = std::fopen(argv[1], "a");
    if (file == nullptr) return 4;
    if (done.empty()) {
        std::fprintf(file, "alpha,rate,remainder,nodes,held_out,excess,wall_index");
        for (const double x : places()) std::fprintf(file, ",f(%g)", x);
        std::fprintf(file, "\n");
    }
    for (const int nodes : {fine / 2, fine}) {
        for (const Entry& e : entries) {
            if (done.contains(key(e, nodes))) continue;
            const CrossInk ink{.eta0 = 10.0,
                               .eta_inf = 10.0 * e.remainder,
                               .time_constant = e.rate * radius / velocity,
                               .alpha = e.alpha};
            const NozzleFlow flow = NozzleFlow::from_velocity(ink, radius, velocity);
            const double excess = flow.velocity_excess() / velocity;
            if (1.0 - excess < least) continue;
            std::fprintf(stderr, "%s: ", key(e, nodes).c_str());
            const auto start = std::chrono::steady_clock::now();
            const std::vector<double> line = simulated(flow, nodes);
            std::fprintf(stderr, ", %.1f s\n",
                         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            if (line.empty()) continue;
            std::fprintf(file, "%s,%d,%.6g,%.6g", key(e, nodes).c_str(), e.held_out ? 1 : 0, excess,
                         flow_index(ink, flow.shear_rate_max()));
            for (const double f : line) std::fprintf(file, ",%.6f", f);
            std::fprintf(file, "\n");
            std::fflush(file);
        }
    }
    std::fclose(file);
    return 0;
}
