#pragma once

#include <array>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

/// Meshes of tetrahedra: balls of radius 1 and their halves z ≥ 0, made by tools/make-meshes and part of the
/// library.
namespace bioprint {

struct TetraMesh {
    std::vector<std::array<double, 3>> nodes;
    std::vector<std::array<int, 4>> elements;  ///< nodes of each, positive volume
};

/// Reads the compact text form: "tetrahedra 1", counts, nodes, elements.
/// @throws DataError  not that form, an index out of range, or an element without positive volume
TetraMesh read_tetra_mesh(std::istream& input, const std::string& name);

/// Volume of the mesh.
double volume(const TetraMesh& mesh);

/// A ball (or half ball, z ≥ 0) of a given radius about the origin whose edges come nearest to `edge`. The
/// mesh is scaled so that its polyhedron has the volume of the ball: the coarse ones would otherwise be up to
/// 2 % too small.
TetraMesh ball_mesh(double radius, double edge, bool half);

/// The ball of about the number of elements of Müller et al. 2020 (9376).
TetraMesh paper_ball_mesh(double radius);

/// The text of a built-in mesh, by its file name without ".tet"; empty when there is none.
std::string_view tetra_mesh_text(std::string_view name);

}  // namespace bioprint
