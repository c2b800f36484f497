#pragma once

#include <optional>

#include "bioprint/rheology/ink.hpp"
#include "flow/deficit_integrals.hpp"

/// What the pipe flow asks of each law: the integrals over the rate of strain, x = Kγ̇ from 0 to x_w, with K the law's
/// time scale. v = ln(x_w/x), q = τ/τ_w.
///
/// Cross: fixed Gauss panels over precomputed nodes (deficit_integrals.hpp). Carreau-Yasuda: the same panels; with
/// y = x_w^a the logarithm of q is a sum of terms of one sign,
///
///   −ln q = n v + ((1−n)/a) ln[1 + (e^{av} − 1)/(1+y)]    and    1 − q = −expm1(ln q)
///
/// for the thinning part (for n > 1: v + ((n−1)/a) |ln[1 − (1 − e^{−av}) y/(1+y)]|), and of the whole law a mean of it
/// and the Newtonian 1 − e^{−v}. Herschel-Bulkley and the power law in closed form: with φ = τ_y/τ_w and
/// ψ = 1 − φ = k γ̇_w^n/τ_w the deficit is 1 − q = ψ(1 − e^{−nv}), and every integral a sum of positive terms.
namespace bioprint {

/// K; 1 s where the law has no time of its own.
double time_scale(const CrossInk& ink);
double time_scale(const PowerLawInk& ink);
double time_scale(const CarreauYasudaInk& ink);
double time_scale(const HerschelBulkleyInk& ink);

/// The integrals at a wall rate, ln(K γ̇_w).
DeficitIntegrals deficit_integrals(const CrossInk& ink, double log_wall);
DeficitIntegrals deficit_integrals(const PowerLawInk& ink, double log_wall);
DeficitIntegrals deficit_integrals(const CarreauYasudaInk& ink, double log_wall);
DeficitIntegrals deficit_integrals(const HerschelBulkleyInk& ink, double log_wall);

/// The third alone, for the root search.
double third_deficit(const CrossInk& ink, double log_wall);
double third_deficit(const PowerLawInk& ink, double log_wall);
double third_deficit(const CarreauYasudaInk& ink, double log_wall);
double third_deficit(const HerschelBulkleyInk& ink, double log_wall);

/// γ̇_w R/u_avg where it is a number known beforehand.
std::optional<double> fixed_wall_rate(const CrossInk& ink);
std::optional<double> fixed_wall_rate(const PowerLawInk& ink);
std::optional<double> fixed_wall_rate(const CarreauYasudaInk& ink);
std::optional<double> fixed_wall_rate(const HerschelBulkleyInk& ink);

/// A place in the profile. Both distances are given, so that neither is a difference of rounded numbers.
struct ProfilePlace {
    double wall_rate;  ///< γ̇_w [1/s]
    double rate;       ///< γ̇ there [1/s], > 0
    double from_wall;  ///< 1 − r/R
};

/// u(r)/R [1/s].
double velocity_at(const CrossInk& ink, const ProfilePlace& place);
double velocity_at(const PowerLawInk& ink, const ProfilePlace& place);
double velocity_at(const CarreauYasudaInk& ink, const ProfilePlace& place);
double velocity_at(const HerschelBulkleyInk& ink, const ProfilePlace& place);

}  // namespace bioprint
