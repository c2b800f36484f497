#include "bioprint/io/presets.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <mutex>
#include <set>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/byte_source.hpp"
#include "io/preset_reader.hpp"
#include "io/preset_texts.hpp"
#include "io/text.hpp"

namespace bioprint {

namespace {

constexpr std::array<Tip, 3> tips = {Tip::steel, Tip::tapered, Tip::hypodermic};
constexpr std::array<std::string_view, 3> tip_names = {"steel", "tapered", "hypodermic"};

/// Presets of one kind, each parsed when it is first asked for.
template <typename Preset>
class Shelf {
  public:
    using Reader = Preset (*)(std::string_view json, const std::string& what);
    Shelf(std::span<const preset_texts::PresetText> texts, Reader read, std::string kind)
        : texts_(texts), read_(read), kind_(std::move(kind)), presets_(texts.size()), parsed_(texts.size()) {}

    [[nodiscard]] const std::string& kind() const { return kind_; }

    const Preset* find(std::string_view name) {
        const std::string wanted = "\n" + lower_case(trimmed(name)) + "\n";
        for (std::size_t i = 0; i < texts_.size(); ++i) {
            if (texts_[i].names.find(wanted) != std::string_view::npos) return &at(i);
        }
        return nullptr;
    }

    std::span<const Preset> all() {
        for (std::size_t i = 0; i < texts_.size(); ++i) at(i);
        return presets_;
    }

  private:
    const Preset& at(std::size_t i) {
        std::call_once(parsed_[i], [&] { presets_[i] = read_(texts_[i].json, kind_ + " preset"); });
        return presets_[i];
    }

    std::span<const preset_texts::PresetText> texts_;
    Reader read_;
    std::string kind_;
    std::vector<Preset> presets_;
    std::vector<std::once_flag> parsed_;
};

Shelf<InkPreset>& inks() {
    static Shelf<InkPreset> shelf(preset_texts::inks, read_ink_text, "ink");
    return shelf;
}

Shelf<CellPreset>& cells() {
    static Shelf<CellPreset> shelf(preset_texts::cells, read_cell_text, "cell");
    return shelf;
}

std::span<const NozzlePreset> nozzles() {
    static Shelf<NozzlePreset> shelf(preset_texts::nozzles, read_nozzle_text, "nozzle");
    return shelf.all();
}

[[noreturn]] void fail(std::string_view option, const std::string& message) {
    throw UsageError(option.empty() ? message : std::string(option) + ": " + message, std::string(option));
}

template <typename Preset>
const Preset& find(Shelf<Preset>& shelf, std::string_view name, std::string_view option) {
    if (const Preset* found = shelf.find(name)) return *found;
    std::vector<std::string_view> names;
    for (const auto& preset : shelf.all()) {
        names.push_back(preset.name);
        names.insert(names.end(), preset.aliases.begin(), preset.aliases.end());
    }
    const auto near = nearest(trimmed(name), names);
    std::string message = "got " + in_quotes(name) + ", no known " + shelf.kind();
    if (!near.empty()) message.append("; did you mean '").append(near).append("'?");
    message.append(near.empty() ? "; " : " ").append("--list ").append(shelf.kind()).append("s shows all");
    fail(option, message);
}

/// "25G", "25", "25 g", "G25".
std::optional<int> parse_gauge(std::string_view text) {
    std::string word = lower_case(trimmed(text));
    std::erase(word, ' ');
    if (word.starts_with('g')) word.erase(0, 1);
    if (word.ends_with("ga")) word.pop_back();
    if (word.ends_with('g') || word.ends_with('a')) word.pop_back();
    int gauge = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), gauge);
    if (word.empty() || error != std::errc{} || end != word.data() + word.size()) return {};
    return gauge;
}

std::string gauges_of(std::optional<Tip> tip) {
    std::set<int> gauges;
    for (const auto& nozzle : nozzles()) {
        if (!tip || nozzle.tip == *tip) gauges.insert(nozzle.gauge);
    }
    std::string text;
    for (const int gauge : gauges) text += " " + std::to_string(gauge);
    return text;
}

std::string bore(const NozzlePreset& nozzle) {
    const auto [number, unit] = format_lab(2.0 * nozzle.radius, Dimension::length);
    return number + " " + unit;
}

}  // namespace

std::span<const InkPreset> ink_presets() {
    return inks().all();
}
std::span<const CellPreset> cell_presets() {
    return cells().all();
}
std::span<const NozzlePreset> nozzle_presets() {
    return nozzles();
}

std::optional<double> InkPreset::sd(std::string_view parameter) const {
    const auto found = std::find_if(spreads.begin(), spreads.end(),
                                    [&](const ParameterSpread& spread) { return spread.name == parameter; });
    return found == spreads.end() ? std::nullopt : std::optional(found->sd);
}

const InkPreset& find_ink(std::string_view name, std::string_view option) {
    return find(inks(), name, option);
}

const CellPreset& find_cell(std::string_view name, std::string_view option) {
    return find(cells(), name, option);
}

InkPreset load_ink_file(const std::string& path) {
    constexpr std::size_t largest_file = std::size_t{1} << 20U;
    const auto source = open_bytes(path);
    InputBuffer buffer(*source);
    while (buffer.more()) {
        if (buffer.rest().size() > largest_file)
            throw UsageError(path + ": larger than 1 MiB, so it is no preset");
    }
    std::string_view text = buffer.rest();
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    return read_single_ink(text, path);
}

NozzleChoice find_nozzle(std::string_view text, std::optional<Tip> tip, std::string_view option) {
    const auto gauge = parse_gauge(text);
    if (!gauge) fail(option, "got " + in_quotes(text) + ", not a gauge; it takes one such as 25G");
    std::vector<NozzlePreset> found;
    for (const Tip candidate : tips) {
        for (const auto& nozzle : nozzles()) {
            if (nozzle.gauge == *gauge && nozzle.tip == candidate && (!tip || tip == candidate))
                found.push_back(nozzle);
        }
    }
    if (found.empty()) {
        const std::string kind = tip ? std::string(tip_name(*tip)) + " tip" : std::string("nozzle");
        fail(option, "got " + in_quotes(text) + ", of which no " + kind + " is known; there are gauges" +
                         gauges_of(tip));
    }
    return {.nozzle = found.front(), .tip_assumed = !tip, .others = {found.begin() + 1, found.end()}};
}

Tip parse_tip(std::string_view text, std::string_view option) {
    const auto word = lower_case(trimmed(text));
    for (std::size_t i = 0; i < tips.size(); ++i) {
        if (word == tip_names[i]) return tips[i];
    }
    fail(option, "got " + in_quotes(text) + "; it takes steel, tapered or hypodermic");
}

std::string_view tip_name(Tip tip) {
    return tip_names[static_cast<std::size_t>(tip)];
}

std::string describe(const NozzleChoice& choice) {
    std::string text = choice.nozzle.name + ": bore " + bore(choice.nozzle);
    if (!choice.tip_assumed) return text;
    text += "; no tip was named";
    for (std::size_t i = 0; i < choice.others.size(); ++i) {
        text += i == 0 ? ", other tips of this gauge: " : ", ";
        text.append(tip_name(choice.others[i].tip)).append(" ").append(bore(choice.others[i]));
    }
    return text;
}

}  // namespace bioprint
