#include "io/ink_text.hpp"

#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

std::string infinite_shear(double eta_inf) {
    return eta_inf > 0.0 ? ", η∞ " + lab_text(eta_inf, Dimension::viscosity) : std::string{};
}

std::string text_of(const CrossInk& law) {
    return "η0 " + lab_text(law.eta0, Dimension::viscosity) + ", K " +
           lab_text(law.time_constant, Dimension::time) + ", α " + bare_text(law.alpha) +
           infinite_shear(law.eta_inf);
}

std::string text_of(const PowerLawInk& law) {
    return "power law, k " + lab_text(law.consistency, Dimension::consistency) + ", n " +
           bare_text(law.flow_index);
}

std::string text_of(const CarreauYasudaInk& law) {
    return "Carreau-Yasuda, η0 " + lab_text(law.eta0, Dimension::viscosity) + ", K " +
           lab_text(law.time_constant, Dimension::time) + ", a " + bare_text(law.transition) + ", n " +
           bare_text(law.flow_index) + infinite_shear(law.eta_inf);
}

std::string text_of(const HerschelBulkleyInk& law) {
    return "Herschel-Bulkley, τy " + lab_text(law.yield_stress, Dimension::pressure) + ", k " +
           lab_text(law.consistency, Dimension::consistency) + ", n " + bare_text(law.flow_index);
}

}  // namespace

std::string ink_text(const Ink& ink) {
    return std::visit([](const auto& law) { return text_of(law); }, ink);
}

}  // namespace bioprint
