#pragma once

#include <string_view>
#include <variant>

#include "bioprint/rheology/carreau_yasuda.hpp"
#include "bioprint/rheology/cross.hpp"
#include "bioprint/rheology/herschel_bulkley.hpp"
#include "bioprint/rheology/power_law.hpp"

/// A bioink by any of the laws. Every function of a law exists for all of them; what a law leaves open (the viscosity
/// of a power-law ink at rest) is +infinity, never NaN.
namespace bioprint {

using Ink = std::variant<CrossInk, PowerLawInk, CarreauYasudaInk, HerschelBulkleyInk>;

/// As the functions of the single laws.
double viscosity(const Ink& ink, double rate);
double stress(const Ink& ink, double rate);
double largest_stable_rate(const Ink& ink);
double flow_index(const Ink& ink, double rate);
double rate_at_stress(const Ink& ink, double stress);

/// The stress below which the ink does not flow [Pa]; 0 for laws without one.
double yield_stress(const Ink& ink);

/// "cross", "power-law", "carreau-yasuda" or "herschel-bulkley".
std::string_view law_name(const Ink& ink);

/// The Cross law, for what knows no other.
/// @throws UsageError  the ink follows another law; `who` names what asked
const CrossInk& cross_law(const Ink& ink, std::string_view who);

}  // namespace bioprint
