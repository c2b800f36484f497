#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/rheology/flow_curve_fit.hpp"

/// Flow curves from what rheometers export.
///
/// Read are Anton Paar RheoCompass (UTF-16, tabs or CSV, a unit row below the names, intervals), TA TRIOS (`[step]`
/// blocks), Malvern rSpace (units in the names), what a spreadsheet makes of them (semicolons, decimal commas,
/// Windows-1252) and two plain columns. Nothing is taken from a brand: a table is rows of numbers, the names are the
/// last words above them, units stand in a row of their own or behind the names. Whatever was understood is said.
namespace bioprint {

struct RheometerInterval {
    std::string name;        ///< as the file calls it; may be empty
    std::size_t line = 0;    ///< of its first row
    std::size_t rows = 0;    ///< rows of numbers
    std::size_t points = 0;  ///< of these, usable ones
    std::string rate;        ///< the columns meant: "Shear Rate [1/s]"
    std::string viscosity;   ///< "Viscosity [mPa·s]", or how it follows from others
    std::string skipped;     ///< why it is not used; empty when it is
};

struct MeasuredPoint {
    double rate;       ///< [1/s]
    double viscosity;  ///< [Pa s]
    std::size_t line;
    std::size_t interval;               ///< from 1
    std::optional<double> temperature;  ///< [°C]
};

/// Rows that are no points, and the first of them.
struct DroppedRows {
    std::string reason;  ///< "no number for the viscosity"
    std::size_t count = 0;
    std::size_t first_line = 0;
};

struct RheometerData {
    std::string file;
    std::string_view encoding;
    char separator = '\t';
    bool decimal_comma = false;
    std::vector<RheometerInterval> intervals;
    std::vector<MeasuredPoint> points;  ///< of the intervals in use, in the file's order
    std::vector<DroppedRows> dropped;
    std::vector<std::string> remarks;
};

struct RheometerReadOptions {
    std::vector<std::size_t> intervals;  ///< from 1; empty: every one that is a flow curve
};

/// @param text  UTF-8
/// @throws UsageError  no flow curve in it; the message names the line or columns and what to do
RheometerData read_rheometer_text(std::string_view text, const std::string& name,
                                  const RheometerReadOptions& options = {});

/// @throws DataError   the file cannot be read
/// @throws UsageError  as above, or it is no text
RheometerData read_rheometer_file(const std::string& path, const RheometerReadOptions& options = {});

}  // namespace bioprint
