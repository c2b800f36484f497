#include "bioprint/rheology/ink.hpp"

#include <array>
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

std::string_view law_name(const Ink& ink) {
    constexpr std::array<std::string_view, std::variant_size_v<Ink>> names = {
        "cross", "power-law", "carreau-yasuda", "herschel-bulkley"};
    return names[ink.index()];
}

const CrossInk& cross_law(const Ink& ink, std::string_view who) {
    if (const auto* law = std::get_if<CrossInk>(&ink)) return *law;
    throw UsageError(std::string(who) + ": knows inks by the Cross law only, and this one follows the " +
                     std::string(law_name(ink)) + " law");
}

}  // namespace bioprint
