#include "simulate/space_pictures.hpp"

#include <cmath>

namespace bioprint {
namespace {

template <class Real>
CellPicture picture_of(const ImmersedBody<Real>& cell, const SpaceScale& scale, const Vector3& centre) {
    CellPicture picture;
    picture.nodes_per_element = 4;
    const TetraMesh& mesh = cell.solid().mesh();
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        const Vector3& now = cell.positions()[n];
        const auto& rest = mesh.nodes[n];
        picture.position.push_back(
            {now[0] * scale.spacing + scale.offset, now[1] * scale.spacing, now[2] * scale.spacing});
        // The mirror plane stays where it is.
        picture.displacement.push_back({(now[0] - centre[0] - rest[0]) * scale.spacing,
                                        (now[1] - centre[1] - rest[1]) * scale.spacing,
                                        (now[2] - rest[2]) * scale.spacing});
    }
    for (const auto& element : mesh.elements) {
        picture.elements.insert(picture.elements.end(), element.begin(), element.end());
    }
    for (const ElementState& element : cell.solid().elements(cell.positions())) {
        picture.von_mises.push_back(element.von_mises * scale.stress);
        picture.jacobian.push_back(element.jacobian);
    }
    return picture;
}

template <class Real>
FlowPicture picture_of(const D3q19<Real>& lattice, const SpaceScale& scale, int first) {
    const Section& section = lattice.section();
    const int nx = lattice.nx();
    const double all = static_cast<double>(nx) * section.ny * section.nz;
    const int stride = std::max(1, static_cast<int>(std::ceil(std::cbrt(all / most_points))));
    const auto points = [&](int nodes) { return (nodes + stride - 1) / stride; };
    const double velocity = scale.spacing / scale.time;
    FlowPicture picture;
    picture.nodes = {points(nx), points(section.ny), points(section.nz)};
    picture.origin = {(first + 0.5) * scale.spacing + scale.offset, section.y_of(0) * scale.spacing,
                      section.z_of(0) * scale.spacing};
    picture.spacing = stride * scale.spacing;
    for (int z = 0; z < section.nz; z += stride) {
        for (int y = 0; y < section.ny; y += stride) {
            const int row = section.is_fluid(y, z) ? lattice.row(y, z) : -1;
            for (int i = 0; i < nx; i += stride) {
                const int x = (((first + i) % nx) + nx) % nx;
                const NodeState node = row < 0 ? NodeState{} : lattice.at(x, row);
                picture.fluid.push_back(row < 0 ? 0 : 1);
                const double drift = row < 0 ? 0.0 : scale.velocity;
                picture.velocity.push_back({node.velocity[0] * velocity + drift, node.velocity[1] * velocity,
                                            node.velocity[2] * velocity});
                picture.pressure.push_back(node.density / 3.0 * scale.stress);
                picture.shear_rate.push_back(node.rate / scale.time);
                picture.viscosity.push_back(node.viscosity * scale.stress * scale.time);
                picture.stress.push_back(node.viscosity * node.rate * scale.stress);
            }
        }
    }
    return picture;
}

}  // namespace

template <class Real>
SimulationSnapshot space_picture(const D3q19<Real>& lattice, const ImmersedBody<Real>& cell,
                                 const SpaceScale& scale, double time) {
    const Vector3 centre = cell.state().ellipsoid.centre;
    const int first = scale.centred ? static_cast<int>(std::floor(centre[0])) - lattice.nx() / 2 : 0;
    return {.stage = "",
            .time = time,
            .cell = picture_of(cell, scale, centre),
            .flow = picture_of(lattice, scale, first)};
}

template SimulationSnapshot space_picture<float>(const D3q19<float>&, const ImmersedBody<float>&,
                                                 const SpaceScale&, double);
template SimulationSnapshot space_picture<double>(const D3q19<double>&, const ImmersedBody<double>&,
                                                  const SpaceScale&, double);

}  // namespace bioprint
