#pragma once

#include <string_view>

/// The files of data/, put into the library when it is built.
namespace bioprint::preset_texts {

extern const std::string_view inks;
extern const std::string_view cells;
extern const std::string_view nozzles;

}  // namespace bioprint::preset_texts
