#pragma once

#include <string>

#include "io/gnuplot_script.hpp"

/// Drawing by the gnuplot program.
namespace bioprint {

/// @param asker  the option that wants a picture, for the message
/// @throws DataError  gnuplot is not installed; names the package that has it
void require_gnuplot(const std::string& asker);

bool gnuplot_installed();

/// The bytes of the picture.
///
/// gnuplot is started without a shell and without the user's own settings; script and picture go through
/// unnamed files, so no name is passed to it.
/// @throws DataError  gnuplot is missing or refuses; the message holds its own
std::string draw(const Picture& picture, Canvas canvas, const CanvasSize& size = {});

}  // namespace bioprint
