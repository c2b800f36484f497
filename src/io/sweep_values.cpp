#include "io/sweep_values.hpp"

#include <exception>
#include <limits>
#include <utility>

#include "bioprint/errors.hpp"
#include "io/answer_path.hpp"
#include "io/row_answer.hpp"
#include "io/uncertainty.hpp"
#include "numerics/parallel.hpp"

namespace bioprint {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

double drawn_number(const Json& answer, const std::string& path) {
    const Json* const value = value_if_any(answer, path);
    if (value == nullptr || value->is_null()) return no_value;
    if (!value->is_number()) {
        throw UsageError("--plot: '" + path + "' is no number; draw a path to one, such as nozzle.stress_max",
                         "--plot");
    }
    return value->get<double>();
}

std::vector<SweepQuantity> default_quantities(bool population) {
    std::vector<SweepQuantity> quantities = {
        {.title = "stress at the wall", .dimension = Dimension::pressure, .path = "nozzle.stress_max"},
        {.title = "cell in the nozzle",
         .dimension = Dimension::pressure,
         .path = "cells.nozzle.stress.von_mises"},
        {.title = "cell at the exit",
         .dimension = Dimension::pressure,
         .path = "cells.exit.stress.von_mises"}};
    if (population) {
        quantities.push_back(
            {.title = "95 % of all cells", .dimension = Dimension::pressure, .path = "population.p95"});
    }
    return quantities;
}

}  // namespace

SweepValues::SweepValues(const Sweep& sweep, const RunOptions& options)
    : sweep_(sweep),
      extras_(options.extras),
      jobs_(options.jobs),
      interrupted_(options.interrupted),
      named_(!options.paths.empty()),
      taken_(sweep.size(), 0) {
    if (!named_) quantities_ = default_quantities(sweep.fixed().has(Key::population));
    for (const std::string& path : options.paths) {
        const Dimension dimension = dimension_at(path);
        std::string title = path;
        // A unit without others to choose from, such as rad, stands in the name.
        const std::string unit = dimension == Dimension::dimensionless ? unit_at(path) : std::string{};
        if (!unit.empty()) title.append(" [").append(unit).append("]");
        quantities_.push_back({.title = std::move(title), .dimension = dimension, .path = path});
    }
    for (SweepQuantity& quantity : quantities_) {
        quantity.values.assign(sweep.size(), no_value);
        if (spread()) quantity.low = quantity.high = quantity.values;
    }
    require_numbers();
}

void SweepValues::require_numbers() const {
    std::exception_ptr refusal;
    for (std::size_t row = 0; row < sweep_.size(); ++row) {
        Json answer;
        try {
            answer = answer_object(predict(sweep_.row(row).make_case()));
        } catch (const Error&) {
            if (!refusal) refusal = std::current_exception();
            continue;
        }
        for (const SweepQuantity& quantity : quantities_) (void)drawn_number(answer, quantity.path);
        return;
    }
    if (refusal) std::rethrow_exception(refusal);
}

void SweepValues::take(std::size_t row, const Json& answer) {
    taken_[row] = 1;
    if (answer.contains("error")) return;
    for (SweepQuantity& quantity : quantities_) {
        quantity.values[row] = drawn_number(answer, quantity.path);
        if (!spread()) continue;
        if (const Json* const spread = spread_of(answer, quantity.path)) {
            quantity.low[row] = spread->at("percentile_5").get<double>();
            quantity.high[row] = spread->at("percentile_95").get<double>();
        }
    }
}

void SweepValues::complete() {
    for_each_index(sweep_.size(), jobs_, [&](std::size_t row) {
        if (taken_[row] != 0) return;
        if (interrupted_ != nullptr && *interrupted_) throw DataError("interrupted");
        take(row, answer_row([&] { return sweep_.row(row); }, extras_).object);
    });
}

}  // namespace bioprint
