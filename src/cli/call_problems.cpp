#include "cli/call_problems.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "bioprint/errors.hpp"
#include "io/text.hpp"

namespace bioprint {

void add_extra_arguments(std::span<const std::string> extras, std::span<const std::string> options,
                         const std::string& help, Problems& problems) {
    const std::vector<std::string_view> names(options.begin(), options.end());
    bool behind_unknown = false;
    for (const std::string& extra : extras) {
        const bool option = extra.size() > 1 && extra.front() == '-';
        if (!option && behind_unknown) {
            behind_unknown = false;
            continue;
        }
        const std::string name = extra.substr(0, extra.find('='));
        behind_unknown = option && name == extra;
        const std::string_view near = option ? nearest(name, names) : std::string_view{};
        std::string message = in_quotes(extra) + ": " + (option ? "no such option" : "an argument too many");
        message += near.empty() ? "; see " + help : "; did you mean " + std::string(near) + "?";
        problems.add(message, extra);
    }
}

void take_last_of_repeated(CLI::App& app) {
    app.option_defaults()->take_last();
}

void add_repeated_options(const CLI::App& app, Problems& problems) {
    for (const CLI::Option* option : app.get_options()) {
        const bool one_value = option->get_items_expected_min() == 1 &&
                               option->get_items_expected_max() == 1 &&
                               option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeLast;
        if (!one_value || option->count() < 2 || option->get_lnames().empty()) continue;
        const std::string name = "--" + option->get_lnames().front();
        problems.add(name + ": given twice; give it once", name);
    }
}

void add_range_problems(const Settings& settings, Problems& problems) {
    try {
        (void)settings.make_case();
    } catch (const UsageError& e) {
        std::string_view rest = e.what();
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            const std::string_view line = rest.substr(0, end);
            rest.remove_prefix(std::min(end + 1, rest.size()));
            // "--alpha: got -1; …" is about this value alone; eta-inf is judged by eta0 unless it is negative.
            const bool own = line.starts_with("--") && line.find(": got ") != std::string_view::npos;
            const bool relative =
                line.starts_with("--eta-inf:") && line.find(": got -") == std::string_view::npos;
            if (own && !relative) problems.add(std::string(line));
        }
    } catch (const Error&) {
        // A preset file that cannot be read is told when the call is right.
    }
}

}  // namespace bioprint
