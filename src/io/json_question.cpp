#include "io/json_question.hpp"

#include <string>

#include "bioprint/errors.hpp"
#include "bioprint/io/number_format.hpp"

namespace bioprint {
namespace {

using nlohmann::json;

/// Parts of an answer's `input` that are an outcome or a remark, so an answer can be asked again as it is.
bool is_remark(const std::string& path) {
    return path == "ink.source" || path == "cell.source" || path == "needle.name" || path == "needle.source";
}

std::string positions_text(const json& list, const std::string& path) {
    std::string text;
    for (const json& entry : list) {
        if (!text.empty()) text += ',';
        if (entry.is_number()) {
            text += format_shortest(entry.get<double>());
        } else if (entry.is_string()) {
            text += entry.get<std::string>();
        } else {
            throw UsageError(path + ": a list takes numbers and strings such as \"1.5Rc\"", path);
        }
    }
    return text;
}

void set_value(Settings& settings, Key key, const json& value, const std::string& path) {
    if (value.is_null()) return;
    if (value.is_number()) {
        settings.set_number(key, value.get<double>(), path);
    } else if (value.is_string()) {
        settings.set(key, value.get_ref<const std::string&>(), path);
    } else if (value.is_boolean() && key == Key::population) {
        settings.set(key, value.get<bool>() ? "yes" : "no", path);
    } else if (value.is_array() && (key == Key::offset || key == Key::threshold)) {
        settings.set(key, positions_text(value, path), path);
    } else {
        throw UsageError(path + ": takes a number in SI units or a string with a unit such as \"50um\"",
                         path);
    }
}

void read_object(Settings& settings, const json& object, const std::string& prefix, Problems& problems) {
    for (const auto& item : object.items()) {
        const std::string path = prefix + item.key();
        problems.collect([&] {
            if (item.value().is_object()) {
                read_object(settings, item.value(), path == "input" ? "" : path + ".", problems);
            } else if (const std::optional<Key> key = find_key(path)) {
                set_value(settings, *key, item.value(), path);
            } else if (!is_remark(path)) {
                throw UsageError(path +
                                     ": not an option; known are radius, flowrate, velocity, ink, alpha, "
                                     "cell-radius, shear-modulus and the others of --help",
                                 path);
            }
        });
    }
}

}  // namespace

Settings settings_of(const json& question) {
    if (!question.is_object()) throw UsageError("a question is a JSON object such as {\"radius\": \"50um\"}");
    Settings settings;
    Problems problems;
    read_object(settings, question, "", problems);
    problems.raise();
    return settings;
}

}  // namespace bioprint
