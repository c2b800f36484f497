#include "cli/extra_arguments.hpp"

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
        if (extra == "fit")
            message = "'fit': comes first: bioprint-predict fit FILE; see bioprint-predict fit --help";
        problems.add(message, extra);
    }
}

}  // namespace bioprint
