#pragma once

#include <string>
#include <vector>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/predict/prediction.hpp"
#include "io/answer_object.hpp"
#include "io/picture.hpp"

/// The pictures of one question: what flows, what the cells bear, how they look.
namespace bioprint {

/// A question with all that its pictures show.
struct PictureData {
    Case question;
    Prediction prediction;               ///< with a radial profile
    std::vector<AxisCellState> history;  ///< of the centred cell through the exit
    Json answer = {};                    ///< with the spread of its numbers, where one was asked for
};

/// @param answer  to the question, with what was asked beyond it; null: without
/// @throws UsageError  nothing flows, and what predict() throws
PictureData picture_data(Case question, Json answer = {});

/// "27G steel (R 105 µm), 20 µL/min": what a picture is of, and below it ink and cell.
std::string picture_title(const PictureData& data);
std::string picture_subtitle(const PictureData& data);

/// The cells in the nozzle with their place in the answer; of one that was carried in time, not its steady estimate.
struct PlacedCell {
    std::size_t index;
    CellAnswer cell;
};
std::vector<PlacedCell> cells_in_nozzle(const PictureData& data);

/// Adds a point, with a bar over 5 to 95 % of its spread where it has one.
/// @param path  of the number in the answer, "nozzle.stress_max"
void add_point(Series& series, const PictureData& data, const std::string& path, double x, double y);

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
