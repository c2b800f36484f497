#pragma once

#include "bioprint/predict/streamline_passage.hpp"
#include "predict/exit_field.hpp"

namespace bioprint {

/// As the public one, with a field made once for many streamlines.
StreamlinePassage streamline_passage(const NozzleFlow& flow, const ExitField& field,
                                     const StreamlineRequest& request);

}  // namespace bioprint
