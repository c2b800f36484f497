#pragma once

#include <string>
#include <vector>

#include "io/answer_object.hpp"

/// What has been published about the cells a population is of: context beside its numbers, never a judgement.
namespace bioprint {

/// One published point: the part of the cells that survived a stress of the ink at the wall for a time.
struct PublishedLimit {
    double wall_stress;  ///< [Pa]
    double duration;     ///< [s]
    double viability;    ///< 0 to 1
    std::string source;
};

/// Those of a cell preset; empty where it has none, or no preset is called so.
std::vector<PublishedLimit> published_limits(const std::string& cell_name);

/// As `population.published` of the answer.
Json published_object(const std::vector<PublishedLimit>& limits);

}  // namespace bioprint
