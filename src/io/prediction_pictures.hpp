#pragma once

#include <string>
#include <vector>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/predict/prediction.hpp"
#include "io/picture.hpp"

/// The pictures of one question: what flows, what the cells bear, how they look.
namespace bioprint {

/// A question with all that its pictures show.
struct PictureData {
    Case question;
    Prediction prediction;               ///< with a radial profile
    std::vector<AxisCellState> history;  ///< of the centred cell through the exit
};

/// @throws UsageError  nothing flows, and what predict() throws
PictureData picture_data(Case question);

/// "27G steel (R 105 µm), 20 µL/min, alginate-2.5, cell reference": what a picture is of.
std::string picture_title(const PictureData& data);

/// Velocity, stress, rate and viscosity over the radius, cells to scale.
Picture profile_picture(const PictureData& data);
/// Stress and stretch along the axis through the exit: carried in time, and the steady estimate.
Picture exit_picture(const PictureData& data);
/// Nozzle, strand and cells to scale; the centred cell before, at and after its largest load.
Picture cell_picture(const PictureData& data);
/// Stress over flow rate for the needles of a kind, with the question's point.
Picture nomogram_picture(const PictureData& data, unsigned jobs);
/// The cells, the exit, the profiles and the nomogram on one page.
Picture overview_picture(const PictureData& data, unsigned jobs);

}  // namespace bioprint
