#pragma once

#include <functional>
#include <optional>

/// How far along a line a condition holds: the end of { s : excess(s) <= 0 } for an excess that increases.
///
/// From the start the other side is looked for by steps that grow, so that both ends of what is then narrowed
/// have been computed: `inside` holds, `outside` does not, and they lie within the tolerance. The excess may be
/// infinite and may jump; it need not be smooth, but where it is, some 8 evaluations suffice.
namespace bioprint {

struct BoundaryRequest {
    double low;
    double high;
    double start;       ///< within low and high
    double first_step;  ///< > 0
    double tolerance;   ///< largest distance of the two ends, > 0
};

struct Boundary {
    std::optional<double> inside;   ///< the largest place found to hold; none: not even `low` does
    std::optional<double> outside;  ///< the smallest place found not to hold; none: even `high` does
};

/// @throws NotConverged  200 steps did not suffice
Boundary find_boundary(const std::function<double(double)>& excess, const BoundaryRequest& request);

}  // namespace bioprint
