#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/checks.hpp"

/// What a call asks of an answer beyond the prediction itself.
namespace bioprint {

struct Extras {
    std::vector<Check> checks;
    [[nodiscard]] bool empty() const { return checks.empty(); }
};

/// What came of them, for who writes no JSON.
struct ExtraResults {
    std::vector<CheckResult> checks;
};

/// What a row without an answer has of them.
ExtraResults no_extras(const Extras& extras);

/// Paths of the CSV columns that belong to them.
std::vector<std::string> extra_paths(const Extras& extras);
/// True for a header such a column can have.
bool is_extra_header(std::string_view header);

/// Sections of a table.
std::string extras_sections(const Extras& extras, const ExtraResults& results, TableStyle style);

}  // namespace bioprint
