#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// Flow curves written as rheometers' programs and spreadsheets write them: the shapes of the files, from their
/// descriptions and from use, with our own contents.
namespace bioprint::test {

enum class ExportKind {
    rheocompass_german,  ///< UTF-16LE with a mark, tabs, decimal commas, German names, a rest before the curve
    rheocompass_english,  ///< the same as CSV in UTF-8, viscosity in mPa·s
    trios,                ///< [step] blocks, tabs, a row of units
    malvern,              ///< commas, units in the names
    german_excel,         ///< semicolons, decimal commas, Windows-1252, Pas
    plain,                ///< two columns, nothing else
    plain_named,          ///< two columns under their names, blanks between
};
inline constexpr std::array<ExportKind, 7> export_kinds = {ExportKind::rheocompass_german,
                                                           ExportKind::rheocompass_english,
                                                           ExportKind::trios,
                                                           ExportKind::malvern,
                                                           ExportKind::german_excel,
                                                           ExportKind::plain,
                                                           ExportKind::plain_named};
std::string_view kind_name(ExportKind kind);

struct ExportPoint {
    double rate;       ///< [1/s]
    double viscosity;  ///< [Pa s]
};

/// The file's bytes.
std::string rheometer_export(ExportKind kind, const std::vector<ExportPoint>& points);

/// UTF-8 as UTF-16LE with a byte order mark.
std::string as_utf16(std::string_view utf8);

}  // namespace bioprint::test
