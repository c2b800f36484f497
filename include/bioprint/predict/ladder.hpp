#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The ladder of models, cheapest first, and what each rung's answers were worth where they were measured.
///
/// A rung was timed and held against the finest simulation there is on a fixed set of questions
/// (tests/bench/trade.cpp → data/trade.json). For a question like those, its error is taken as the largest of
/// its kind and softness. Softness is the load over the cell's shear modulus:
///   channel G R_c/μ;  exit σ_elong/μ;  off the axis σ_f/μ at the cell's centre
/// Where a rung had no answer to some of those questions, it is not trusted with any.
namespace bioprint {

enum class QuestionKind { exit_flow, channel, exit, channel_off_axis, exit_off_axis, shear };
enum class Rung { steady, ellipsoid, draft, standard, fine };

std::string_view name_of(QuestionKind kind);
std::string_view name_of(Rung rung);
/// Lattice nodes a cell radius of a simulation; 0 for a prediction.
double resolution_of(Rung rung);

/// One rung on the measured questions of one kind and softness.
struct RungRecord {
    QuestionKind kind;
    Rung rung;
    double load_from;  ///< softness, from (inclusive) …
    double load_to;    ///< … to (exclusive)
    double error;      ///< relative, of the judged stress: the largest
    double time;       ///< processor time [s]: the median
    double longest;    ///< processor time [s]: the longest
    int questions;     ///< measured
    int unjudged;      ///< of them: no value, or none to hold it against
    int unanswered;    ///< of them: no value
};
std::span<const RungRecord> measured_ladder();

/// What is known of a rung on such a question; null when nothing like it was measured.
const RungRecord* measured(QuestionKind kind, Rung rung, double load);
/// Where the load is taken that tells how soft a cell at the exit is: where they were measured, 3 cell radii off the
/// axis, for a cell nearer to it is stretched as much by the exit and sheared less.
double softness_offset(double offset, double cell_radius);
/// The relative error to be expected; none when nothing like it was measured or some of it has no answer.
std::optional<double> expected_error(QuestionKind kind, Rung rung, double load);

/// What is known of a rung for the very question, beyond what was measured of its kind.
struct RungOutlook {
    std::string refused = {};         ///< why it cannot follow this question; empty: it can
    std::optional<double> time = {};  ///< processor time expected [s]; none: the longest measured
    double least_error = 0.0;         ///< relative, by other measurements
    bool unknown = false;             ///< its error on this question is not known
};
constexpr std::size_t rung_count = 5;

struct RungRequest {
    QuestionKind kind;
    double load;
    std::optional<double> tolerance;  ///< largest relative error wanted
    std::optional<double> budget;     ///< longest time wanted [s]
    bool simulated = false;           ///< a simulation was asked for: no rung below the drafts
    bool measured = true;  ///< the question lies where the rungs were measured; else no error is known
    std::array<RungOutlook, rung_count> outlook = {};  ///< in the order of Rung
};

struct RungVerdict {
    Rung rung;
    std::optional<double> error;
    std::optional<double> time;     ///< [s]
    bool accurate;                  ///< within the tolerance; true when none was asked for
    bool affordable;                ///< within the budget; true when none was asked for
    std::string refused = {};       ///< why it cannot follow this question; empty: it can
    const RungRecord* record = {};  ///< null: nothing like it was measured
};

struct RungChoice {
    Rung rung;
    bool met;  ///< all that was asked for; else the most accurate rung within the budget, or the cheapest
    std::vector<RungVerdict> ladder;  ///< every rung, cheapest first
};

/// The cheapest rung that can follow the question within the tolerance; with a budget alone, the most accurate one within
/// it. Where no simulation can follow the question and one was asked for, it is the standard one, whose run says why.
RungChoice choose_rung(const RungRequest& request);

}  // namespace bioprint
