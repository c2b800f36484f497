#include "io/design.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/design_direction.hpp"
#include "io/design_line.hpp"
#include "io/text.hpp"
#include "numerics/boundary.hpp"

namespace bioprint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::array<std::pair<std::string_view, Key>, 6> sought_words = {
    {{"radius", Key::radius},
     {"flowrate", Key::flow_rate},
     {"velocity", Key::velocity},
     {"pressure", Key::pressure},
     {"pressure-gradient", Key::pressure_gradient},
     {"alpha", Key::alpha}}};

class DesignSearch {
  public:
    DesignSearch(const DesignQuestion& question, const Settings& base, unsigned jobs)
        : question_(question), line_(question, base, jobs) {
        // Asked with the value the search begins at, so that what is wrong with the question is found first.
        Case asked = base.make_case();
        drive_ = asked.drive;
        design_.range = question.range.value_or(default_range(asked, question.sought));
        line_.set_range(design_.range);
        low_ = line_.place(design_.range.first);
        high_ = line_.place(design_.range.second);
        double start = 0.5 * (low_ + high_);
        try {
            start = line_.place(usual_value(asked, question.sought));
        } catch (const NoSteadyFlow&) {
            start = low_ + 0.25 * (high_ - low_);
        }
        start_ = std::isfinite(start) ? std::clamp(start, low_, high_) : low_;
        (void)with_value(base, question.sought, line_.value(start_)).make_case();  // says what else is wrong
        tolerance_ = line_.fineness().place;
        first_step_ = question.sought == Key::alpha ? 0.04 : 0.4 * std::numbers::ln2;
    }

    Design solve() {
        find_directions();
        Boundary upper = end_of(1);
        Boundary lower = end_of(-1);
        require_answers();
        bool possible = upper.inside && lower.inside && -*lower.inside <= *upper.inside && constants_hold();
        if (const std::optional<double> inside = contradiction(upper, lower, possible)) {
            around_ = *inside;
            upper = end_of(1);
            lower = end_of(-1);
            possible = true;
        }
        possible ? settle(upper, lower) : approach();
        if (possible) look_around(upper, lower);
        judge_monotony();
        for (std::size_t i = 0; i < question_.limits.size(); ++i) {
            design_.limits[i].result = line_.at(place_).results[i];
            if (!possible) design_.limits[i].binds = !design_.limits[i].result.holds;
        }
        design_.value = line_.value(place_);
        design_.evaluations = static_cast<int>(line_.points().size());
        return std::move(design_);
    }

  private:
    [[nodiscard]] BoundaryRequest request(double low, double high, double start) const {
        return {.low = low, .high = high, .start = start, .first_step = first_step_, .tolerance = tolerance_};
    }

    /// How far from the start all limits of a side are kept, in places times the side.
    Boundary end_of(int side) {
        const double low = side > 0 ? low_ : -high_;
        const double high = side > 0 ? high_ : -low_;
        const bool idle = !around_ &&
                          std::find(direction_.begin(), direction_.end(), side) == direction_.end() &&
                          (side > 0) != steady_flow_ends_above(question_.sought, drive_);
        if (idle) return {.inside = high, .outside = std::nullopt};
        return find_boundary([&](double s) { return worst(side, side * s); },
                             request(low, high, side * around_.value_or(start_)));
    }

    void find_directions() {
        design_.limits.resize(question_.limits.size());
        direction_.assign(question_.limits.size(), 0);
        for (std::size_t i = 0; i < question_.limits.size(); ++i) {
            const Check& limit = question_.limits[i];
            const int sign = is_upper(limit.relation) ? 1 : -1;
            const int known = direction_by_theory(limit.path, question_.sought, drive_);
            design_.limits[i].by_theory = known != 0;
            direction_[i] = known != 0 ? sign * known : measured_direction(i, sign);
        }
    }

    /// The side on which a limit is broken, from two places where it has a value.
    int measured_direction(std::size_t limit, int sign) {
        const bool above = steady_flow_ends_above(question_.sought, drive_);
        std::optional<std::pair<double, double>> first;
        const double step = first_step_;
        for (const double turn : {0.0, 1.0, -1.0, -4.0, -10.0, -20.0}) {
            const double s = std::clamp(start_ + turn * step * (above ? 1.0 : -1.0), low_, high_);
            const double e = line_.excess(limit, s);
            if (!std::isfinite(e)) continue;
            if (!first) {
                first = {s, e};
            } else if (std::abs(e - first->second) > 1e-12) {
                return (e > first->second) == (s > first->first) ? 1 : -1;
            }
        }
        // The same everywhere it was looked for: it does not depend on the parameter.
        if (first) return 0;
        return above ? sign : -sign;
    }

    /// What was measured near the start need not hold at the ends of the range: a limit may turn on the way. Where
    /// what was found is contradicted there, the place nearest to the start that keeps all limits, around which
    /// they are then looked for on both sides.
    std::optional<double> contradiction(const Boundary& upper, const Boundary& lower, bool possible) {
        const auto measured = [](const LimitStand& limit) { return !limit.by_theory; };
        if (std::none_of(design_.limits.begin(), design_.limits.end(), measured)) return std::nullopt;
        const bool high = broken_by(high_) <= 0.0;
        const bool low = broken_by(low_) <= 0.0;
        const bool agrees = possible ? (upper.outside || high) && (lower.outside || low) : !(high || low);
        if (agrees) return std::nullopt;
        std::optional<double> nearest;
        for (const auto& [s, point] : line_.points()) {
            if (nearest && std::abs(s - start_) >= std::abs(*nearest - start_)) continue;
            if (broken_by(s) <= 0.0) nearest = s;
        }
        return nearest;
    }

    [[nodiscard]] bool constants_hold() {
        for (std::size_t i = 0; i < direction_.size(); ++i) {
            if (direction_[i] != 0 || line_.excess(i, start_) <= 0.0) continue;
            design_.remarks.push_back(question_.limits[i].text + " does not depend on what is sought");
            return false;
        }
        return true;
    }

    /// By how much the worst of the limits that are broken on one side is broken.
    double worst(int side, double place) {
        const bool ends_here = around_ || (side > 0) == steady_flow_ends_above(question_.sought, drive_);
        double excess = -1e300;
        if (!line_.at(place).answered) return ends_here ? infinity : excess;
        for (std::size_t i = 0; i < direction_.size(); ++i) {
            if (around_ || direction_[i] == side) excess = std::max(excess, line_.excess(i, place));
        }
        return excess;
    }

    /// A limit without a value anywhere is a question that lacks something; no answer anywhere is physics.
    void require_answers() const {
        const auto& points = line_.points();
        const auto answered = [](const auto& point) { return point.second.answered; };
        if (std::none_of(points.begin(), points.end(), answered)) {
            throw NoSteadyFlow("no steady flow for any value from " + text_of(design_.range.first) + " to " +
                               text_of(design_.range.second) +
                               " of what is sought; change the other options");
        }
        for (std::size_t i = 0; i < direction_.size(); ++i) {
            const bool none = std::none_of(points.begin(), points.end(), [&](const auto& point) {
                return point.second.answered && point.second.results[i].value;
            });
            if (none) {
                throw UsageError("--limit: " + sentence(question_.limits[i], CheckResult{}), "--limit");
            }
        }
    }

    [[nodiscard]] std::string text_of(double value) const {
        return lab_text(value, *info_of(question_.sought).dimension);
    }

    void settle(const Boundary& upper, const Boundary& lower) {
        const double low = -*lower.inside;
        const double high = *upper.inside;
        const bool prefers_largest = question_.sought != Key::radius && question_.sought != Key::alpha;
        design_.largest = upper.outside.has_value() == lower.outside.has_value() ? prefers_largest
                                                                                 : upper.outside.has_value();
        place_ = design_.largest ? high : low;
        design_.kept = {line_.value(low), line_.value(high)};
        const std::optional<double> outside =
            design_.largest ? upper.outside : (lower.outside ? std::optional(-*lower.outside) : std::nullopt);
        design_.outcome = outside ? DesignOutcome::found : DesignOutcome::unlimited;
        if (!outside) return;
        design_.beyond = line_.value(*outside);
        design_.steady_flow_binds = !line_.at(*outside).answered;
        for (std::size_t i = 0; i < direction_.size(); ++i) {
            design_.limits[i].binds =
                (around_ || direction_[i] == (design_.largest ? 1 : -1)) && line_.excess(i, *outside) > 0.0;
        }
    }

    /// Where the limits broken on either side are broken equally, or the end of the range nearest to that.
    void approach() {
        design_.outcome = DesignOutcome::impossible;
        const auto balance = [&](double s) {
            const double above = worst(1, s);
            const double below = worst(-1, s);
            if (above == below) return 0.0;
            return std::isfinite(above) && std::isfinite(below) ? above - below
                                                                : (above > below ? 1.0 : -1.0);
        };
        BoundaryRequest coarse = request(low_, high_, start_);
        coarse.tolerance = 1e-4;
        const Boundary meeting = find_boundary(balance, coarse);
        place_ = meeting.inside.value_or(low_);
        design_.largest = !meeting.outside;
        if (!line_.at(place_).answered && meeting.outside && line_.at(*meeting.outside).answered) {
            place_ = *meeting.outside;
        }
        // A limit that turns may be broken by less elsewhere.
        double least = broken_by(place_);
        for (const auto& [s, point] : line_.points()) {
            if (const double excess = broken_by(s); excess < least - line_.fineness().result) {
                least = excess;
                place_ = s;
            }
        }
    }

    /// By how much the worst of all limits is broken.
    double broken_by(double place) {
        double excess = -1e300;
        if (!line_.at(place).answered) return infinity;
        for (std::size_t i = 0; i < direction_.size(); ++i) excess = std::max(excess, line_.excess(i, place));
        return excess;
    }

    /// Limits whose direction was measured are looked at inside the interval, too.
    void look_around(const Boundary& upper, const Boundary& lower) {
        const bool measured = std::any_of(design_.limits.begin(), design_.limits.end(),
                                          [](const LimitStand& limit) { return !limit.by_theory; });
        if (!measured) return;
        const double other = design_.largest ? -*lower.inside : *upper.inside;
        const double reach = question_.sought == Key::alpha ? 1.0 : std::log(100.0);
        const double distance = std::clamp(other - place_, -reach, reach);
        for (const double part : {0.05, 0.2, 0.5}) {
            const double s = std::clamp(place_ + part * distance, low_, high_);
            if (line_.has_between(s - 0.3 * part * distance, s + 0.3 * part * distance)) continue;
            const DesignLine::Point& point = line_.at(s);
            for (std::size_t i = 0; i < direction_.size(); ++i) {
                if (point.answered && !point.results[i].holds && design_.limits[i].monotone) {
                    design_.limits[i].monotone = false;
                    design_.remarks.push_back(question_.limits[i].text + " is broken at " +
                                              text_of(line_.value(s)) +
                                              " too, inside the interval; narrow it with --range");
                }
            }
        }
    }

    /// Every evaluation is held against the direction of its limit.
    void judge_monotony() {
        for (std::size_t i = 0; i < direction_.size(); ++i) {
            // What is integrated in time, and over a population, is known to that alone.
            const double slack = design_.limits[i].by_theory ? 1e-9 : line_.fineness().result;
            std::optional<double> before;
            double turn = 0.0;
            for (const auto& [s, point] : line_.points()) {
                if (!point.answered || direction_[i] == 0) continue;
                const double e = line_.excess(i, s) * direction_[i];
                if (before && e < *before - slack && turn == 0.0) turn = line_.value(s);
                before = e;
            }
            if (turn == 0.0 || !design_.limits[i].monotone) continue;
            design_.limits[i].monotone = false;
            design_.remarks.push_back(question_.limits[i].text + " is not monotone near " + text_of(turn) +
                                      ": other values may keep or break it; narrow it with --range");
        }
    }

    const DesignQuestion& question_;
    DesignLine line_;
    Design design_{};
    Drive drive_ = Drive::velocity;
    double low_ = 0.0;
    double high_ = 0.0;
    double start_ = 0.0;
    std::optional<double> around_;  ///< a place that keeps all limits, where one of them turns
    double place_ = 0.0;
    double tolerance_ = 0.0;
    double first_step_ = 0.0;
    std::vector<int> direction_;  ///< of each limit: +1 broken above, -1 broken below, 0 the same everywhere
};

}  // namespace

Key sought_key(std::string_view word) {
    for (const auto& [name, key] : sought_words) {
        if (word == name || find_key(word) == key) return key;
    }
    throw UsageError("--solve: got " + in_quotes(word) +
                         "; it takes radius, flowrate, velocity, pressure, pressure-gradient or alpha",
                     "--solve");
}

std::pair<double, double> parse_range(std::string_view text, Key sought) {
    const Dimension dimension = *info_of(sought).dimension;
    const std::size_t colon = text.find(':');
    const std::string option = "--range";
    if (colon == std::string_view::npos || text.find(':', colon + 1) != std::string_view::npos) {
        throw UsageError(option + ": got " + in_quotes(text) + "; it takes two values, LOW:HIGH", option);
    }
    std::string list(text);
    list[colon] = ',';
    const std::vector<double> ends = parse_quantity_list(list, dimension, option);
    const bool from_zero = sought == Key::alpha;
    if (ends.size() != 2 || !(ends[0] < ends[1]) || ends[0] < 0.0 || (!from_zero && ends[0] == 0.0)) {
        throw UsageError(option + ": got " + in_quotes(text) + "; it takes LOW:HIGH with 0 " +
                             (from_zero ? "<=" : "<") + " LOW < HIGH",
                         option);
    }
    return {ends[0], ends[1]};
}

Settings with_value(const Settings& base, Key sought, double value) {
    Settings own;
    own.set_number(sought, value, "--solve");
    return own.over(base);
}

Design solve_design(const DesignQuestion& question, const Settings& base, unsigned jobs) {
    return DesignSearch(question, base, jobs).solve();
}

}  // namespace bioprint
