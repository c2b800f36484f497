#include "predict/stated_errors.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "bioprint/predict/ladder.hpp"
#include "predict/print_errors.hpp"

namespace bioprint {
namespace {

constexpr double most_thinning = 0.75;
constexpr double fastest = 50.0;           // K u_avg/R
constexpr double largest_cell = 0.2;       // of the nozzle's radius
constexpr double softest_in_nozzle = 0.7;  // G R_c/μ of the softest centred cells that were simulated there
constexpr double slack = 1.0 + 1e-6;

/// Largest relative error of a number of the nozzle, K rate 1e-12 to 1e12. tests/verify/nozzle_flow.cpp and
/// nozzle_laws.cpp
double nozzle_error(const Ink& ink) {
    constexpr double cross = 3.2e-14;
    constexpr double other_laws = 1e-11;
    return std::holds_alternative<CrossInk>(ink) ? cross : other_laws;
}

bool flow_was_measured(const NozzleFlow& flow) {
    const auto* const cross = std::get_if<CrossInk>(&flow.ink());
    if (cross == nullptr || !(flow.velocity_average() > 0.0) || cross->alpha > most_thinning * slack)
        return false;
    return cross->alpha == 0.0 ||
           cross->time_constant * flow.velocity_average() <= fastest * slack * flow.radius();
}

using Error = std::optional<double>;

/// Nothing is known of the whole where nothing is of a part.
Error larger(const Error& a, const Error& b) {
    return a && b ? Error(std::max(*a, *b)) : std::nullopt;
}

class CellErrors {
  public:
    CellErrors(const NozzleFlow& flow, const CellChoice& cell, const ExitAnswer& exit)
        : flow_(flow),
          cell_(cell),
          pull_(flow.pressure_gradient() * cell.radius / cell.shear_modulus),
          strain_load_(exit.elongational_stress / cell.shear_modulus),
          measured_(flow_was_measured(flow) && cell.viscosity_ratio == 1.0 &&
                    cell.radius <= largest_cell * slack * flow.radius()) {}

    /// Of the stress of a cell at this offset.
    [[nodiscard]] Error in_nozzle(Rung rung, double offset) const {
        if (!measured_ || near_wall(offset)) return std::nullopt;
        // Nearer to the axis than its radius the change of the shear across the cell counts, which that leaves out.
        if (rung == Rung::steady && offset > 0.0 && offset < cell_.radius) return std::nullopt;
        if (offset > 0.0) return expected_error(QuestionKind::channel_off_axis, rung, load(offset));
        return pull_ > softest_in_nozzle ? std::nullopt : expected_error(QuestionKind::channel, rung, pull_);
    }
    [[nodiscard]] Error at_exit(Rung rung, double offset) const {
        if (!measured_ || near_wall(offset)) return std::nullopt;
        if (offset > 0.0)
            return expected_error(QuestionKind::exit_off_axis, rung,
                                  load(softness_offset(offset, cell_.radius)));
        const PrintErrors* const prints = print_errors(rung == Rung::ellipsoid, strain_load_, pull_);
        const Error ladder = expected_error(QuestionKind::exit, rung, strain_load_);
        return prints == nullptr ? std::nullopt : larger(ladder, prints->stress);
    }
    /// Of α − 1 at the exit.
    [[nodiscard]] Error strain_at_exit(Rung rung, double offset) const {
        if (!measured_ || offset > 0.0 || !at_exit(rung, offset)) return std::nullopt;
        const PrintErrors* const prints = print_errors(rung == Rung::ellipsoid, strain_load_, pull_);
        return prints == nullptr ? std::nullopt : Error(prints->strain);
    }

    /// Of a stress that may be that of any cell, those at the wall aside.
    [[nodiscard]] Error anywhere() const {
        constexpr int places = 8;
        const double outermost = flow_.radius() - 2.0 * cell_.radius;
        Error error = larger(in_nozzle(Rung::ellipsoid, 0.0), at_exit(Rung::ellipsoid, 0.0));
        for (int i = 1; i <= places; ++i) {
            const double offset = outermost * i / places;
            error =
                larger(error, larger(in_nozzle(Rung::ellipsoid, offset), at_exit(Rung::ellipsoid, offset)));
        }
        return error;
    }

  private:
    [[nodiscard]] double load(double offset) const { return flow_.stress(offset) / cell_.shear_modulus; }
    [[nodiscard]] bool near_wall(double offset) const {
        return offset + 2.0 * cell_.radius > flow_.radius() * slack;
    }

    const NozzleFlow& flow_;
    const CellChoice& cell_;
    double pull_;         ///< G R_c/μ
    double strain_load_;  ///< σ_elong/μ
    bool measured_;
};

}  // namespace

void state_errors(Prediction& prediction, const NozzleFlow& flow) {
    prediction.nozzle.error = nozzle_error(flow.ink());
    if (flow_was_measured(flow)) {
        prediction.exit.error = expected_error(QuestionKind::exit_flow, Rung::steady, 0.0);
    }
    const CellErrors errors(flow, prediction.question.cell, prediction.exit);
    for (CellAnswer& cell : prediction.cells) {
        if (!cell.stress) continue;
        const Rung rung = cell.model == Model::ellipsoid ? Rung::ellipsoid : Rung::steady;
        const bool nozzle = cell.place == Place::nozzle;
        cell.error = nozzle ? errors.in_nozzle(rung, cell.offset) : errors.at_exit(rung, cell.offset);
        if (!nozzle) cell.strain_error = errors.strain_at_exit(rung, cell.offset);
    }
    for (PassageAnswer& passage : prediction.passages) {
        passage.nozzle_error = errors.in_nozzle(Rung::ellipsoid, passage.offset);
        passage.exit_error = errors.at_exit(Rung::ellipsoid, passage.offset);
        passage.error = passage.place == Place::nozzle ? passage.nozzle_error : passage.exit_error;
    }
    if (prediction.population) prediction.population_error = errors.anywhere();
}

}  // namespace bioprint
