#include "bioprint/predict/ladder.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "predict/ladder_table.hpp"

namespace bioprint {
namespace {

constexpr std::array<Rung, rung_count> all_rungs{Rung::steady, Rung::ellipsoid, Rung::draft, Rung::standard,
                                                 Rung::fine};

RungVerdict verdict(Rung rung, const RungRequest& request) {
    const RungOutlook& outlook = request.outlook.at(static_cast<std::size_t>(rung));
    RungVerdict v{.rung = rung,
                  .error = std::nullopt,
                  .time = outlook.time,
                  .accurate = true,
                  .affordable = true,
                  .refused = outlook.refused,
                  .record = measured(request.kind, rung, request.load)};
    if (request.measured && !outlook.unknown) v.error = expected_error(request.kind, rung, request.load);
    if (v.error) v.error = std::max(*v.error, outlook.least_error);
    if (!v.time && v.record != nullptr) v.time = v.record->longest;
    if (request.tolerance) v.accurate = v.error && *v.error <= *request.tolerance;
    if (request.budget) v.affordable = v.time && *v.time <= *request.budget;
    return v;
}

bool more_accurate(const RungVerdict& a, const RungVerdict& b) {
    if (!a.error || !b.error) return a.error.has_value();
    return *a.error < *b.error;
}

bool is_simulation(const RungVerdict& v) {
    return resolution_of(v.rung) > 0.0;
}

/// Where no error is known: of the simulations the usual one, or the finest within a budget; else the ellipsoid.
const RungVerdict* usual(const RungRequest& request, const std::vector<const RungVerdict*>& open) {
    const auto named = [&](Rung rung) {
        const auto found =
            std::find_if(open.begin(), open.end(), [&](const auto* v) { return v->rung == rung; });
        return found == open.end() ? nullptr : *found;
    };
    const bool finest = request.simulated && request.budget;
    const RungVerdict* const wanted =
        finest ? nullptr : named(request.simulated ? Rung::standard : Rung::ellipsoid);
    return wanted != nullptr ? wanted : finest ? open.back() : open.front();
}

/// The best that is left when no rung is known to be within the tolerance, or none was asked for.
const RungVerdict* best_of(const RungRequest& request, const std::vector<const RungVerdict*>& able) {
    std::vector<const RungVerdict*> open;
    std::copy_if(able.begin(), able.end(), std::back_inserter(open),
                 [](const auto* v) { return v->affordable; });
    if (open.empty()) {
        const auto timed =
            std::find_if(able.begin(), able.end(), [](const auto* v) { return v->time.has_value(); });
        return timed == able.end() ? usual(request, able) : *timed;
    }
    const RungVerdict* const best = *std::min_element(
        open.begin(), open.end(), [](const auto* a, const auto* b) { return more_accurate(*a, *b); });
    // A model is not passed over for a simulation because nothing is known of it.
    if (best->error) return best;
    std::vector<const RungVerdict*> plain;
    std::copy_if(open.begin(), open.end(), std::back_inserter(plain),
                 [&](const auto* v) { return request.simulated || !is_simulation(*v); });
    return usual(request, plain.empty() ? open : plain);
}

}  // namespace

std::string_view name_of(QuestionKind kind) {
    switch (kind) {
        case QuestionKind::exit_flow:
            return "exit-flow";
        case QuestionKind::channel:
            return "channel";
        case QuestionKind::exit:
            return "exit";
        case QuestionKind::channel_off_axis:
            return "channel-off-axis";
        case QuestionKind::exit_off_axis:
            return "exit-off-axis";
        case QuestionKind::shear:
            return "shear";
    }
    return "";
}

std::string_view name_of(Rung rung) {
    switch (rung) {
        case Rung::steady:
            return "steady";
        case Rung::ellipsoid:
            return "ellipsoid";
        case Rung::draft:
            return "draft";
        case Rung::standard:
            return "standard";
        case Rung::fine:
            return "fine";
    }
    return "";
}

double resolution_of(Rung rung) {
    switch (rung) {
        case Rung::draft:
            return 3.0;
        case Rung::standard:
            return 6.0;
        case Rung::fine:
            return 12.0;
        case Rung::steady:
        case Rung::ellipsoid:
            break;
    }
    return 0.0;
}

std::span<const RungRecord> measured_ladder() {
    return ladder_table;
}

const RungRecord* measured(QuestionKind kind, Rung rung, double load) {
    const auto found = std::find_if(ladder_table.begin(), ladder_table.end(), [&](const RungRecord& r) {
        return r.kind == kind && r.rung == rung && load >= r.load_from && load < r.load_to;
    });
    return found == ladder_table.end() ? nullptr : &*found;
}

double softness_offset(double offset, double cell_radius) {
    return std::max(offset, 3.0 * cell_radius);
}

std::optional<double> expected_error(QuestionKind kind, Rung rung, double load) {
    const RungRecord* record = measured(kind, rung, load);
    if (record == nullptr || record->unjudged > 0) return std::nullopt;
    return record->error;
}

RungChoice choose_rung(const RungRequest& request) {
    RungChoice choice{
        .rung = request.simulated ? Rung::standard : Rung::ellipsoid, .met = false, .ladder = {}};
    for (const Rung rung : all_rungs) choice.ladder.push_back(verdict(rung, request));
    std::vector<const RungVerdict*> able;
    for (const RungVerdict& v : choice.ladder) {
        if (v.refused.empty() && (!request.simulated || is_simulation(v))) able.push_back(&v);
    }
    if (able.empty()) return choice;
    const auto within = std::find_if(able.begin(), able.end(), [](const RungVerdict* v) {
        return v->error && v->accurate && v->affordable;
    });
    if (request.tolerance && within != able.end()) {
        choice.rung = (*within)->rung;
        choice.met = true;
        return choice;
    }
    const RungVerdict* const best = best_of(request, able);
    choice.rung = best->rung;
    choice.met = best->affordable && !request.tolerance;
    return choice;
}

}  // namespace bioprint
