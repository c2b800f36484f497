#pragma once

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "io/design.hpp"

/// The predictions a design makes, by their place on the line that is searched: the logarithm of the value, or
/// alpha itself. Each is made once, and no more of it than the limits need.
namespace bioprint {

class DesignLine {
  public:
    struct Point {
        bool answered = false;
        std::vector<CheckResult> results;
    };

    DesignLine(const DesignQuestion& question, const Settings& base, unsigned jobs);
    /// Places at the ends stand for these values exactly.
    void set_range(std::pair<double, double> range) { range_ = range; }

    [[nodiscard]] double place(double value) const;
    [[nodiscard]] double value(double place) const;
    /// How finely predictions along the line tell places apart.
    struct Fineness {
        double place;   ///< of the place sought: where the search ends
        double result;  ///< in the logarithm of a result: what is no sign of a turn
    };
    /// What is carried in time is known to 2e-4, a population to 1e-3.
    [[nodiscard]] Fineness fineness() const {
        if (population_) return {.place = 1e-4, .result = 2e-3};
        if (cells_) return {.place = 1e-4, .result = 1e-3};
        return {.place = 1e-9, .result = 1e-4};
    }
    [[nodiscard]] const std::map<double, Point>& points() const { return points_; }
    /// True when a prediction was made between these places.
    [[nodiscard]] bool has_between(double one, double other) const {
        const auto next = points_.lower_bound(std::min(one, other));
        return next != points_.end() && next->first <= std::max(one, other);
    }

    const Point& at(double place);

    /// How far a limit is broken there, as the logarithm of value over limit where both are positive; at most 0
    /// where it holds. Infinite without a value; minus infinity where nothing flows steadily, which is no
    /// limit's business.
    double excess(std::size_t limit, double place);

  private:
    [[nodiscard]] Point predicted(double value) const;

    const DesignQuestion& question_;
    const Settings& base_;
    unsigned jobs_;
    std::pair<double, double> range_;
    bool cells_ = false;
    bool population_ = false;
    std::map<double, Point> points_;
};

/// What the parameter is in the question as asked, where the search begins.
double usual_value(const Case& asked, Key sought);

/// Flows from 1 nm/s to 10 m/s, pressures from 1 Pa to 100 MPa, gradients from 1 Pa/m to 1 TPa/m, radii from the
/// smallest in which the cells have room to 5 mm, alpha from 0 to 1.
std::pair<double, double> default_range(const Case& asked, Key sought);

}  // namespace bioprint
