#include "numerics/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "bioprint/errors.hpp"

namespace bioprint {
namespace {

constexpr int most_steps = 200;

struct Place {
    double s;
    double excess;
};

struct Bracket {
    Place inside;
    Place outside;
};

/// Where the straight line through two places meets zero; none where it does not.
std::optional<double> secant(const Place& a, const Place& b) {
    if (!std::isfinite(a.excess) || !std::isfinite(b.excess) || a.excess == b.excess) return std::nullopt;
    const double s = a.s - a.excess * (b.s - a.s) / (b.excess - a.excess);
    return std::isfinite(s) ? std::optional(s) : std::nullopt;
}

/// Steps from the start towards the other side until it is found, or the end of the line is reached.
Bracket expand(const std::function<double(double)>& excess, const BoundaryRequest& request,
               Boundary& result) {
    Place last{request.start, excess(request.start)};
    const bool upwards = last.excess <= 0.0;
    const double end = upwards ? request.high : request.low;
    double step = request.first_step;
    for (int i = 0; i < most_steps; ++i) {
        if (last.s == end) {
            (upwards ? result.inside : result.outside) = last.s;
            return {last, last};
        }
        const double reach = upwards ? std::min(end, last.s + step) : std::max(end, last.s - step);
        const Place next{reach, excess(reach)};
        if ((next.excess <= 0.0) != upwards) return upwards ? Bracket{last, next} : Bracket{next, last};
        // Twice as far, or a little beyond where the line through the last two leads, if that is nearer.
        const std::optional<double> aim = secant(last, next);
        const double ahead = aim ? (*aim - next.s) * (upwards ? 1.0 : -1.0) : 0.0;
        step = ahead > 0.0 ? std::min(2.0 * step, 1.3 * ahead + request.tolerance) : 2.0 * step;
        last = next;
    }
    throw NotConverged("search for a limit: no end of the range was reached in 200 steps");
}

}  // namespace

Boundary find_boundary(const std::function<double(double)>& excess, const BoundaryRequest& request) {
    Boundary result;
    auto [inside, outside] = expand(excess, request, result);
    if (result.inside || result.outside) return result;
    // The rule of Illinois: a secant whose unmoved end counts half, with a step of halving where it stalls.
    double weight_inside = inside.excess;
    double weight_outside = outside.excess;
    double last_width = outside.s - inside.s;
    int slow = 0;
    for (int i = 0; i < most_steps; ++i) {
        const double width = outside.s - inside.s;
        if (width <= request.tolerance) {
            result.inside = inside.s;
            result.outside = outside.s;
            return result;
        }
        slow = width > 0.5 * last_width ? slow + 1 : 0;
        last_width = width;
        double s = 0.5 * (inside.s + outside.s);
        if (slow < 4) {
            const std::optional<double> aim = secant({inside.s, weight_inside}, {outside.s, weight_outside});
            // Nearer to an end than that, the end is all but the answer: a step across closes the bracket.
            const double margin = std::min(0.9 * request.tolerance, 0.5 * width);
            if (aim) s = std::clamp(*aim, inside.s + margin, outside.s - margin);
        } else {
            slow = 0;
        }
        if (s <= inside.s || s >= outside.s)
            throw NotConverged("search for a limit: the tolerance is too small");
        const Place next{s, excess(s)};
        if (next.excess <= 0.0) {
            inside = next;
            weight_inside = next.excess;
            weight_outside *= 0.5;
        } else {
            outside = next;
            weight_outside = next.excess;
            weight_inside *= 0.5;
        }
    }
    throw NotConverged("search for a limit: not narrowed down in 200 steps");
}

}  // namespace bioprint
