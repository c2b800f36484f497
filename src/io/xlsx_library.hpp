#pragma once

#include <xlsxwriter.h>

/// The functions of libxlsxwriter that are used, loaded on first use.
namespace bioprint {

struct XlsxLibrary {
    decltype(&::workbook_new_opt) new_workbook;
    decltype(&::workbook_add_worksheet) add_worksheet;
    decltype(&::workbook_add_chartsheet) add_chartsheet;
    decltype(&::workbook_add_chart) add_chart;
    decltype(&::workbook_add_format) add_format;
    decltype(&::workbook_close) close;
    decltype(&::format_set_bold) set_bold;
    decltype(&::format_set_text_wrap) set_text_wrap;
    decltype(&::format_set_align) set_align;
    decltype(&::worksheet_write_number) write_number;
    decltype(&::worksheet_write_string) write_string;
    decltype(&::worksheet_set_column) set_column;
    decltype(&::worksheet_set_row) set_row;
    decltype(&::worksheet_freeze_panes) freeze_panes;
    decltype(&::chart_add_series) add_series;
    decltype(&::chart_series_set_name) set_series_name;
    decltype(&::chart_axis_set_name) set_axis_name;
    decltype(&::chart_title_set_name) set_title;
    decltype(&::chartsheet_set_chart) set_chart;
    decltype(&::lxw_strerror) error_text;
};

/// @throws UsageError  the library is not installed
const XlsxLibrary& xlsx_library();

}  // namespace bioprint
