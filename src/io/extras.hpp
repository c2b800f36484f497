#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/checks.hpp"

/// What a call asks of an answer beyond the prediction itself.
namespace bioprint {

struct UncertaintyRequest {
    bool presets = false;                     ///< also by the scatter of presets
    bool wanted = false;                      ///< where inputs have one, or always with `presets`
    std::optional<std::size_t> samples = {};  ///< none: 1024, with the population 256
};

struct Extras {
    std::vector<Check> checks;
    UncertaintyRequest uncertainty;
    [[nodiscard]] bool empty() const { return checks.empty() && !uncertainty.wanted; }
};

/// What came of them, for who writes no JSON.
struct ExtraResults {
    std::vector<CheckResult> checks;
};

/// What a row without an answer has of them.
ExtraResults no_extras(const Extras& extras);

/// Paths of the CSV columns that belong to them.
/// @param answer_paths  of the numbers that have a spread
std::vector<std::string> extra_paths(const Extras& extras, const std::vector<std::string>& answer_paths);
/// True for a header such a column can have.
bool is_extra_header(std::string_view header);

/// The paths of one number's spread.
std::vector<std::string> spread_paths(const std::string& path);

}  // namespace bioprint
