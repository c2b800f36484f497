#include "bioprint/rheology/ink.hpp"

#include <array>
#include <cmath>
#include <string>

#include "bioprint/errors.hpp"

namespace bioprint {

double viscosity(const Ink& ink, double rate) {
    return std::visit([&](const auto& law) { return viscosity(law, rate); }, ink);
}

double stress(const Ink& ink, double rate) {
    return std::visit([&](const auto& law) { return stress(law, rate); }, ink);
}

double largest_stable_rate(const Ink& ink) {
    return std::visit([](const auto& law) { return largest_stable_rate(law); }, ink);
}

double flow_index(const Ink& ink, double rate) {
    return std::visit([&](const auto& law) { return flow_index(law, rate); }, ink);
}

double rate_at_stress(const Ink& ink, double stress) {
    return std::visit([&](const auto& law) { return rate_at_stress(law, stress); }, ink);
}

double yield_stress(const Ink& ink) {
    const auto* yielding = std::get_if<HerschelBulkleyInk>(&ink);
    return yielding == nullptr ? 0.0 : yielding->yield_stress;
}

bool has_rest_viscosity(const Ink& ink) {
    const double eta = viscosity(ink, 0.0);
    return eta > 0.0 && std::isfinite(eta);
}

std::string_view law_name(const Ink& ink) {
    constexpr std::array<std::string_view, std::variant_size_v<Ink>> names = {
        "cross", "power-law", "carreau-yasuda", "herschel-bulkley"};
    return names[ink.index()];
}

const CrossInk& cross_law(const Ink& ink) {
    if (const auto* law = std::get_if<CrossInk>(&ink)) return *law;
    throw UsageError("--simulate: knows inks by the Cross law only, and this one follows the " +
                         std::string(law_name(ink)) +
                         " law; predict it without --simulate, or fit a Cross law to it",
                     "--simulate");
}

}  // namespace bioprint
