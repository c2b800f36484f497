#include "io/extras.hpp"

#include <algorithm>

namespace bioprint {

ExtraResults no_extras(const Extras& extras) {
    return {.checks = unanswered(extras.checks)};
}

std::vector<std::string> spread_paths(const std::string& path) {
    std::vector<std::string> paths;
    for (const char* const name :
         {"mean", "standard_deviation", "percentile_5", "percentile_50", "percentile_95"}) {
        paths.push_back("uncertainty." + path + "." + name);
    }
    return paths;
}

std::vector<std::string> extra_paths(const Extras& extras, const std::vector<std::string>& answer_paths) {
    std::vector<std::string> paths;
    if (extras.uncertainty.wanted) {
        for (const std::string& path : answer_paths) {
            for (std::string& spread : spread_paths(path)) paths.push_back(std::move(spread));
        }
    }
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

}  // namespace bioprint
