#include "io/published_limits.hpp"

#include "bioprint/errors.hpp"
#include "bioprint/io/presets.hpp"

namespace bioprint {

std::vector<PublishedLimit> published_limits(const std::string& cell_name) {
    std::vector<PublishedLimit> limits;
    try {
        const CellPreset& preset = find_cell(cell_name);
        for (const ViabilityThreshold& point : preset.viability_thresholds) {
            limits.push_back({.wall_stress = point.wall_stress,
                              .duration = point.exposure,
                              .viability = point.viability,
                              .source = preset.source});
        }
    } catch (const UsageError&) {
        // A cell of the caller's own.
    }
    return limits;
}

Json published_object(const std::vector<PublishedLimit>& limits) {
    Json list = Json::array();
    for (const PublishedLimit& limit : limits) {
        Json entry = Json::object();
        entry["wall_stress"] = limit.wall_stress;
        entry["duration"] = limit.duration;
        entry["viability"] = limit.viability;
        entry["source"] = limit.source;
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace bioprint
