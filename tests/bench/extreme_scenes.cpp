#include "bench/extreme_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bioprint/flow/nozzle_flow.hpp"
#include "bioprint/io/number_format.hpp"
#include "numerics/quasi_random.hpp"

namespace bioprint::extremes {
namespace {

// The ranges drawn from.
constexpr double least_modulus = 20.0, most_modulus = 1e6;
constexpr double most_alpha = 0.95;
constexpr double least_rate = 1e-4, most_rate = 1e6;
constexpr double least_velocity = 1e-6, most_velocity = 1.0;
constexpr double least_confinement = 0.02, most_confinement = 0.8;
constexpr double least_load = 0.05, most_load = 30.0;  ///< of the neighbourhood of what a cell bears
/// Below it a run costs ten seconds and more; few go there.
constexpr double usual_confinement = 0.1;

constexpr std::array<const char*, 4> kinds = {"exit-flow", "channel", "exit", "shear"};

double decades(double share, double low, double high) {
    return low * std::pow(high / low, share);
}

NozzleFlow flow_of(const ExtremeScene& scene) {
    const double time_constant = scene.reduced_rate * nozzle_radius / (4.0 * scene.velocity);
    return NozzleFlow::from_velocity(
        CrossInk{.eta0 = eta0, .time_constant = time_constant, .alpha = scene.alpha}, nozzle_radius,
        scene.velocity);
}

/// The velocity at which the nozzle loads the cell so; at a fixed reduced rate all stresses are linear in it.
double velocity_for(ExtremeScene scene, double load) {
    scene.velocity = 1.0;
    return std::clamp(load / scene.load(), least_velocity, most_velocity);
}

void add_corners(std::vector<ExtremeScene>& list) {
    for (const char* const kind : kinds) {
        const bool cell = std::string(kind) != "exit-flow";
        for (int bits = 0; bits < (cell ? 32 : 8); ++bits) {
            const auto high = [&](int bit) { return (bits >> bit & 1) != 0; };
            ExtremeScene scene{.number = 0,
                               .group = "corner",
                               .kind = kind,
                               .alpha = high(0) ? most_alpha : 0.0,
                               .reduced_rate = high(1) ? most_rate : least_rate,
                               .velocity = high(2) ? most_velocity : least_velocity,
                               .confinement = high(4) ? most_confinement : 0.1,
                               .shear_modulus = high(3) ? most_modulus : least_modulus};
            if (scene.kind == "shear") scene.stress = (high(4) ? 1e4 : 1e-4) * scene.shear_modulus;
            // Every second pair of corners of the small cell is that of the smallest, which costs most.
            if (!high(4) && cell && scene.kind != "shear" && (bits & 5) == 0)
                scene.confinement = least_confinement;
            list.push_back(scene);
        }
    }
}

void add_interior(std::vector<ExtremeScene>& list, int count) {
    constexpr std::size_t dimensions = 6;
    const std::vector<double> points = sobol_points(dimensions, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double* const p = &points[static_cast<std::size_t>(i) * dimensions];
        const double least = i % 16 == 1 ? least_confinement : usual_confinement;
        ExtremeScene scene{.number = 0,
                           .group = "interior",
                           .kind = kinds[static_cast<std::size_t>(i) % kinds.size()],
                           .alpha = p[0] * most_alpha,
                           .reduced_rate = decades(p[1], least_rate, most_rate),
                           .velocity = decades(p[2], least_velocity, most_velocity),
                           .confinement = decades(p[3], least, most_confinement),
                           .shear_modulus = decades(p[4], least_modulus, most_modulus)};
        if (scene.kind == "shear") scene.stress = decades(p[5], 1e-5, 1e5) * scene.shear_modulus;
        list.push_back(scene);
    }
}

void add_edges(std::vector<ExtremeScene>& list, int count) {
    constexpr std::size_t dimensions = 5;
    const std::vector<double> points = sobol_points(dimensions, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double* const p = &points[static_cast<std::size_t>(i) * dimensions];
        ExtremeScene scene{.number = 0,
                           .group = "edge",
                           .kind = kinds[1 + static_cast<std::size_t>(i) % 3],
                           .alpha = p[0] * most_alpha,
                           .reduced_rate = decades(p[1], least_rate, most_rate),
                           .velocity = 1.0,
                           .confinement = decades(p[2], usual_confinement, 0.62),
                           .shear_modulus = decades(p[3], least_modulus, most_modulus)};
        const double load = decades(p[4], least_load, most_load);
        if (scene.kind == "shear") {
            scene.stress = load * scene.shear_modulus;
        } else {
            scene.velocity = velocity_for(scene, load);
        }
        list.push_back(scene);
    }
}

void add_walls(std::vector<ExtremeScene>& list, int count) {
    constexpr std::size_t dimensions = 5;
    const std::vector<double> points = sobol_points(dimensions, static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double* const p = &points[static_cast<std::size_t>(i) * dimensions];
        ExtremeScene scene{.number = 0,
                           .group = "wall",
                           .kind = i % 4 == 3 ? "exit" : "channel",
                           .alpha = p[0] * 0.9,
                           .reduced_rate = decades(p[1], 1e-2, 1e4),
                           .velocity = 1.0,
                           .confinement = decades(p[2], 0.16, 0.5),
                           .shear_modulus = decades(p[3], 1e2, 1e5)};
        scene.velocity = velocity_for(scene, decades(p[4], 0.02, 2.0));
        const double gap = decades((i + 0.5) / count, 1.0, 8.0);  // nodes
        scene.offset = std::max(0.01, 1.0 - scene.confinement * (1.0 + gap / draft_nodes));
        list.push_back(scene);
    }
}

/// A cell of 8 µm and 1 kPa in the reference alginate at 5 mm/s.
ExtremeScene usual_scene(const std::string& kind) {
    return {.number = 0,
            .group = "ratio",
            .kind = kind,
            .alpha = 0.75,
            .reduced_rate = 20.0,
            .velocity = 5e-3,
            .confinement = 0.16,
            .shear_modulus = 1e3,
            .stress = kind == "shear" ? 1e3 : 0.0};
}

void add_ratios(std::vector<ExtremeScene>& list) {
    for (const char* const kind : kinds) {
        for (const double inner : {1e-6, 0.2, 5.0, 1e6}) {
            list.push_back(usual_scene(kind));
            list.back().inner_ratio = inner;
        }
    }
    for (const double poisson : {0.0, 0.3, 0.48, 0.499}) {
        list.push_back(usual_scene("channel"));
        list.back().poisson = poisson;
    }
}

void number_them(std::vector<ExtremeScene>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) list[i].number = static_cast<int>(i) + 1;
}

std::string text(double value) {
    return format_shortest(value);
}

}  // namespace

double ExtremeScene::load() const {
    if (kind == "exit-flow") return 0.0;
    if (kind == "shear") return stress / shear_modulus;
    return flow_of(*this).pressure_gradient() * cell_radius() / shear_modulus;
}

std::vector<std::string> ExtremeScene::arguments(double nodes) const {
    const bool shear = kind == "shear";
    std::vector<std::string> words = {
        "--simulate=" + kind,
        "--radius=" + text(nozzle_radius),
        "--eta0=" + text(eta0),
        "--alpha=" + text(alpha),
        "--time-constant=" + text(reduced_rate * nozzle_radius / (4.0 * velocity)),
        "--velocity=" + text(velocity),
        "--cell-radius=" + text(cell_radius()),
        "--shear-modulus=" + text(shear_modulus),
        "--poisson-ratio=" + text(poisson),
        "--offset=" + text(offset * nozzle_radius),
        "--resolution=" + text(nodes),
        "--jobs=1",
        "--format=jsonl"};
    if (shear) words.push_back("--fluid-stress=" + text(stress));
    if (inner_ratio != 1.0) words.push_back("--viscosity-ratio=" + text(inner_ratio));
    return words;
}

std::vector<ExtremeScene> extreme_scenes() {
    std::vector<ExtremeScene> list;
    add_corners(list);
    add_interior(list, 112);
    add_edges(list, 96);
    add_walls(list, 20);
    add_ratios(list);
    number_them(list);
    return list;
}

std::vector<ExtremeScene> few_extreme_scenes() {
    std::vector<ExtremeScene> list;
    const auto add = [&](const char* kind, const auto& change) {
        list.push_back(usual_scene(kind));
        change(list.back());
    };
    const auto newtonian = [](ExtremeScene& s) {
        s.alpha = 0.0;
        s.reduced_rate = least_rate;
    };
    for (const double velocity : {least_velocity, most_velocity}) {
        add("exit-flow", [&](ExtremeScene& s) { newtonian(s), s.velocity = velocity; });
        add("exit-flow", [&](ExtremeScene& s) { s.reduced_rate = least_rate, s.velocity = velocity; });
    }
    // Broke down once, for the force was of one position.
    for (const double confinement : {0.16, 0.4, 0.6})
        add("channel", [&](ExtremeScene& s) {
            newtonian(s), s.velocity = 1e-3, s.shear_modulus = 1e5, s.confinement = confinement;
        });
    add("exit", [&](ExtremeScene& s) { newtonian(s), s.velocity = 1e-3, s.shear_modulus = 1e4; });
    add("exit", [](ExtremeScene&) {});
    add("channel", [](ExtremeScene& s) { s.velocity = least_velocity, s.shear_modulus = most_modulus; });
    add("exit", [](ExtremeScene& s) { s.velocity = most_velocity, s.shear_modulus = least_modulus; });
    add("exit", [](ExtremeScene& s) { s.confinement = most_confinement; });
    // Was off by half without a word.
    add("shear", [](ExtremeScene& s) { s.stress = 2.8 * s.shear_modulus; });
    add("shear", [](ExtremeScene& s) { s.stress = 1e-4 * s.shear_modulus; });
    add("shear", [](ExtremeScene&) {});
    for (const double inner : {0.2, 5.0}) add("exit", [&](ExtremeScene& s) { s.inner_ratio = inner; });
    add("channel", [](ExtremeScene& s) { s.offset = 1.0 - s.confinement * (1.0 + 1.0 / draft_nodes); });
    add("channel", [](ExtremeScene& s) { s.poisson = 0.499; });
    number_them(list);
    return list;
}

}  // namespace bioprint::extremes
