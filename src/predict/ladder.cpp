#include "bioprint/predict/ladder.hpp"

#include <algorithm>
#include <array>

#include "predict/ladder_table.hpp"

namespace bioprint {
namespace {

constexpr std::array<Rung, 5> all_rungs{Rung::steady, Rung::ellipsoid, Rung::draft, Rung::standard,
                                        Rung::fine};

RungVerdict verdict(Rung rung, const RungRequest& request) {
    RungVerdict v{.rung = rung,
                  .error = expected_error(request.kind, rung, request.load),
                  .time = std::nullopt,
                  .accurate = true,
                  .affordable = true};
    if (const RungRecord* record = measured(request.kind, rung, request.load)) v.time = record->longest;
    if (request.tolerance) v.accurate = v.error && *v.error <= *request.tolerance;
    if (request.budget) v.affordable = v.time && *v.time <= *request.budget;
    return v;
}

bool more_accurate(const RungVerdict& a, const RungVerdict& b) {
    if (!a.error || !b.error) return a.error.has_value();
    return *a.error < *b.error;
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

std::optional<double> expected_error(QuestionKind kind, Rung rung, double load) {
    const RungRecord* record = measured(kind, rung, load);
    if (record == nullptr || record->unjudged > 0) return std::nullopt;
    return record->error;
}

RungChoice choose_rung(const RungRequest& request) {
    RungChoice choice{.rung = Rung::ellipsoid, .met = false, .ladder = {}};
    for (const Rung rung : all_rungs) choice.ladder.push_back(verdict(rung, request));
    const auto within = [](const RungVerdict& v) { return v.error && v.accurate && v.affordable; };
    const auto first = std::find_if(choice.ladder.begin(), choice.ladder.end(), within);
    if (request.tolerance && first != choice.ladder.end()) {
        choice.rung = first->rung;
        choice.met = true;
        return choice;
    }
    const RungVerdict* best = nullptr;
    for (const RungVerdict& v : choice.ladder) {
        if (v.affordable && v.error && (best == nullptr || more_accurate(v, *best))) best = &v;
    }
    if (best != nullptr) choice.rung = best->rung;
    choice.met = best != nullptr && !request.tolerance;
    return choice;
}

}  // namespace bioprint
