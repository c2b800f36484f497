#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/rheology/ink.hpp"

/// Inks, cells and nozzles from the literature and from catalogues: the files in data/, built into the
/// library.
///
/// Every value keeps its source, and a grade: A, read in the publication or in data its authors published; B,
/// second hand, smoothed or nominal. The files are parsed on first use. Names and aliases are found in any
/// case of letters.
namespace bioprint {

struct RateRange {
    double min;  ///< [1/s]
    double max;  ///< [1/s]
};

/// How far a parameter of an ink may be off.
struct ParameterSpread {
    std::string name;  ///< "eta0", "flow_index", …
    double sd;         ///< standard deviation [SI]
};

/// How the errors of parameters that were fitted together hang together: of their logarithms, of Carreau-Yasuda's flow
/// index of itself. A standard deviation over its value is then that of the logarithm, and the value is the median.
struct ParameterCorrelation {
    std::vector<std::string> parameters;
    std::vector<double> matrix;  ///< by rows
};

struct InkPreset {
    std::string name;
    std::vector<std::string> aliases;
    std::string material;
    std::string composition;
    std::optional<double> temperature;     ///< [°C]
    Ink ink;                               ///< SI
    std::vector<ParameterSpread> spreads;  ///< of the parameters whose spread is stated
    std::vector<std::string>
        undetermined;  ///< parameters that the data behind it leave open, whatever their sd
    std::optional<ParameterCorrelation> correlation;
    std::optional<RateRange> shear_rate_range;  ///< the rates it was fitted to
    std::string grade;
    std::string source;
    std::string note;

    /// The standard deviation stated for a parameter of its law, by the name that the file has for it [SI].
    [[nodiscard]] std::optional<double> sd(std::string_view parameter) const;
};

/// The wall stress in the nozzle at which a share of the cells survives an exposure.
struct ViabilityThreshold {
    double exposure;     ///< [s]
    double wall_stress;  ///< [Pa]
    double viability;    ///< 0 to 1
};

struct CellPreset {
    std::string name;
    std::vector<std::string> aliases;
    std::string cell;                        ///< what it is
    std::optional<double> temperature;       ///< [°C]
    std::optional<double> radius;            ///< [m]
    std::optional<double> shear_modulus;     ///< [Pa]
    std::optional<double> shear_modulus_sd;  ///< [Pa]
    std::optional<double> poisson_ratio;
    std::optional<double> viscosity_ratio;
    std::vector<ViabilityThreshold> viability_thresholds;
    std::string grade;
    std::string source;
    std::string note;
};

enum class Tip { steel, tapered, hypodermic };

struct NozzlePreset {
    std::string name;  ///< "25G steel"
    int gauge;
    Tip tip;
    double radius;                             ///< of the bore, at the orifice of a tapered tip [m]
    std::optional<double> diameter_tolerance;  ///< ± on the bore's diameter [m]
    bool tapered;                              ///< the bore narrows towards the orifice
    std::string part;                          ///< maker and number; may be empty
    std::string grade;
    std::string source;
};

std::span<const InkPreset> ink_presets();
std::span<const CellPreset> cell_presets();
std::span<const NozzlePreset> nozzle_presets();

/// @throws UsageError  the name is not known; the message suggests near ones
const InkPreset& find_ink(std::string_view name, std::string_view option = "--ink");
const CellPreset& find_cell(std::string_view name, std::string_view option = "--cell");

/// An ink from a preset file: one object of the shape used in data/inks.json, or an object whose `inks` holds
/// one. A parameter may also be a string such as "10 Pa.s". Without a `law` it is the Cross law, of which eta0,
/// time_constant and alpha are required.
/// @throws DataError   the file cannot be read
/// @throws UsageError  it is malformed; the message names the field
InkPreset load_ink_file(const std::string& path);

struct NozzleChoice {
    NozzlePreset nozzle;
    bool tip_assumed;                  ///< no tip was named
    std::vector<NozzlePreset> others;  ///< the tips of that gauge that were not chosen, when none was named
};

/// The nozzle of a gauge ("25G", "25", "25g"). Without a tip a gauge is ambiguous: the steel tip is taken, or
/// the tapered, or the hypodermic one, in that order, and the others are told.
/// @throws UsageError  not a gauge, or no such nozzle; the message lists the gauges there are
NozzleChoice find_nozzle(std::string_view gauge, std::optional<Tip> tip,
                         std::string_view option = "--needle");

/// @throws UsageError  not one of steel, tapered, hypodermic
Tip parse_tip(std::string_view text, std::string_view option = "--tip");
std::string_view tip_name(Tip tip);

/// What was chosen and what the other bores would have been, in one line; for the answer's warning.
std::string describe(const NozzleChoice& choice);

}  // namespace bioprint
