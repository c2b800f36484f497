#include "bioprint/errors.hpp"
#include "io/workbook.hpp"

// Built where libxlsxwriter's header was not found.

namespace bioprint {

Workbook::Workbook() : spool_(nullptr, &std::fclose) {
    throw UsageError(
        "--output: this program was built without Excel workbooks; install libxlsxwriter-dev and build it "
        "again, or write a .csv",
        "--output");
}

void Workbook::add(std::string_view) {}

std::string Workbook::bytes() {
    return {};
}

}  // namespace bioprint
