#include "simulate/pictures.hpp"

namespace bioprint {

CellPicture cell_picture(const ImmersedCell& cell, const LatticeUnits& units, const PictureFrame& frame) {
    CellPicture picture;
    const solid::RingMesh& mesh = cell.body().mesh();
    const double centre = cell.shape().centre;
    const auto positions = cell.positions();
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const solid::RingPoint& now = positions[v];
        const solid::RingPoint& rest = mesh.vertices[v];
        picture.position.push_back({(now.x + frame.offset) * units.spacing, now.r * units.spacing, 0.0});
        picture.displacement.push_back(
            {(now.x - centre - rest.x) * units.spacing, (now.r - rest.r) * units.spacing, 0.0});
    }
    for (const auto& triangle : mesh.triangles) {
        picture.elements.insert(picture.elements.end(), triangle.begin(), triangle.end());
    }
    for (const double stress : cell.von_mises()) {
        picture.von_mises.push_back(stress * units.stress);
    }
    picture.jacobian = cell.body().jacobians(positions);
    return picture;
}

FlowPicture flow_picture(const lattice::AxisymmetricFlow& flow, const LatticeUnits& units,
                         const PictureFrame& frame) {
    const lattice::AxisymmetricFields fields = flow.measure();
    const double kinematic = units.stress * units.time_step;  // viscosity of a lattice of density 1
    FlowPicture picture;
    picture.nodes = {fields.length, fields.radius, 1};
    picture.origin = {(frame.first + 0.5 + frame.offset) * units.spacing, 0.5 * units.spacing, 0.0};
    picture.spacing = units.spacing;
    for (int j = 0; j < fields.radius; ++j) {
        for (int i = 0; i < fields.length; ++i) {
            const int column = (((frame.first + i) % fields.length) + fields.length) % fields.length;
            const std::size_t at = fields.at(column, j);
            picture.velocity.push_back({(fields.velocity_x[at] + frame.drift) * units.velocity,
                                        fields.velocity_r[at] * units.velocity, 0.0});
            picture.pressure.push_back(fields.pressure[at] * units.stress);
            picture.shear_rate.push_back(fields.rate[at] / units.time_step);
            picture.viscosity.push_back(fields.viscosity[at] * kinematic);
            picture.stress.push_back(fields.viscosity[at] * fields.rate[at] * units.stress);
        }
    }
    return picture;
}

}  // namespace bioprint
