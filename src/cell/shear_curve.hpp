#pragma once

/// The universal curve of stationary ellipsoids in steady shear.
///
/// Roscoe's condition (α1²−α2²)/(α3²−α2²) = (g1''+g2'')/g2'' holds neither the load nor the viscosity ratio,
/// so with α1 α2 α3 = 1 one number s = α2/α1 fixes the shape. Three functions of it answer everything else:
///
///   ℓ = ln(α1/α3)/δ            h = ½(α1²+α2²) g3'            w = α1³
///   (g1''g2''+g2''g3''+g3''g1'')/(g1''+g2'')
///
/// Held as (ℓ−½)/δ, (1−h)/s and w, which are finite at both ends (sphere: 3/14, 3/5, 2/5; α2/α1 → 0:
/// 0.97467, 5.08418, 5.77201) and keep the digits of 1−h and of the deviation from the sphere. Chebyshev
/// series on [0, 1] in v = δ/(1 + 6s): the bend moves the curve's singularity near s = −0.05 away from the
/// interval. Accuracy: 1e-15 relative.                                       tests/verify/shear_curve.cpp
namespace bioprint {

struct AxisRatio {
    double s;      ///< α2/α1, 0 < s ≤ 1
    double delta;  ///< 1 − s, to full relative accuracy
};

struct ShearCurve {
    double lean;     ///< (ℓ − ½)/δ
    double slip;     ///< (1 − h)/s
    double bearing;  ///< w
};

ShearCurve shear_curve(const AxisRatio& ratio);

/// −ln s, and −ln s − δ without cancellation.
double log_ratio(const AxisRatio& ratio);
double log_ratio_excess(const AxisRatio& ratio);

}  // namespace bioprint
