#pragma once

#include <vector>

#include "bioprint/cell/axis_passage.hpp"
#include "bioprint/predict/comparison.hpp"
#include "io/picture.hpp"
#include "io/prediction_pictures.hpp"

/// A simulation's course, and what was predicted for it.
namespace bioprint {

Picture simulation_picture(const PictureData& data, const Comparison& comparison);

}  // namespace bioprint
