#pragma once

#include <string_view>

#include "bioprint/predict/case.hpp"
#include "io/settings.hpp"

/// Which way a quantity of the answer goes when one parameter grows, as far as the theory says it.
///
/// In a steady nozzle flow the local rate grows with the local stress, and that is proportional to the wall's:
/// every velocity and rate grows with the wall's stress, and the reverse. The flow rate over R³ and the velocity
/// over R depend on the wall's stress alone; so at a given flow or velocity the stress falls as R grows. At a
/// given pressure gradient it is G R/2.
namespace bioprint {

/// +1 grows, -1 falls, 0 not known beforehand.
/// @param drive  what is given while the radius is sought
int direction_by_theory(std::string_view path, Key sought, Drive drive);

/// Whether too large a value is what leaves no steady flow; else too small a one.
bool steady_flow_ends_above(Key sought, Drive drive);

}  // namespace bioprint
