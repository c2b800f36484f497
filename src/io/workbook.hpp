#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

/// Answers as an Excel workbook: rows of a CSV with numbers as numbers, units in the header, and a chart.
///
/// Needs libxlsxwriter, whose header at build time and library at run time are both optional; it is loaded
/// when a workbook is asked for, because loading it takes as long as a prediction.
namespace bioprint {

/// The name ends in .xlsx.
bool names_workbook(const std::string& file);

class Workbook {
  public:
    /// @throws UsageError  this build has no workbooks, or the library is not installed; names the package
    Workbook();
    /// Adds bytes of a CSV as CsvWriter writes it, in any pieces; kept on disk.
    /// @throws DataError
    void add(std::string_view csv);
    /// The workbook's bytes; call it once.
    /// @throws UsageError  more rows or columns than a sheet holds
    /// @throws DataError
    std::string bytes();

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> spool_;
};

}  // namespace bioprint
