#include "solid/tetra_solid.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "solid/tetra_moments.hpp"

namespace bioprint {

// F deformation gradient, J = det F, cof F = J F^(−T), P = ∂U/∂F.

namespace {

double determinant(const Matrix3& m) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

Matrix3 cofactor(const Matrix3& m) {
    Matrix3 c{};
    for (int i = 0; i < 3; ++i) {
        const int i1 = (i + 1) % 3;
        const int i2 = (i + 2) % 3;
        for (int k = 0; k < 3; ++k) {
            const int k1 = (k + 1) % 3;
            const int k2 = (k + 2) % 3;
            c[i][k] = m[i1][k1] * m[i2][k2] - m[i1][k2] * m[i2][k1];
        }
    }
    return c;
}

double square(const Matrix3& m) {
    double sum = 0.0;
    for (const auto& row : m) {
        sum += row[0] * row[0] + row[1] * row[1] + row[2] * row[2];
    }
    return sum;
}

/// Edges from node 0 of an element, one a column: ∂x/∂(local coordinates).
Matrix3 edges(const std::vector<Vector3>& positions, const std::array<int, 4>& element) {
    Matrix3 d{};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            d[i][k] = positions[element[k + 1]][i] - positions[element[0]][i];
        }
    }
    return d;
}

Matrix3 cauchy_stress(const Matrix3& f, double j, const Elasticity& e) {
    Matrix3 s{};
    const double scale = e.shear_modulus * std::pow(j, -5.0 / 3.0);
    const double mean = square(f) / 3.0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const double b = f[i][0] * f[k][0] + f[i][1] * f[k][1] + f[i][2] * f[k][2];
            s[i][k] = scale * (i == k ? b - mean : b);
        }
        s[i][i] += e.bulk_modulus * (j - 1.0);
    }
    return s;
}

double von_mises(const Matrix3& s) {
    const double xy = s[0][0] - s[1][1];
    const double yz = s[1][1] - s[2][2];
    const double zx = s[2][2] - s[0][0];
    const double shear = s[0][1] * s[0][1] + s[1][2] * s[1][2] + s[0][2] * s[0][2];
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

double quality(const Matrix3& d, double volume) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) {
            const double across = d[i][k] - d[i][(k + 1) % 3];
            sum += d[i][k] * d[i][k] + across * across;
        }
    }
    return 6.0 * std::sqrt(2.0) * volume / std::pow(sum / 6.0, 1.5);
}

Ellipsoid equivalent_ellipsoid(const Moments& moments) {
    Ellipsoid e{};
    Eigen::Matrix3d m;
    for (int i = 0; i < 3; ++i) {
        e.centre[i] = moments.first[i] / moments.volume;
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            m(i, k) = moments.second[i][k] / moments.volume - e.centre[i] * e.centre[k];
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
    for (int k = 0; k < 3; ++k) {
        // Eigenvalues rise; a solid ellipsoid has second moments a²/5.
        const int from = 2 - k;
        e.semi_axes[k] = std::sqrt(5.0 * std::max(solver.eigenvalues()(from), 0.0));
        for (int i = 0; i < 3; ++i) {
            e.directions[k][i] = solver.eigenvectors()(i, from);
        }
    }
    e.inclination = std::atan(e.directions[0][1] / e.directions[0][0]);
    return e;
}

}  // namespace

Elasticity elasticity(double shear_modulus, double poisson_ratio) {
    return {shear_modulus, 2.0 * shear_modulus * (1.0 + poisson_ratio) / (3.0 * (1.0 - 2.0 * poisson_ratio))};
}

TetraSolid::TetraSolid(TetraMesh mesh, const Elasticity& elasticity, bool half)
    : mesh_(std::move(mesh)), elasticity_(elasticity), half_(half) {
    for (const auto& element : mesh_.elements) {
        const Matrix3 d = edges(mesh_.nodes, element);
        const double det = determinant(d);
        const Matrix3 c = cofactor(d);
        Element rest{.gradient = {}, .volume = det / 6.0};
        // Rows of the inverse of d are the gradients: inverse = cofactorᵀ/det.
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 3; ++i) {
                rest.gradient[k][i] = c[i][k] / det;
            }
        }
        rest_volume_ += rest.volume * (half_ ? 2.0 : 1.0);
        elements_.push_back(rest);
    }
}

Matrix3 TetraSolid::deformation(std::size_t element, const std::vector<Vector3>& positions) const {
    const Matrix3 d = edges(positions, mesh_.elements[element]);
    const Matrix3& g = elements_[element].gradient;
    Matrix3 f{};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            f[i][k] = d[i][0] * g[0][k] + d[i][1] * g[1][k] + d[i][2] * g[2][k];
        }
    }
    return f;
}

double TetraSolid::energy(const std::vector<Vector3>& positions) const {
    double sum = 0.0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Matrix3 f = deformation(e, positions);
        const double j = determinant(f);
        if (j <= 0.0) {
            return std::numeric_limits<double>::infinity();
        }
        const double invariant = square(f) / std::cbrt(j * j);
        sum += elements_[e].volume * (0.5 * elasticity_.shear_modulus * (invariant - 3.0) +
                                      0.5 * elasticity_.bulk_modulus * (j - 1.0) * (j - 1.0));
    }
    return sum * (half_ ? 2.0 : 1.0);
}

int TetraSolid::forces(const std::vector<Vector3>& positions, std::vector<Vector3>& forces) const {
    forces.assign(positions.size(), Vector3{});
    int inverted = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Matrix3 f = deformation(e, positions);
        const double j = determinant(f);
        if (!(j > 0.0)) {
            ++inverted;
            continue;
        }
        const Matrix3 c = cofactor(f);
        const double isochoric = elasticity_.shear_modulus / std::cbrt(j * j);
        const double along = elasticity_.bulk_modulus * (j - 1.0) - isochoric * square(f) / (3.0 * j);
        const Element& rest = elements_[e];
        const std::array<int, 4>& corner = mesh_.elements[e];
        for (int i = 0; i < 3; ++i) {
            Vector3 p{};
            for (int k = 0; k < 3; ++k) {
                p[k] = rest.volume * (isochoric * f[i][k] + along * c[i][k]);
            }
            for (int a = 0; a < 3; ++a) {
                const Vector3& g = rest.gradient[a];
                const double force = p[0] * g[0] + p[1] * g[1] + p[2] * g[2];
                forces[corner[a + 1]][i] -= force;
                forces[corner[0]][i] += force;
            }
        }
    }
    return inverted;
}

SolidState TetraSolid::state(const std::vector<Vector3>& positions) const {
    SolidState state{};
    Moments moments;
    double rest = 0.0;
    state.smallest_j = state.worst_quality = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Matrix3 f = deformation(e, positions);
        const double j = determinant(f);
        const double v0 = elements_[e].volume;
        state.smallest_j = std::min(state.smallest_j, j);
        state.largest_j = std::max(state.largest_j, j);
        state.worst_quality =
            std::min(state.worst_quality, quality(edges(positions, mesh_.elements[e]), j * v0));
        moments.add(positions, mesh_.elements[e], j * v0);
        if (j <= 0.0) {
            continue;
        }
        const Matrix3 s = cauchy_stress(f, j, elasticity_);
        const double von = von_mises(s);
        rest += v0;
        state.von_mises += v0 * von;
        state.von_mises_max = std::max(state.von_mises_max, von);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                const bool odd = half_ && (i == 2) != (k == 2);
                state.stress[i][k] += odd ? 0.0 : v0 * s[i][k];
            }
        }
    }
    const double scale = rest > 0.0 ? 1.0 / rest : 0.0;
    state.von_mises *= scale;
    for (auto& row : state.stress) {
        for (double& value : row) {
            value *= scale;
        }
    }
    if (half_) {
        moments.complete();
    }
    state.volume = moments.volume;
    state.ellipsoid = equivalent_ellipsoid(moments);
    return state;
}

std::vector<ElementState> TetraSolid::elements(const std::vector<Vector3>& positions) const {
    std::vector<ElementState> states;
    states.reserve(elements_.size());
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Matrix3 f = deformation(e, positions);
        const double j = determinant(f);
        states.push_back(
            {.von_mises = j > 0.0 ? von_mises(cauchy_stress(f, j, elasticity_)) : 0.0, .jacobian = j});
    }
    return states;
}

Matrix3 TetraSolid::mean_gradient(const std::vector<Vector3>& positions,
                                  const std::vector<Vector3>& velocities) const {
    Matrix3 sum{};
    double volume = 0.0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        const Matrix3 d = edges(positions, mesh_.elements[e]);
        const Matrix3 v = edges(velocities, mesh_.elements[e]);
        const Matrix3 c = cofactor(d);
        volume += determinant(d);
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                // v d⁻¹ weighted by det d
                sum[i][k] += v[i][0] * c[k][0] + v[i][1] * c[k][1] + v[i][2] * c[k][2];
            }
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const bool odd = half_ && (i == 2) != (k == 2);
            sum[i][k] = odd ? 0.0 : sum[i][k] / volume;
        }
    }
    return sum;
}

}  // namespace bioprint
