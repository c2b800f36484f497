#include "io/extras.hpp"

#include <algorithm>

namespace bioprint {

ExtraResults no_extras(const Extras& extras) {
    return {.checks = unanswered(extras.checks)};
}

std::vector<std::string> extra_paths(const Extras& extras) {
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < extras.checks.size(); ++i) {
        paths.push_back("checks." + std::to_string(i) + ".holds");
        paths.push_back("checks." + std::to_string(i) + ".relative_margin");
    }
    return paths;
}

bool is_extra_header(std::string_view header) {
    if (!header.starts_with("checks.")) return false;
    header.remove_prefix(7);
    const std::size_t dot = std::min(header.find('.'), header.size());
    const bool index =
        dot > 0 && std::all_of(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(dot),
                               [](char c) { return c >= '0' && c <= '9'; });
    const std::string_view name = header.substr(dot);
    return index && (name == ".holds" || name == ".relative_margin");
}

std::string extras_sections(const Extras& extras, const ExtraResults& results, TableStyle style) {
    return extras.checks.empty() ? std::string{} : checks_section(extras.checks, results.checks, style);
}

}  // namespace bioprint
