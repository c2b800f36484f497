#include "io/text.hpp"
#include "io/workbook.hpp"

namespace bioprint {

bool names_workbook(const std::string& file) {
    return lower_case(file).ends_with(".xlsx");
}

}  // namespace bioprint
