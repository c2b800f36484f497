#include "io/row_answer.hpp"

#include <algorithm>
#include <utility>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"
#include "io/answer_checks.hpp"
#include "io/answer_path.hpp"

namespace bioprint {

CsvDialect fresh_dialect() {
    return {.line_end = "\r\n"};
}

RowAnswer answer_row(const std::function<Settings()>& question, const Extras& extras,
                     const std::function<Json(const Settings&)>& answer) {
    RowAnswer row;
    try {
        const Settings settings = question();
        row.object = answer ? answer(settings) : answer_object(predict(settings.make_case()));
        add_spread(row.object, settings, extras, 1);
    } catch (...) {
        return {.object = refusal_object(current_refusal()), .refused = true, .extras = no_extras(extras)};
    }
    row.extras = add_checks(row.object, extras, false);
    return row;
}

namespace {

/// Where an answer has what a key asks; empty where it has no place for it.
std::string place_of(const KeyInfo& info) {
    if (info.key == Key::diameter) return "input.radius";
    if (info.key == Key::needle) return "input.needle.name";
    if (info.path.empty()) return {};
    const bool result =
        info.key == Key::velocity || info.key == Key::pressure_gradient || info.key == Key::pressure;
    return (result ? "nozzle." : "input.") + std::string(info.path);
}

}  // namespace

void add_question(Json& refusal, const Settings& asked) {
    for (const KeyInfo& info : key_table()) {
        std::string place = place_of(info);
        if (!asked.has(info.key) || place.empty()) continue;
        std::replace(place.begin(), place.end(), '.', '/');
        const SettingValue& value = asked.at(info.key);
        const double number = info.key == Key::diameter ? 0.5 * value.number : value.number;
        refusal[Json::json_pointer("/" + place)] = info.dimension ? Json(number) : Json(value.text);
    }
}

namespace {

/// A refusal has its error, and what it was asked where that is known; all else is no value.
const Json* value_of_row(const RowAnswer& answer, const std::string& path) {
    if (!answer.refused)
        return path == "id" && !answer.object.contains("id") ? nullptr : value_if_any(answer.object, path);
    try {
        return &value_meant(answer.object, path);
    } catch (const UsageError&) {
        return nullptr;
    }
}

/// Every row may have it, and none needs to: the name of a row, and why there is no answer.
bool is_of_few(std::string_view path) {
    return path == "id" || path == "error" || path.starts_with("error.");
}

}  // namespace

ValuesLine values_line(const RowAnswer& answer, const std::vector<std::string>& paths) {
    ValuesLine line;
    for (const std::string& path : paths) {
        if (!line.text.empty()) line.text += '\t';
        const Json* const value = value_of_row(answer, path);
        line.text += value != nullptr ? value_text(*value) : "null";
        if (!answer.refused) line.absent.push_back(value == nullptr && !is_of_few(path));
    }
    line.text += '\n';
    return line;
}

void PathTally::add(const std::vector<bool>& absent) {
    if (absent.empty()) return;
    ++rows_;
    for (std::size_t i = 0; i < absent.size(); ++i) present_[i] = present_[i] || !absent[i];
}

void PathTally::say(const Sink& notice) const {
    for (std::size_t i = 0; i < paths_.size() && rows_ > 0; ++i) {
        if (present_[i]) continue;
        std::string text = "--get: none of the rows has '" + paths_[i] + "'";
        if (needs_population(paths_[i])) text += "; add --population";
        if (paths_[i].starts_with("uncertainty.")) text += "; add --uncertainty";
        if (paths_[i].starts_with("profile.")) text += "; add --profile";
        notice(text);
    }
}

std::string value_text(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return format_shortest(value.get<double>());
    return json_text(value);
}

namespace {

bool steady_alone(const Settings& settings) {
    return settings.has(Key::model) && settings.at(Key::model).text == "steady";
}

}  // namespace

std::size_t cell_entries(const Settings& settings) {
    const bool steady = steady_alone(settings);
    if (!settings.has(Key::offset)) return steady ? 5 : 12;  // the paper's four positions
    const std::vector<CellPosition>& positions = settings.at(Key::offset).positions;
    if (!steady)
        return 3 * positions.size();  // in the nozzle steady and in time, at the exit in time; on the axis
                                      // in the nozzle once and at the exit both
    const auto centred = std::count_if(positions.begin(), positions.end(),
                                       [](const CellPosition& position) { return position.value == 0.0; });
    return positions.size() + static_cast<std::size_t>(centred);
}

namespace {

std::size_t passage_entries(const Settings& settings) {
    if (steady_alone(settings)) return 0;
    return settings.has(Key::offset) ? settings.at(Key::offset).positions.size() : 4;
}

}  // namespace

AnswerShape shape_of(const Settings& settings) {
    return {.cells = cell_entries(settings),
            .population = settings.has(Key::population),
            .passages = passage_entries(settings),
            .thresholds = settings.has(Key::threshold) ? settings.at(Key::threshold).numbers.size() : 0};
}

RowWriter::RowWriter(const RunOptions& options, const AnswerShape& shape)
    : options_(options), columns_(shape, options.extras) {}

std::string RowWriter::head() const {
    if (!options_.paths.empty()) return {};
    if (options_.format == Format::json) return "[\n";
    if (options_.format != Format::csv) return {};
    CsvWriter writer(fresh_dialect());
    for (const std::string& name : columns_.headers()) writer.add_text(name);
    writer.end_row();
    return writer.text();
}

std::string RowWriter::csv_row(const Json& answer) const {
    CsvWriter writer(fresh_dialect());
    columns_.write(answer, writer);
    writer.end_row();
    return writer.text();
}

RowText RowWriter::answer(const std::function<Settings()>& question, const Json& id) const {
    RowAnswer answer = answer_row(question, options_.extras);
    if (!id.is_null()) {
        Json named{{"id", id}};
        named.update(answer.object);
        answer.object = std::move(named);
    }
    return written(answer);
}

RowText RowWriter::written(const RowAnswer& answer) const {
    RowText row{.text = {}, .refused = answer.refused, .extras = answer.extras, .absent = {}};
    if (!options_.paths.empty()) {
        ValuesLine line = values_line(answer, options_.paths);
        row.text = std::move(line.text);
        row.absent = std::move(line.absent);
    } else if (options_.format == Format::csv) {
        row.text = csv_row(answer.object);
    } else {
        row.text = json_text(answer.object);
        if (options_.format == Format::jsonl) row.text += '\n';
    }
    return row;
}

std::string RowWriter::placed(const std::string& text, std::size_t index) const {
    const bool in_array = options_.paths.empty() && options_.format == Format::json;
    return in_array && index > 0 ? ",\n" + text : text;
}

std::string RowWriter::tail() const {
    return options_.paths.empty() && options_.format == Format::json ? "\n]\n" : std::string{};
}

}  // namespace bioprint
