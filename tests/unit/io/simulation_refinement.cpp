#include "io/simulation_refinement.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace bioprint;

/// Runs whose numerical error falls with the square of the resolution; the draft's is 9 %.
class Runs {
  public:
    double broken_from =
        std::numeric_limits<double>::infinity();  ///< nodes from which on a run gives no stress
    double thrown_from = std::numeric_limits<double>::infinity();  ///< or does not come to its end
    double trusted_from =
        0.0;  ///< nodes from which on what was measured of such runs is within the tolerance
    double finest = 12.0;
    bool cancelled = false;
    std::vector<double> made;

    Refinement refine_to(double tolerance, Fidelity first = Fidelity::draft) {
        SimulationQuestion question;
        question.scene = "channel";
        question.fidelity = first;
        question.tolerance = tolerance;
        return refine(
            question, [&](const SimulationQuestion& asked) { return run(resolution_of(asked)); },
            [&](const SimulationQuestion& asked, const SimulationResult&) {
                return resolution_of(asked) >= trusted_from;
            },
            [&](const SimulationQuestion& asked) {
                return 2.0 * resolution_of(asked) > finest ? std::string("no finer one") : std::string();
            },
            [&] { return cancelled; });
    }

  private:
    Comparison run(double nodes) {
        made.push_back(nodes);
        if (nodes >= thrown_from) throw SimulationIncomplete("an element turned inside out", {});
        Comparison comparison;
        comparison.run.scene = SceneKind::channel;
        const double error = 0.81 / (nodes * nodes);
        const double stress = nodes >= broken_from ? std::nan("") : 100.0;
        comparison.run.values = {{.name = "von_mises", .value = stress, .error = error * 100.0}};
        return comparison;
    }
};

}  // namespace

TEST_CASE("refinement: ends at the first run within the tolerance") {
    Runs runs;
    const Refinement loose = runs.refine_to(0.1);
    CHECK(runs.made == std::vector{3.0});
    CHECK_FALSE(loose.how.refined);
    CHECK(loose.how.stop.empty());
    runs.made.clear();
    const Refinement strict = runs.refine_to(0.01);
    CHECK(runs.made == std::vector{3.0, 6.0, 12.0});
    CHECK(strict.how.refined);
    CHECK(strict.how.error == doctest::Approx(0.005625));
    CHECK(resolution_of(strict.question) == 12.0);
}

TEST_CASE("refinement: a run that was measured to be further off than the tolerance is refined") {
    Runs runs;
    runs.trusted_from = 6.0;
    const Refinement r = runs.refine_to(0.1);
    CHECK(runs.made == std::vector{3.0, 6.0});
    CHECK(r.how.within);
    Runs never;
    never.trusted_from = 48.0;
    const Refinement none = never.refine_to(0.1);
    CHECK(never.made == std::vector{3.0, 6.0, 12.0});
    CHECK_FALSE(none.how.within);
}

TEST_CASE("refinement: the finest run in reach stands and says why") {
    Runs runs;
    const Refinement r = runs.refine_to(0.001);
    CHECK(runs.made == std::vector{3.0, 6.0, 12.0});
    CHECK(r.how.stop == "no finer one");
    CHECK(resolution_of(r.question) == 12.0);
}

TEST_CASE("refinement: where a finer run breaks down the coarser answer stands") {
    Runs broken;
    broken.broken_from = 12.0;
    const Refinement r = broken.refine_to(0.001);
    CHECK(broken.made == std::vector{3.0, 6.0, 12.0});
    CHECK(resolution_of(r.question) == 6.0);
    CHECK(r.how.error == doctest::Approx(0.0225));
    CHECK(r.how.refined);
    CHECK(r.how.stop.find("12 nodes a cell radius, did not come to its end: the simulation broke down") !=
          std::string::npos);
    CHECK(r.comparison.run.at("von_mises").value == 100.0);

    Runs thrown;
    thrown.thrown_from = 6.0;
    const Refinement first = thrown.refine_to(0.001);
    CHECK(resolution_of(first.question) == 3.0);
    CHECK_FALSE(first.how.refined);
    CHECK(first.how.stop.find("an element turned inside out") != std::string::npos);
}

TEST_CASE("refinement: the first run's error and the user's Ctrl-C go on") {
    Runs first;
    first.thrown_from = 3.0;
    CHECK_THROWS_AS(first.refine_to(0.001), SimulationIncomplete);
    Runs stopped;
    stopped.thrown_from = 6.0;
    stopped.cancelled = true;
    CHECK_THROWS_AS(stopped.refine_to(0.001), SimulationIncomplete);
}

TEST_CASE("refinement: a first run that broke down is not refined") {
    Runs runs;
    runs.broken_from = 3.0;
    const Refinement r = runs.refine_to(0.05);
    CHECK(runs.made == std::vector{3.0});
    CHECK_FALSE(breakdown(r.comparison.run).empty());
}
