#pragma once

#include "io/fit_answer.hpp"
#include "io/picture.hpp"

/// A fit to look at: the flow curve with the laws fitted to it, and what the law chosen leaves over.
namespace bioprint {

Picture fit_picture(const FitAnswer& answer);

}  // namespace bioprint
