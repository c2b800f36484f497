#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "bioprint/cell/transient.hpp"

/// The little of 3×3 algebra the transient cell needs.
namespace bioprint {

inline constexpr Tensor unit_tensor{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};

inline Tensor product(const Tensor& a, const Tensor& b) {
    Tensor c{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j)
            c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    }
    return c;
}

inline Tensor transposed(const Tensor& a) {
    return {{{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}}};
}

/// Rᵀ A R: the components of A along the columns of R.
inline Tensor along(const Tensor& r, const Tensor& a) {
    return product(transposed(r), product(a, r));
}

/// R A Rᵀ: back again.
inline Tensor back(const Tensor& r, const Tensor& a) {
    return product(r, product(a, transposed(r)));
}

inline Tensor symmetric_part(const Tensor& a) {
    Tensor s{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) s[i][j] = 0.5 * (a[i][j] + a[j][i]);
    }
    return s;
}

struct Eigen3 {
    std::array<double, 3> value;
    Tensor axes;  ///< columns
};

/// Eigenvalues and axes of a symmetric tensor by Jacobi's rotations: each to its own relative accuracy where
/// the tensor is nearly diagonal, and nothing to do where it is.
inline Eigen3 eigen_of(Tensor a) {
    Tensor r = unit_tensor;
    for (int sweep = 0; sweep < 30; ++sweep) {
        bool rotated = false;
        for (std::size_t p = 0; p < 2; ++p) {
            for (std::size_t q = p + 1; q < 3; ++q) {
                const double off = a[p][q];
                if (std::abs(off) <= 1e-17 * (std::abs(a[p][p]) + std::abs(a[q][q]))) continue;
                rotated = true;
                const double theta = 0.5 * (a[q][q] - a[p][p]) / off;
                const double t =
                    (theta < 0.0 ? -1.0 : 1.0) / (std::abs(theta) + std::sqrt(1.0 + theta * theta));
                const double c = 1.0 / std::sqrt(1.0 + t * t);
                const double s = t * c;
                a[p][p] -= t * off;
                a[q][q] += t * off;
                a[p][q] = a[q][p] = 0.0;
                const std::size_t k = 3 - p - q;
                const double kp = a[k][p];
                const double kq = a[k][q];
                a[k][p] = a[p][k] = c * kp - s * kq;
                a[k][q] = a[q][k] = s * kp + c * kq;
                for (auto& row : r) {
                    const double x = row[p];
                    const double y = row[q];
                    row[p] = c * x - s * y;
                    row[q] = s * x + c * y;
                }
            }
        }
        if (!rotated) break;
    }
    return {.value = {a[0][0], a[1][1], a[2][2]}, .axes = r};
}

}  // namespace bioprint
