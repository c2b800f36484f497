#include "cli/named_files.hpp"

#include <algorithm>
#include <filesystem>

#include "bioprint/io/number_format.hpp"
#include "io/text.hpp"

namespace bioprint {
namespace {

bool is_stream(const std::string& file) {
    return file == "-" || file.starts_with("/dev/") || file.starts_with("/proc/");
}

bool same_file(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty() || is_stream(a) || is_stream(b)) return false;
    std::error_code error;
    if (std::filesystem::equivalent(a, b, error)) return true;
    const std::filesystem::path one = std::filesystem::weakly_canonical(a, error);
    return !error && one == std::filesystem::weakly_canonical(b, error) && !error;
}

}  // namespace

void refuse_shared_files(std::span<const NamedFile> files, Problems& problems) {
    for (std::size_t j = 1; j < files.size(); ++j) {
        for (std::size_t i = 0; i < j; ++i) {
            const NamedFile& first = files[i];
            const NamedFile& second = files[j];
            if (!first.file || !second.file || (!first.written && !second.written) ||
                !same_file(*first.file, *second.file)) {
                continue;
            }
            // The one that is written has to move.
            const NamedFile& moves = second.written ? second : first;
            const NamedFile& stays = second.written ? first : second;
            problems.add(moves.option + ": would write over '" + *stays.file + "', the file of " +
                             stays.option + "; name another",
                         moves.option);
        }
    }
}

void require_ending(const NamedFile& file, std::string_view kind,
                    std::initializer_list<std::string_view> endings, Problems& problems) {
    if (!file.file || file.file->empty() || is_stream(*file.file)) return;
    const std::string name = lower_case(*file.file);
    std::string list;
    for (const std::string_view ending : endings) {
        if (name.ends_with(ending)) return;
        list += (list.empty() ? "" : " or ") + std::string(ending);
    }
    problems.add(
        file.option + ": got '" + *file.file + "'; " + std::string(kind) + " has a name that ends in " + list,
        file.option);
}

}  // namespace bioprint
