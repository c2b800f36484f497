#include "io/xlsx_library.hpp"

#include <dlfcn.h>

#include <string>

#include "bioprint/errors.hpp"

namespace bioprint {
namespace {

template <class Function>
void load(void* library, const char* name, Function& function) {
    void* const found = ::dlsym(library, name);
    if (found == nullptr) {
        throw UsageError("--output: " BIOPRINT_XLSXWRITER " has no " + std::string(name) +
                         "; install the libxlsxwriter this program was built with");
    }
    function = reinterpret_cast<Function>(found);
}

XlsxLibrary loaded() {
    void* const library = ::dlopen(BIOPRINT_XLSXWRITER, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw UsageError("--output: a workbook needs " BIOPRINT_XLSXWRITER
                         ", which is not installed; apt-get install libxlsxwriter-dev, or write a .csv",
                         "--output");
    }
    XlsxLibrary functions{};
    load(library, "workbook_new_opt", functions.new_workbook);
    load(library, "workbook_add_worksheet", functions.add_worksheet);
    load(library, "workbook_add_chartsheet", functions.add_chartsheet);
    load(library, "workbook_add_chart", functions.add_chart);
    load(library, "workbook_add_format", functions.add_format);
    load(library, "workbook_close", functions.close);
    load(library, "format_set_bold", functions.set_bold);
    load(library, "format_set_text_wrap", functions.set_text_wrap);
    load(library, "format_set_align", functions.set_align);
    load(library, "worksheet_write_number", functions.write_number);
    load(library, "worksheet_write_string", functions.write_string);
    load(library, "worksheet_set_column", functions.set_column);
    load(library, "worksheet_set_row", functions.set_row);
    load(library, "worksheet_freeze_panes", functions.freeze_panes);
    load(library, "chart_add_series", functions.add_series);
    load(library, "chart_series_set_name", functions.set_series_name);
    load(library, "chart_axis_set_name", functions.set_axis_name);
    load(library, "chart_title_set_name", functions.set_title);
    load(library, "chartsheet_set_chart", functions.set_chart);
    load(library, "lxw_strerror", functions.error_text);
    return functions;
}

}  // namespace

const XlsxLibrary& xlsx_library() {
    static const XlsxLibrary functions = loaded();
    return functions;
}

}  // namespace bioprint
