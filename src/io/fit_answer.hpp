#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bioprint/predict/prediction.hpp"
#include "bioprint/rheology/flow_curve_fit.hpp"
#include "io/rheometer_reader.hpp"

/// From a rheometer's file to an ink: what `bioprint-predict fit` answers.
namespace bioprint {

inline constexpr std::string_view fit_schema_name = "bioprint-fit/1";

struct FitQuestion {
    std::string file;
    std::optional<FittedLaw> law = FittedLaw::cross;  ///< none: the best by AICc
    bool fit_eta_inf = false;
    double eta_inf = 0.0;  ///< held, where it is not fitted [Pa s]
    std::vector<std::size_t> intervals;
    std::string name;  ///< of the ink; empty: after the file
};

/// One point as it went into the fit, or stayed out.
struct FitPoint {
    double rate;       ///< [1/s]
    double measured;   ///< η [Pa s]
    double fitted;     ///< η of the law chosen [Pa s]
    bool used;         ///< false: an outlier
    std::size_t line;  ///< of the file
    std::size_t interval;
    [[nodiscard]] double residual() const;  ///< ln(measured/fitted)
};

struct FitAnswer {
    FitQuestion question;
    RheometerData data;
    FlowCurveFit fit;
    LawFit chosen;
    std::vector<FitPoint> points;
    double rate_low;                    ///< of the points in use [1/s]
    double rate_high;                   ///< [1/s]
    std::optional<double> temperature;  ///< mean of the rows in use [°C]
    std::string name;
    std::string source;
    std::vector<Warning> warnings;
};

/// @throws DataError   the file cannot be read
/// @throws UsageError  it holds no flow curve, or too few points for the law
FitAnswer answer_fit(const FitQuestion& question);
/// The same of a file that has been read.
FitAnswer answer_fit(const FitQuestion& question, RheometerData data);

/// What the data leave open, and where the law ends: for `warnings`.
std::vector<Warning> fit_warnings(const FitAnswer& answer);

/// The answer as JSON, schema bioprint-fit/1 (data/schema/fit.schema.json).
std::string fit_json_text(const FitAnswer& answer);

/// The ink in the form of data/inks.json, for `--ink FILE`.
std::string fit_preset_text(const FitAnswer& answer);

/// The values at dotted paths of the JSON, a line each.
/// @throws UsageError  there is none
std::string fit_values_text(const FitAnswer& answer, const std::vector<std::string>& paths);

/// The ink with the parameters as they are printed; whether a prediction takes it is another matter.
Ink fitted_ink(const LawFit& fit);

/// Why no prediction takes the ink fitted; empty where one does.
std::string not_predicted(const LawFit& fit);

/// The ink as options of a prediction, whatever its law: "--eta0 10Pa.s -K 0.05s --alpha 0.75".
std::string fit_options_line(const FitAnswer& answer);

/// The points, used and not, with fit and residual: RFC 4180.
std::string fit_csv(const FitAnswer& answer);

/// `value` to so many significant digits; six are beyond what any rheometer tells, and short enough to read.
double fit_rounded(double value, int digits = 6);

/// The unit of a parameter as a preset writes it: "Pa.s", "s", "Pa.s^n", "1", …
std::string_view fit_unit(std::string_view parameter);

}  // namespace bioprint
