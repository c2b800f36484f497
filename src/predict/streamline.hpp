#pragma once

#include "bioprint/predict/streamline_passage.hpp"
#include "predict/exit_field.hpp"
#include "predict/size_effect.hpp"

namespace bioprint {

/// As the public one, with the field and the effects of size made once for many streamlines; the request's
/// cell radius is not asked.
StreamlinePassage streamline_passage(const NozzleFlow& flow, const ExitField& field, const SizeEffect& size,
                                     const StreamlineRequest& request,
                                     FunctionRef<void(const StreamlineState&)> observe);

}  // namespace bioprint
