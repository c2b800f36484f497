#include "io/sweep.hpp"

#include <limits>

#include "bioprint/errors.hpp"
#include "io/spread_text.hpp"

namespace bioprint {
namespace {

std::vector<std::string> split_names(std::string_view text) {
    std::vector<std::string> names;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        names.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return names;
}

}  // namespace

void Sweep::add(Key key, std::string_view text, std::string_view origin) {
    const KeyInfo& info = info_of(key);
    if (!info.sweeps) return fixed_.set(key, text, origin);
    if (info.dimension && has_spread(text)) {
        if (text.find_first_of(",:") != std::string_view::npos) {
            throw UsageError(std::string(origin) +
                                 ": a list or range takes no ±; sweep another option, or call once "
                                 "for each value",
                             std::string(origin));
        }
        return fixed_.set(key, text, origin);
    }

    Axis axis{.key = key, .origin = std::string(origin), .numbers = {}, .names = {}};
    if (info.dimension) {
        axis.numbers = parse_quantity_list(text, *info.dimension, origin);
    } else {
        axis.names = split_names(text);
    }
    // Claimed in `fixed_` too, so that options which exclude each other are found whatever their number of
    // values.
    if (info.dimension) {
        fixed_.set_number(key, axis.numbers.front(), origin);
    } else {
        fixed_.set(key, axis.names.front(), origin);
    }
    if (axis.size() < 2) return;
    if (size() > std::numeric_limits<std::size_t>::max() / axis.size()) {
        throw UsageError(std::string(origin) + ": the sweep has too many rows; split it",
                         std::string(origin));
    }
    swept_.push_back(key);
    axes_.push_back(std::move(axis));
}

std::size_t Sweep::size() const {
    std::size_t rows = 1;
    for (const Axis& axis : axes_) rows *= axis.size();
    return rows;
}

Settings Sweep::swept_values(std::size_t index) const {
    Settings own;
    for (auto axis = axes_.rbegin(); axis != axes_.rend(); ++axis) {
        const std::size_t i = index % axis->size();
        index /= axis->size();
        if (axis->numbers.empty()) {
            own.set(axis->key, axis->names[i], axis->origin);
        } else {
            own.set_number(axis->key, axis->numbers[i], axis->origin);
        }
    }
    return own;
}

Settings Sweep::row(std::size_t index) const {
    return swept_values(index).over(fixed_);
}

}  // namespace bioprint
