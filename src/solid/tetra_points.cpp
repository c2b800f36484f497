#include "solid/tetra_points.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <cmath>

namespace bioprint {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Factor = Eigen::SimplicialLLT<Sparse>;

// The rule of four points, exact to the second degree: (5 + 3√5)/20 from one corner, (5 − √5)/20 from the
// others.
const double near_corner = (5.0 + 3.0 * std::sqrt(5.0)) / 20.0;
const double far_corner = (5.0 - std::sqrt(5.0)) / 20.0;

double rest_volume(const TetraMesh& mesh, const std::array<int, 4>& t) {
    Eigen::Matrix3d d;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            d(i, k) = mesh.nodes[t[k + 1]][i] - mesh.nodes[t[0]][i];
        }
    }
    return d.determinant() / 6.0;
}

}  // namespace

struct TetraPoints::Mass {
    std::vector<bool> held;
    Factor free;
    Factor mirrored;
    Eigen::Matrix<double, Eigen::Dynamic, 2> in_plane;
    Eigen::VectorXd across;
};

TetraPoints::TetraPoints(const TetraMesh& mesh, bool half) : mass_(std::make_unique<Mass>()) {
    const auto n = static_cast<Eigen::Index>(mesh.nodes.size());
    for (const auto& t : mesh.elements) {
        const double volume = rest_volume(mesh, t);
        for (int corner = 0; corner < 4; ++corner) {
            Point point{
                .node = t, .basis = {far_corner, far_corner, far_corner, far_corner}, .weight = volume / 4.0};
            point.basis[corner] = near_corner;
            points_.push_back(point);
        }
    }
    for (const auto& node : mesh.nodes) {
        mass_->held.push_back(half && node[2] == 0.0);
    }
    std::vector<Eigen::Triplet<double>> all;
    std::vector<Eigen::Triplet<double>> without;
    for (const Point& q : points_) {
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < 4; ++b) {
                const double value = q.weight * q.basis[a] * q.basis[b];
                all.emplace_back(q.node[a], q.node[b], value);
                if ((!mass_->held[q.node[a]] && !mass_->held[q.node[b]]) || q.node[a] == q.node[b]) {
                    without.emplace_back(q.node[a], q.node[b], value);
                }
            }
        }
    }
    Sparse matrix(n, n);
    matrix.setFromTriplets(all.begin(), all.end());
    mass_->free.compute(matrix);
    matrix.setFromTriplets(without.begin(), without.end());
    mass_->mirrored.compute(matrix);
    mass_->in_plane.resize(n, 2);
    mass_->across.resize(n);
}

TetraPoints::~TetraPoints() = default;

void TetraPoints::place(const std::vector<Vector3>& nodes, std::vector<Vector3>& points) const {
    points.resize(points_.size());
    for (std::size_t q = 0; q < points_.size(); ++q) {
        points[q] = {};
        for (int a = 0; a < 4; ++a) {
            for (int i = 0; i < 3; ++i) {
                points[q][i] += points_[q].basis[a] * nodes[points_[q].node[a]][i];
            }
        }
    }
}

void TetraPoints::solve() {
    Mass& m = *mass_;
    for (std::size_t a = 0; a < m.held.size(); ++a) {
        if (m.held[a]) {
            m.across(static_cast<Eigen::Index>(a)) = 0.0;
        }
    }
    m.in_plane = m.free.solve(m.in_plane).eval();
    m.across = m.mirrored.solve(m.across).eval();
}

void TetraPoints::spread(const std::vector<Vector3>& nodes, std::vector<Vector3>& points) {
    Mass& m = *mass_;
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        m.in_plane(i, 0) = nodes[a][0];
        m.in_plane(i, 1) = nodes[a][1];
        m.across(i) = nodes[a][2];
    }
    solve();
    points.resize(points_.size());
    for (std::size_t q = 0; q < points_.size(); ++q) {
        points[q] = {};
        for (int a = 0; a < 4; ++a) {
            const double share = points_[q].weight * points_[q].basis[a];
            const int node = points_[q].node[a];
            points[q][0] += share * m.in_plane(node, 0);
            points[q][1] += share * m.in_plane(node, 1);
            points[q][2] += share * m.across(node);
        }
    }
}

void TetraPoints::gather(const std::vector<Vector3>& points, std::vector<Vector3>& nodes) {
    Mass& m = *mass_;
    m.in_plane.setZero();
    m.across.setZero();
    for (std::size_t q = 0; q < points_.size(); ++q) {
        for (int a = 0; a < 4; ++a) {
            const double share = points_[q].weight * points_[q].basis[a];
            const int node = points_[q].node[a];
            m.in_plane(node, 0) += share * points[q][0];
            m.in_plane(node, 1) += share * points[q][1];
            m.across(node) += share * points[q][2];
        }
    }
    solve();
    nodes.resize(m.held.size());
    for (std::size_t a = 0; a < nodes.size(); ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        nodes[a] = {m.in_plane(i, 0), m.in_plane(i, 1), m.across(i)};
    }
}

}  // namespace bioprint
