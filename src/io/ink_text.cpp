#include "io/ink_text.hpp"

#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

std::string lab(double value, Dimension dimension) {
    const LabNumber n = format_lab(value, dimension);
    return n.unit.empty() ? n.number : n.number + " " + n.unit;
}

std::string plain(double value) {
    return lab(value, Dimension::dimensionless);
}

std::string infinite_shear(double eta_inf) {
    return eta_inf > 0.0 ? ", η∞ " + lab(eta_inf, Dimension::viscosity) : std::string{};
}

std::string text_of(const CrossInk& law) {
    return "η0 " + lab(law.eta0, Dimension::viscosity) + ", K " + lab(law.time_constant, Dimension::time) +
           ", α " + plain(law.alpha) + infinite_shear(law.eta_inf);
}

std::string text_of(const PowerLawInk& law) {
    return "power law, k " + lab(law.consistency, Dimension::consistency) + ", n " + plain(law.flow_index);
}

std::string text_of(const CarreauYasudaInk& law) {
    return "Carreau-Yasuda, η0 " + lab(law.eta0, Dimension::viscosity) + ", K " +
           lab(law.time_constant, Dimension::time) + ", a " + plain(law.transition) + ", n " +
           plain(law.flow_index) + infinite_shear(law.eta_inf);
}

std::string text_of(const HerschelBulkleyInk& law) {
    return "Herschel-Bulkley, τy " + lab(law.yield_stress, Dimension::pressure) + ", k " +
           lab(law.consistency, Dimension::consistency) + ", n " + plain(law.flow_index);
}

}  // namespace

std::string ink_text(const Ink& ink) {
    return std::visit([](const auto& law) { return text_of(law); }, ink);
}

}  // namespace bioprint
