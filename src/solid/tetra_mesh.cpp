#include "solid/tetra_mesh.hpp"

#include <cmath>
#include <istream>
#include <numbers>
#include <sstream>

#include "bioprint/errors.hpp"
#include "solid/tetra_moments.hpp"

namespace bioprint {

namespace {

struct Known {
    const char* name;
    double edge;  ///< in radii
};
constexpr Known whole_balls[] = {{"ball-h33", 1.0 / 3},
                                 {"ball-h25", 0.25},
                                 {"ball-h20", 0.2},
                                 {"ball-h16", 1.0 / 6},
                                 {"ball-paper", 0.1305}};
constexpr Known half_balls[] = {{"half-h65", 0.65},    {"half-h50", 0.5},  {"half-h40", 0.4},
                                {"half-h33", 1.0 / 3}, {"half-h25", 0.25}, {"half-h20", 0.2},
                                {"half-h16", 1.0 / 6}, {"half-h12", 0.125}};

/// The finest mesh that is not finer than asked for, give or take a twentieth: an immersed mesh finer than
/// the lattice can move carries noise. Lists fall in edge length.
template <std::size_t size>
const char* mesh_for(const Known (&list)[size], double edge) {
    const char* name = list[0].name;
    for (const Known& known : list) {
        if (known.edge >= 0.95 * edge) {
            name = known.name;
        }
    }
    return name;
}

double element_volume(const TetraMesh& mesh, const std::array<int, 4>& element) {
    std::array<std::array<double, 3>, 3> e{};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            e[i][k] = mesh.nodes[element[i + 1]][k] - mesh.nodes[element[0]][k];
        }
    }
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
            e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6.0;
}

Moments moments_of(const TetraMesh& mesh) {
    Moments m;
    for (const auto& element : mesh.elements) {
        m.add(mesh.nodes, element, element_volume(mesh, element));
    }
    return m;
}

/// Moves the nodes until the mesh has the centre and the shape of inertia of a ball, which a coarse one misses by a
/// hundredth: as much as a stiff cell deforms. The plane of half a ball stays where it is.
void make_round(TetraMesh& mesh, bool half) {
    constexpr int passes = 4;  // each squares what is left
    for (int pass = 0; pass < passes; ++pass) {
        Moments m = moments_of(mesh);
        for (auto& node : mesh.nodes) {
            for (int i = 0; i < (half ? 2 : 3); ++i) {
                node[i] -= m.first[i] / m.volume;
            }
        }
        m = moments_of(mesh);
        if (half) {
            m.second[0][2] = m.second[2][0] = m.second[1][2] = m.second[2][1] = 0.0;
        }
        const double mean = (m.second[0][0] + m.second[1][1] + m.second[2][2]) / 3.0;
        for (auto& node : mesh.nodes) {
            const auto before = node;
            for (int i = 0; i < 3; ++i) {
                for (int k = 0; k < 3; ++k) {
                    node[i] -= 0.5 * (m.second[i][k] / mean - (i == k ? 1.0 : 0.0)) * before[k];
                }
            }
        }
    }
}

TetraMesh scaled_ball(const char* name, double radius, bool half) {
    std::istringstream text{std::string(tetra_mesh_text(name))};
    TetraMesh mesh = read_tetra_mesh(text, name);
    make_round(mesh, half);
    const double ball = 4.0 / 3.0 * std::numbers::pi * (half ? 0.5 : 1.0);
    const double scale = radius * std::cbrt(ball / volume(mesh));
    for (auto& node : mesh.nodes) {
        for (double& x : node) {
            x *= scale;
        }
    }
    return mesh;
}

}  // namespace

TetraMesh read_tetra_mesh(std::istream& input, const std::string& name) {
    constexpr long most = 100'000'000;
    std::string word;
    int version = 0;
    long nodes = 0;
    long elements = 0;
    input.imbue(std::locale::classic());
    if (!(input >> word >> version >> nodes >> elements) || word != "tetrahedra" || version != 1 ||
        nodes < 4 || elements < 1 || nodes > most || elements > most) {
        throw DataError(name + ": not a mesh: it must start with 'tetrahedra 1' and two counts");
    }
    TetraMesh mesh;
    for (long i = 0; i < nodes; ++i) {
        auto& node = mesh.nodes.emplace_back();
        if (!(input >> node[0] >> node[1] >> node[2])) {
            throw DataError(name + ": node " + std::to_string(i) + " is not three numbers");
        }
    }
    for (long i = 0; i < elements; ++i) {
        auto& element = mesh.elements.emplace_back();
        for (int& corner : element) {
            if (!(input >> corner) || corner < 0 || corner >= nodes) {
                throw DataError(name + ": element " + std::to_string(i) +
                                " names a node that does not exist");
            }
        }
        if (!(element_volume(mesh, element) > 0.0)) {
            throw DataError(name + ": element " + std::to_string(i) + " has no positive volume");
        }
    }
    return mesh;
}

double volume(const TetraMesh& mesh) {
    double sum = 0.0;
    for (const auto& element : mesh.elements) {
        sum += element_volume(mesh, element);
    }
    return sum;
}

TetraMesh ball_mesh(double radius, double edge, bool half) {
    return scaled_ball(half ? mesh_for(half_balls, edge / radius) : mesh_for(whole_balls, edge / radius),
                       radius, half);
}

TetraMesh paper_ball_mesh(double radius) {
    return scaled_ball("ball-paper", radius, false);
}

}  // namespace bioprint
