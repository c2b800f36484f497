#pragma once

#include <optional>

#include "bioprint/predict/prediction.hpp"
#include "predict/exit_field.hpp"
#include "predict/size_effect.hpp"

/// The cells of an answer carried in time: what does not depend on their position is made once.
namespace bioprint {

class CarriedCells {
  public:
    /// A passage on the axis that fails leaves a warning, and cells without effects of size.
    CarriedCells(const NozzleFlow& flow, Prediction& prediction);

    /// Adds the entries of model ellipsoid of a position, and its passage. What fails leaves empty entries
    /// and a warning.
    void add(const NozzleFlow& flow, double offset, Prediction& prediction) const;

  private:
    void add_centred_exit(Prediction& prediction) const;
    void add_at_rest(double offset, Prediction& prediction) const;

    std::optional<ExitField> field_;  ///< none where nothing flows
    SizeEffect size_;
    double relaxation_time_;
};

/// An entry with nothing but its place.
CellAnswer blank_cell(Place place, Model model, double offset, double fluid_stress, const CellChoice& cell);

}  // namespace bioprint
