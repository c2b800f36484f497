#pragma once

#include <string>

#include "io/picture.hpp"

/// A picture as a gnuplot script with its data inside: no file is named in it, and no text of the user's can
/// be more than text. The same picture gives the same bytes.
namespace bioprint {

enum class Canvas { svg, png, pdf, terminal };

struct CanvasSize {
    int columns = 79;  ///< of a terminal
    int lines = 24;
};

/// @param name  distinguishes the SVGs of one page
std::string gnuplot_script(const Picture& picture, Canvas canvas, const CanvasSize& size = {});

}  // namespace bioprint
