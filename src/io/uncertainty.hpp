#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/answer_object.hpp"
#include "io/extras.hpp"
#include "io/settings.hpp"

/// How far the inputs' spread is felt in the answer: the question is asked again for a sample of inputs.
///
/// An input is spread by what was given for it (`0.75±0.05`, `10Pa.s±15%`), or by its preset. It then has the mean
/// and the standard deviation stated, and is distributed
///
///   log-normally   where it can only be positive: sizes, flows, viscosities, moduli (it never becomes negative, a
///                  product of powers of such inputs is of the same kind, and for a spread of 10 % it is as good as
///                  normal)
///   normally       alpha and the flow index of Carreau-Yasuda (0 to 1), Poisson's ratio, and what is 0; cut at the
///                  bounds, which moves mean and spread where they are nearer than three standard deviations
///   evenly         a needle's bore within its maker's tolerance
///
/// Parameters of an ink that were fitted together vary together, by the correlation that the preset states: their
/// logarithms are normal about the values fitted, as the fit's own errors are. What the fit did not determine is held,
/// and the others vary by what it leaves open beside them.
///
/// The sample is Sobol's sequence (numerics/quasi_random.hpp): the same call has the same answer, for any number of
/// threads.
///
/// Accuracy of 1024 samples of up to six inputs against log-normal closed forms: mean 0.1 %, standard deviation 0.5 %,
/// quantiles 1.5 %, shares 0.003; of 256 samples 0.2 %, 3 %, 7 %, 0.01.       tests/unit/io/uncertainty.cpp
namespace bioprint {

enum class SpreadKind { log_normal, normal, uniform };

struct UncertainInput {
    Key key;
    double value;               ///< mean [SI]
    double standard_deviation;  ///< [SI]
    SpreadKind kind;
    double low;  ///< bounds
    double high;
    std::string source;  ///< "given", or where the spread is from
};

struct UncertainInputs {
    std::vector<UncertainInput> inputs;
    /// Rows of the lower triangle that makes the inputs' normals of independent ones; empty: they are independent.
    std::vector<double> mixing;
    std::vector<Key> held;  ///< parameters that the data behind the ink leave open
    std::string held_why;   ///< a sentence for the answer, where there are any

    [[nodiscard]] double correlation(std::size_t i, std::size_t j) const;
};

/// The inputs of a question that have a spread.
/// @param answer  to the question as it stands
UncertainInputs uncertain_inputs(const Settings& settings, const Json& answer, bool presets);

/// The input's value where a standard normal is z.
double spread_value(const UncertainInput& input, double z);

/// Adds `uncertainty` to an answer.
/// @throws UsageError  nothing is uncertain, or no sample has an answer
void add_uncertainty(Json& answer, const Settings& settings, const UncertaintyRequest& request,
                     unsigned jobs);

/// The statistics of the number at a path; none where it has no spread.
/// @param answer  with `uncertainty`
const Json* spread_of(const Json& answer, std::string_view path);

/// The numbers of most interest that have a spread.
struct NamedSpread {
    std::string_view label;
    std::string_view path;
    const Json* spread;
};
std::vector<NamedSpread> main_spreads(const Json& answer);

/// "Most of the spread of 'cell, at the exit' is that of alpha: 43 %"; empty with one input.
std::string measure_better(const Json& answer);

/// What is to be known beside the numbers: inputs that were held, inputs that vary together. A sentence each.
std::vector<std::string> uncertainty_remarks(const Json& answer);

/// The table's sections.
std::string uncertainty_section(const Json& answer, TableStyle style);

}  // namespace bioprint
