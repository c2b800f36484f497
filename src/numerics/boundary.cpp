#include "numerics/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Where the parabola s(excess) through both ends a and b and a third place beyond a meets zero; none where the
/// excess is too bent for one (Chandrupatla 1997).
std::optional<double> parabola(const Place& a, const Place& b, const Place& c) {
    if (!std::isfinite(a.excess) || !std::isfinite(b.excess) || !std::isfinite(c.excess)) return std::nullopt;
    const double xi = (a.s - b.s) / (c.s - b.s);
    const double phi = (a.excess - b.excess) / (c.excess - b.excess);
    if (!(phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)) return std::nullopt;
    const double from_b = a.excess / (b.excess - a.excess) * c.excess / (b.excess - c.excess);
    const double from_c =
        (c.s - a.s) / (b.s - a.s) * a.excess / (c.excess - a.excess) * b.excess / (c.excess - b.excess);
    const double s = a.s + (from_b + from_c) * (b.s - a.s);
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
        // A little beyond where the line through the last two leads, but not much further than so far.
        const std::optional<double> aim = secant(last, next);
        const double ahead = aim ? (*aim - next.s) * (upwards ? 1.0 : -1.0) : 0.0;
        step = ahead > 0.0 ? std::min(4.0 * step, 1.3 * ahead + request.tolerance) : 2.0 * step;
        last = next;
    }
    throw NotConverged("search for a limit: no end of the range was reached in 200 steps");
}

}  // namespace

Boundary find_boundary(const std::function<double(double)>& excess, const BoundaryRequest& request) {
    Boundary result;
    auto [inside, outside] = expand(excess, request, result);
    if (result.inside || result.outside) return result;
    std::optional<Place> replaced;  // the last end that was, by one nearer to the other
    bool inside_moved = false;
    double last_step = outside.s - inside.s;
    int slow = 0;
    for (int i = 0; i < most_steps; ++i) {
        const double width = outside.s - inside.s;
        if (width <= request.tolerance) {
            result.inside = inside.s;
            result.outside = outside.s;
            return result;
        }
        double s = 0.5 * (inside.s + outside.s);
        if (slow < 2) {
            // Nearer to an end than that, the end is all but the answer: a step across closes the bracket.
            const double margin = std::min(0.9 * request.tolerance, 0.5 * width);
            std::optional<double> aim;
            if (replaced)
                aim = inside_moved ? parabola(inside, outside, *replaced)
                                   : parabola(outside, inside, *replaced);
            if (!aim) aim = secant(inside, outside);
            if (aim) s = std::clamp(*aim, inside.s + margin, outside.s - margin);
        } else {
            slow = 0;
        }
        if (s <= inside.s || s >= outside.s)
            throw NotConverged("search for a limit: the tolerance is too small");
        const Place next{s, excess(s)};
        const double step = std::min(s - inside.s, outside.s - s);
        slow = step > 0.5 * last_step ? slow + 1 : 0;
        last_step = step;
        inside_moved = next.excess <= 0.0;
        replaced = std::exchange(inside_moved ? inside : outside, next);
    }
    throw NotConverged("search for a limit: not narrowed down in 200 steps");
}

}  // namespace bioprint
