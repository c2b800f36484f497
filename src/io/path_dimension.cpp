#include "io/path_dimension.hpp"

#include <algorithm>
#include <string>

#include "io/answer_object.hpp"

namespace bioprint {

Dimension dimension_of_path(std::string_view path) {
    const std::string_view unit = unit_of(path);
    if (unit.empty()) return Dimension::dimensionless;
    for (int d = 0; d <= static_cast<int>(Dimension::rate); ++d) {
        const auto dimension = static_cast<Dimension>(d);
        std::string name(si_unit(dimension));
        std::replace(name.begin(), name.end(), ' ', '.');  // "Pa s" is "Pa.s" in paths
        if (unit == name) return dimension;
    }
    return Dimension::dimensionless;
}

}  // namespace bioprint
