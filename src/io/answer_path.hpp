#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bioprint/io/quantity.hpp"
#include "io/answer_object.hpp"

/// Places in an answer by the words people use for them, and what kind of quantity stands there.
///
/// Beside the paths of the JSON answer there are short forms, which stand in place of the path's beginning:
///
///   population.p95      population.peak_stress.percentile_95; p90, p99, median, mean, largest alike
///   cells.nozzle        the entry of the largest stress in the nozzle
///   cells.exit          the entry at the exit of the cell nearest to the axis
///
/// both by the better model, carried in time where the answer has that.
namespace bioprint {

/// "input" and "radius" make "input.radius".
std::string member_path(std::string path, std::string_view name);

/// The path of the JSON answer that `path` means; itself where it is no short form.
std::string json_path(const Json& answer, std::string_view path);

/// What stands at a path, short forms included.
/// @throws UsageError  naming `option` and the path as it was written: no such place
const Json& value_meant(const Json& answer, std::string_view path, std::string_view option = "--get");

/// The same; none where this answer lacks what others have: the plug of another law, a fifth cell, a section that its
/// row did not ask for.
/// @throws UsageError  naming `option`: no answer has such a place
const Json* value_if_any(const Json& answer, std::string_view path, std::string_view option = "--get");

/// The number or null at a path, short forms included.
/// @throws UsageError  naming `option`: no such place, or a text or list there
std::optional<double> number_at(const Json& answer, std::string_view path, std::string_view option);

/// True for a path that some answer has, so that one without it has no value there rather than a mistake.
bool is_known_path(std::string_view path);

/// The unit of a number there, as `unit_of`; it knows short forms, simulations and spreads too.
std::string unit_at(std::string_view path);
Dimension dimension_at(std::string_view path);

/// Whether only an answer with the population can have it.
bool needs_population(std::string_view path);

}  // namespace bioprint
